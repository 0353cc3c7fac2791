#include "core/study/csv_tables.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/core/study/study_folder.h"

namespace tactus::study {
namespace {

constexpr std::string_view kParticipants =
    "participant,years_experience,category,handedness,weight,simulated\n"
    "P1,12.5,expert,right,2,0\n"
    "P2,,,,,true\n";

Study smallStudy() {
  Study study;
  study.participants = {{"P1", 12.5, "expert", "right", 2.0, false},
                        {"P2", std::nullopt, "", "left, mostly", 0.0, true}};
  study.speeds = {
      {"P1", "slow", 1, 0, 0, 0}, {"P1", "slow", 1, 0.001, 0.1, 1.0 / 3}, {"P2", "fast", 2, 0.5, -1, -3e-9}};
  using Kind = ForceJudgement::Kind;
  study.judgements = {{"P1", "ascending", 1, 0.1, Kind::kTerm, "very_small"},
                      {"P1", "ascending", 2, 0.2, Kind::kNotFelt, ""},
                      {"P1", "", 3, 0.3, Kind::kBeyondPractice, ""},
                      {"P2", "ascending", 1, 0.1, Kind::kNoAnswer, ""}};
  using Status = Answer::Status;
  study.answers = {{"P1", "f", 1, "large", Status::kAnswered},
                   {"P1", "f", 2, "", Status::kSkipped},
                   {"P1", "g", 1, "", Status::kCantTell},
                   {"P2", "f", 1, "", Status::kCleared}};
  study.rules = {{"P2", "r", {{"lubrication", "well"}, {"depth", "esophagus"}}, "medium", 0.25},
                 {"P2", "", {{"speed", "fast"}}, "large", 1}};
  return study;
}

const std::vector<std::string> kInputs = {"lubrication", "neck_flexion", "depth", "speed"};

TEST(StudyFolders, WhatIsWrittenIsReadBack) {
  const StudyFolder folder;
  Study study = smallStudy();
  ASSERT_TRUE(writeStudyFolder(study, kInputs, folder.path("trial"))) << "writing failed";
  const auto read = readStudyFolder(folder.path("trial"), kInputs);
  ASSERT_TRUE(read) << read.error().message();
  study.name = "trial";
  EXPECT_EQ(read->study, study);
  EXPECT_TRUE(read->notes.empty());
}

TEST(StudyFolders, WritingLeavesNothingOfAnOlderStudy) {
  const StudyFolder folder;
  ASSERT_TRUE(writeStudyFolder(smallStudy(), kInputs, folder.path()));
  Study empty;
  ASSERT_TRUE(writeStudyFolder(empty, kInputs, folder.path()));
  const auto read = readStudyFolder(folder.path());
  ASSERT_TRUE(read) << read.error().message();
  empty.name = read->study.name;
  EXPECT_EQ(read->study, empty);
}

TEST(StudyFolders, RuleOnAnInputWithoutColumnIsNotWritten) {
  const StudyFolder folder;
  const auto written = writeStudyFolder(smallStudy(), {"lubrication", "depth"}, folder.path("out"));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message().find("'speed'"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

TEST(StudyFolders, TakesTheFoldersName) {
  const StudyFolder folder;
  ASSERT_TRUE(writeStudyFolder(smallStudy(), kInputs, folder.path("pilot")));
  EXPECT_EQ(readStudyFolder(folder.path("pilot/"))->study.name, "pilot");
}

TEST(StudyFolders, OnlyParticipantsMustBeThere) {
  const StudyFolder folder;
  folder.write("participants.csv", kParticipants);
  const auto read = readStudyFolder(folder.path());
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->study.participants.size(), 2U);
  EXPECT_EQ(read->notes,
            std::vector<std::string>{
                "Absent tables, which count as empty: speeds.csv, judgements.csv, answers.csv, rules.csv."});
  for (const char* table : {"speeds.csv", "judgements.csv"}) {
    folder.write(table, "participant,level,series,stroke,step,time_s,depth_mm,speed_mm_s,force_n,term\n");
  }
  folder.write("answers.csv", "participant,form,item,term,status\n");
  EXPECT_EQ(readStudyFolder(folder.path())->notes.front(), "Absent table, which counts as empty: rules.csv.");
}

TEST(StudyFolders, RecordsKnowTheirLine) {
  const StudyFolder folder;
  folder.write("participants.csv", "# above the header\n" + std::string(kParticipants));
  folder.write("speeds.csv",
               "participant,level,stroke,time_s,depth_mm,speed_mm_s\n\nP1,slow,1,0,0,1\nP1,slow,1,1,1,1\n");
  folder.write("judgements.csv", "participant,series,step,force_n,term\nP1,ascending,1,.5,medium\n");
  folder.write("answers.csv", "participant,form,item,term,status\nP1,f,1,\"large\",answered\n\n\nP1,f,2,,skipped\n");
  folder.write("rules.csv", "participant,speed,then,weight,comment\nP1,fast,large,,\"two\nlines\"\nP1,slow,small,,\n");
  const auto read = readStudyFolder(folder.path(), {"speed"});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->study.participants[1].line.number, 4U);
  EXPECT_EQ(read->study.speeds[0].line.number, 3U);
  EXPECT_EQ(read->study.speeds[1].line.number, 4U);
  EXPECT_EQ(read->study.judgements[0].line.number, 2U);
  EXPECT_EQ(read->study.answers[1].line.number, 5U);
  EXPECT_EQ(read->study.rules[0].line.number, 2U);
  EXPECT_EQ(read->study.rules[1].line.number, 4U);
}

TEST(TableLines, ErrorsNameTheTableOnlyForRecordsOfOne) {
  const base::Error error{base::ErrorCode::kValue, {}, "rule 1", "weight 2", "less"};
  EXPECT_EQ(atCell(error, {kRulesTable, {}, "weight"}, "'2'").value().message(), "rule 1: found weight 2, wanted less");
  const auto at_cell = atCell(error, {kRulesTable, {7}, "weight"}, "'2'").value();
  EXPECT_EQ(at_cell.message(), "rules.csv: line 7, column 'weight': found '2', wanted less");
  EXPECT_EQ(inStudyFolder(at_cell, "st/x/").value().file, "st/x/rules.csv");
  EXPECT_EQ(inStudyFolder(error, "st/x").value().file, "st/x");
  EXPECT_EQ(inTable(error, kRulesTable, {7}).value().file, "rules.csv");
  EXPECT_EQ(inTable(error, kRulesTable, {}).value().file, "");
}

TEST(StudyFolders, UnknownColumnsAreIgnoredAndListed) {
  const StudyFolder folder;
  folder.write("participants.csv", kParticipants);
  folder.write("judgements.csv", "mood,participant,series,step,force_n,term\r\ngood,P1,ascending,1,.5,medium\r\n");
  folder.write("rules.csv", "participant,comment,depth,speed,then,weight\nP1,sure,,fast,large,\n");
  const auto read = readStudyFolder(folder.path(), {"depth", "speed"});
  ASSERT_TRUE(read) << read.error().message();
  const auto has = [&read](const std::string& note) {
    return std::find(read->notes.begin(), read->notes.end(), note) != read->notes.end();
  };
  EXPECT_TRUE(has("judgements.csv: the column 'mood' is ignored."));
  EXPECT_TRUE(has("rules.csv: the column 'comment' is ignored."));
  EXPECT_EQ(read->study.judgements.front().force_n, 0.5);
  EXPECT_EQ(read->study.rules.front(), (GivenRule{"P1", "", {{"speed", "fast"}}, "large", 1}));
}

TEST(StudyFolders, ReadsBooleansEmptyCellsSpacesAndByteOrderMark) {
  const StudyFolder folder;
  folder.write("participants.csv",
               "\xEF\xBB\xBFparticipant,years_experience,category,handedness,weight,simulated\n"
               " A ,,,,,\nB,3,,,,0\nC,,,,,False\nD,,,,1.5,1\nE,,,,,TRUE\n");
  const auto read = readStudyFolder(folder.path());
  ASSERT_TRUE(read) << read.error().message();
  const auto& people = read->study.participants;
  ASSERT_EQ(people.size(), 5U);
  EXPECT_EQ(people[0], (Participant{"A", std::nullopt, "", "", std::nullopt, false}));
  EXPECT_EQ(people[1].years_experience, 3);
  EXPECT_FALSE(people[1].simulated);
  EXPECT_FALSE(people[2].simulated);
  EXPECT_EQ(people[3].weight, 1.5);
  EXPECT_TRUE(people[3].simulated);
  EXPECT_TRUE(people[4].simulated);
}

TEST(StudyTables, EveryFurtherColumnOfRulesIsAnInputWhereNoneAreNamed) {
  const auto table = base::CsvTable::parse("participant,angle,then,weight\nP1,steep,large,0\n", "rules.csv");
  ASSERT_TRUE(table);
  const auto rules = readRules(*table);
  ASSERT_TRUE(rules) << rules.error().message();
  EXPECT_EQ(rules->front(), (GivenRule{"P1", "", {{"angle", "steep"}}, "large", 0}));
}

}  // namespace
}  // namespace tactus::study
