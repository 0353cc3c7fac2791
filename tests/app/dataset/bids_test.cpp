// The rules of BIDS 1.10 (Motion-BIDS, beh, phenotype), one by one, on a small study. Also those that no validator
// checks: channels and columns, no header, rows, units.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "app/dataset/dataset.h"
#include "core/base/text.h"

#include "tests/app/dataset/small_study.h"
#include "tests/support/temp_folder.h"

namespace tactus::dataset {
namespace {

/// The specification's members of a motion description; the validator for Node refuses others.
const std::set<std::string> kMotionMembers = {
    "TaskName",           "TaskDescription",    "SamplingFrequency", "TrackingSystemName", "RecordingType",
    "MotionChannelCount", "TrackedPointsCount", "POSChannelCount",   "VELChannelCount",    "LATENCYChannelCount"};

using Rows = std::vector<std::vector<std::string>>;

class Bids : public testing::Test {
 protected:
  Bids() { write(smallStudy()); }

  DataSet write(const study::Study& study) {
    const auto done = writeDataSet(study, Layout::kBids, out_, 1, "tactus 9.8.7");
    EXPECT_TRUE(done) << done.error().message();
    files_ = filesBelow(out_);
    return done ? *done : DataSet{};
  }

  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(files_.at(name)); }

  /// The participant whose folder has this file, by its end.
  std::string nameEnding(const std::string& end) const {
    for (const auto& [name, bytes] : files_) {
      if (name.ends_with(end)) return name;
    }
    return {};
  }

  support::TempFolder folder_;
  std::string out_ = folder_.file("out");
  std::map<std::string, std::string> files_;
};

TEST_F(Bids, TheRootHoldsKnownNamesOnly) {
  const std::set<std::string> known = {"dataset_description.json", "README", "participants.tsv", "participants.json",
                                       "phenotype"};
  for (const auto& [name, bytes] : files_) {
    const std::string top = name.substr(0, name.find('/'));
    EXPECT_TRUE(known.contains(top) || std::regex_match(top, std::regex("sub-[A-Za-z0-9]+"))) << name;
  }
  const auto description = json("dataset_description.json");
  EXPECT_EQ(description["BIDSVersion"], "1.10.0");
  EXPECT_EQ(description["DatasetType"], "raw");
  EXPECT_EQ(description["GeneratedBy"][0]["Version"], "9.8.7");
  EXPECT_NE(description["Name"].get<std::string>().find("simulated"), std::string::npos);
  EXPECT_NE(files_.at("README").find("the data of 1 of 3 participants"), std::string::npos);
}

TEST_F(Bids, EveryFolderIsAParticipantAndEveryParticipantHasOne) {
  const Rows table = cellsOf(files_.at("participants.tsv"));
  EXPECT_EQ(table[0][0], "participant_id");
  std::set<std::string> listed;
  for (std::size_t row = 1; row < table.size(); ++row) listed.insert(table[row][0]);
  std::set<std::string> folders;
  for (const auto& [name, bytes] : files_) {
    if (name.starts_with("sub-")) folders.insert(name.substr(0, name.find('/')));
  }
  EXPECT_EQ(listed, folders);
  EXPECT_EQ(listed, (std::set<std::string>{"sub-P1", "sub-P2", "sub-P3"}));
  std::multiset<std::string> hands;
  for (std::size_t row = 1; row < table.size(); ++row) hands.insert(table[row][1]);
  EXPECT_EQ(hands, (std::multiset<std::string>{"ambidextrous", "right", "n/a"}));
  for (const std::string& column : table[0]) EXPECT_TRUE(json("participants.json").contains(column)) << column;
}

TEST_F(Bids, NamesFollowTheOrderOfTheirParts) {
  const std::regex wanted(
      "(sub-[A-Za-z0-9]+)/(motion/\\1_task-[A-Za-z0-9]+_tracksys-[A-Za-z0-9]+_acq-[A-Za-z0-9]+_run-[0-9]+_"
      "(motion\\.tsv|motion\\.json|channels\\.tsv)|beh/\\1_task-[A-Za-z0-9]+_beh\\.(tsv|json))");
  std::size_t strokes = 0;
  for (const auto& [name, bytes] : files_) {
    EXPECT_TRUE(!name.starts_with("sub-") || std::regex_match(name, wanted)) << name;
    strokes += name.ends_with("_motion.tsv") ? 1 : 0;
  }
  EXPECT_EQ(strokes, 2U);
  EXPECT_FALSE(nameEnding("_acq-slow_run-01_motion.tsv").empty());
  EXPECT_FALSE(nameEnding("_acq-veryslow_run-12_motion.tsv").empty());
}

TEST_F(Bids, MotionIsNumbersWithoutAHeaderOneColumnForEachChannel) {
  const std::set<std::string> types = {"ACCEL", "ANGACCEL", "GYRO", "JNTANG", "LATENCY",
                                       "MAGN",  "MISC",     "ORNT", "POS",    "VEL"};
  for (const auto& [name, bytes] : files_) {
    if (!name.ends_with("_motion.tsv")) continue;
    const std::string stem = name.substr(0, name.rfind('_'));
    const Rows channels = cellsOf(files_.at(stem + "_channels.tsv"));
    EXPECT_EQ(channels[0], (std::vector<std::string>{"name", "component", "type", "tracked_point", "units"}));
    const Rows rows = cellsOf(bytes);
    EXPECT_EQ(rows.size(), 4U) << name;
    for (const auto& row : rows) {
      EXPECT_EQ(row.size(), channels.size() - 1);
      for (const auto& cell : row) EXPECT_TRUE(base::parseNumber(cell)) << cell;
    }
    // The validator 1.15.0 takes the first row for names, which must differ.
    EXPECT_EQ(std::set<std::string>(rows[0].begin(), rows[0].end()).size(), rows[0].size());
    for (std::size_t i = 1; i < channels.size(); ++i) EXPECT_TRUE(types.contains(channels[i][2])) << channels[i][2];
    EXPECT_EQ(channels[1][4], "s");
    EXPECT_EQ(channels[2][4], "mm");
    EXPECT_EQ(channels[3][4], "mm/s");
    const auto described = json(stem + "_motion.json");
    EXPECT_EQ(described["MotionChannelCount"], channels.size() - 1);
    EXPECT_EQ(described["TaskName"], "insertion");
    EXPECT_EQ(described["TrackingSystemName"], "stylus");
    for (const auto& [key, value] : described.items()) EXPECT_TRUE(kMotionMembers.contains(key)) << key;
    EXPECT_EQ(described["TaskDescription"].get<std::string>().find("Simulated"), std::string::npos);
  }
  // Steps of 1 ms and of 10 ms; the first sample is at 0 s, 0 mm and 0 mm/s.
  EXPECT_EQ(json(nameEnding("_acq-slow_run-01_motion.json"))["SamplingFrequency"], 1000);
  EXPECT_EQ(json(nameEnding("_acq-veryslow_run-12_motion.json"))["SamplingFrequency"], 100);
  EXPECT_TRUE(json(nameEnding("_acq-veryslow_run-12_motion.json"))["TaskDescription"].get<std::string>().ends_with(
      "asked for: very slow"));
  const Rows slow = cellsOf(files_.at(nameEnding("_acq-slow_run-01_motion.tsv")));
  EXPECT_EQ(slow[0], (std::vector<std::string>{"0", "0.0", "0.00"}));
  EXPECT_EQ(slow[3], (std::vector<std::string>{"0.003", "0.75", "750"}));
}

TEST_F(Bids, AStrokeOfOneSampleIsLeftOutAndSaid) {
  auto study = smallStudy();
  study.speeds.push_back({"quiet", "fast", 1, 0, 0, 300});
  const auto done = write(study);
  ASSERT_EQ(done.notes.size(), 1U);
  EXPECT_TRUE(done.notes[0].starts_with("1 stroke is left out")) << done.notes[0];
  EXPECT_TRUE(nameEnding("_acq-fast_run-01_motion.tsv").empty());
}

TEST_F(Bids, JudgementsAndRulesAreDescribedTables) {
  const std::string judged = "sub-P" + std::string(1, nameEnding("_acq-slow_run-01_motion.tsv").at(5));
  const std::string path = judged + "/beh/" + judged + "_task-judgement_beh";
  EXPECT_EQ(cellsOf(files_.at(path + ".tsv")), (Rows{{"series", "step", "force_n", "term"},
                                                     {"ascending", "1", "0.05", "not_felt"},
                                                     {"ascending", "2", "0.4", "medium"},
                                                     {"ascending", "3", "0.9", "n/a"}}));
  const auto sidecar = json(path + ".json");
  EXPECT_EQ(sidecar["force_n"]["Units"], "N");
  EXPECT_EQ(sidecar["TaskName"], "judgement");
  for (const char* term : {"very_small", "small", "medium", "large", "very_large", "not_felt", "beyond_practice"}) {
    EXPECT_TRUE(sidecar["term"]["Levels"].contains(term)) << term;
  }
  const std::string rules = nameEnding("_task-rules_beh.tsv");
  EXPECT_EQ(cellsOf(files_.at(rules)),
            (Rows{{"form", "lubrication", "neck_flexion", "depth", "speed", "then", "weight"},
                  {"ngt-a2-printed", "n/a", "n/a", "stomach", "fast", "large", "0.5"}}));
  EXPECT_EQ(json(nameEnding("_task-rules_beh.json"))["Simulated"], true);
}

TEST_F(Bids, AnswersAreOneRowForEachParticipantWithAColumnForEachItem) {
  const Rows table = cellsOf(files_.at("phenotype/force_rules.tsv"));
  EXPECT_EQ(table[0], (std::vector<std::string>{"participant_id", "q01", "q12"}));
  std::set<std::string> participants;
  std::multiset<std::pair<std::string, std::string>> answers;
  for (std::size_t row = 1; row < table.size(); ++row) {
    participants.insert(table[row][0]);
    answers.insert({table[row][1], table[row][2]});
  }
  EXPECT_EQ(participants, (std::set<std::string>{"sub-P1", "sub-P2", "sub-P3"}));  // those of the folders
  EXPECT_EQ(answers, (std::multiset<std::pair<std::string, std::string>>{
                         {"large", "cant_tell"}, {"n/a", "n/a"}, {"n/a", "n/a"}}));
  const auto sidecar = json("phenotype/force_rules.json");
  EXPECT_FALSE(sidecar["MeasurementToolMetadata"]["Description"].get<std::string>().empty());
  for (const std::string& column : table[0]) EXPECT_TRUE(sidecar.contains(column)) << column;
  EXPECT_TRUE(sidecar["q12"]["Levels"].contains("cant_tell"));
  EXPECT_TRUE(sidecar["q01"]["Levels"].contains("large"));
}

TEST_F(Bids, TwoFormsOfOneNameHaveTwoTables) {
  auto study = smallStudy();
  study.answers.push_back({"quiet", "own form", 1, "3", study::Answer::Status::kAnswered});
  study.answers.push_back({"quiet", "own-form", 1, "4", study::Answer::Status::kAnswered});
  write(study);
  EXPECT_NE(files_.at("phenotype/own_form.tsv").find("\t3\n"), std::string::npos);
  EXPECT_NE(files_.at("phenotype/own_form_other.tsv").find("\t4\n"), std::string::npos);
}

}  // namespace
}  // namespace tactus::dataset
