// A study as German, Chinese and English spreadsheets save it gives the model that the plain tables give.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>

#include "core/model_io/model_file.h"
#include "core/study/csv_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

namespace fs = std::filesystem;

std::string replacedAll(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// As a German spreadsheet: semicolons, decimal commas, CRLF.
std::string german(const std::string& csv) {
  return replacedAll(replacedAll(replacedAll(csv, ",", ";"), ".", ","), "\n", "\r\n");
}

std::string utf16(const std::string& ascii) {
  std::string out = "\xFF\xFE";
  for (const char c : ascii) out += std::string({c, '\0'});
  return out;
}

class SpreadsheetTables : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(study_);
    const auto study = support::tableStudy(3);
    ASSERT_TRUE(study::writeStudyFolder(study, support::ngtInputIds(), study_).has_value());
    plain_ = modelOf(build());
  }

  ProgramRun build() const { return ProgramRun({"build", study_, "--out", out_, "--replicates", "0"}); }
  /// What the model says, without its time and the provenance.
  std::string modelOf(const ProgramRun& run) const {
    EXPECT_EQ(run.status, 0) << run.err;
    auto read = model_io::readModel(out_);
    EXPECT_TRUE(read.has_value());
    if (!read) return {};
    read->model.created_utc.clear();
    read->model.provenance.reset();
    return model_io::formatModel(read->model);
  }
  void change(const std::string& table, const std::function<std::string(const std::string&)>& spoil) const {
    writeText(study_ + '/' + table, spoil(readText(study_ + '/' + table)));
  }
  void changeAll(const std::function<std::string(const std::string&)>& spoil) const {
    for (const char* table : {"participants.csv", "speeds.csv", "judgements.csv", "answers.csv", "rules.csv"})
      change(table, spoil);
  }
  void expectSameModel(const std::string& says) const {
    const ProgramRun run = build();
    EXPECT_EQ(modelOf(run), plain_);
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
  }

  support::TempFolder folder_;
  std::string study_ = folder_.file("study");
  std::string out_ = folder_.file("m.tactus.json");
  std::string plain_;
};

TEST_F(SpreadsheetTables, German) {
  changeAll(german);
  expectSameModel("warning: speeds.csv: read with semicolons between the cells, decimal commas.");
}

TEST_F(SpreadsheetTables, UnicodeTextWithTabs) {
  changeAll([](const std::string& csv) { return utf16(replacedAll(replacedAll(csv, ",", "\t"), "\n", "\r\n")); });
  for (const char* table : {"participants", "speeds", "judgements", "answers", "rules"})
    fs::rename(study_ + '/' + table + ".csv", study_ + '/' + table + ".txt");
  expectSameModel("warning: speeds.csv: read from 'speeds.txt'.");
}

TEST_F(SpreadsheetTables, Windows1252AndGb18030) {
  change("participants.csv", [](const std::string& csv) {
    return replacedAll(csv, "expert",
                       "Fachkr\xE4"
                       "fte");
  });
  EXPECT_NE(build().err.find("participants.csv: read with text in Windows-1252."), std::string::npos);
  change("participants.csv", [](const std::string& csv) {
    return replacedAll(csv,
                       "Fachkr\xE4"
                       "fte",
                       "\xD7\xA8\xBC\xD2");
  });
  EXPECT_NE(build().err.find("participants.csv: read with text in GB 18030."), std::string::npos);
}

TEST_F(SpreadsheetTables, HeadersWordsAndEmptyCellsAsPeopleWriteThem) {
  change("speeds.csv", [](const std::string& csv) {
    std::string text = replacedAll(csv, "participant,level,stroke,time_s,depth_mm,speed_mm_s",
                                   "\"Participant\",Level,Stroke,Time [s],Depth (mm),Speed [mm/s],,");
    return replacedAll(replacedAll(replacedAll(text, ",slow,", ",Slow,"), "\nN", ",,\nN"), ",,,,", ",,") +
           ",,,,,,,\n,,,,,,,\n";
  });
  change("judgements.csv", [](const std::string& csv) {
    return replacedAll(replacedAll(csv, "very_small", "Very small"), "beyond_practice", "beyond practice");
  });
  change("answers.csv",
         [](const std::string& csv) { return replacedAll(csv, "very_large,answered", "VERY LARGE,Answered"); });
  expectSameModel("speeds.csv: reads the columns 'Participant' as participant, ");
  const std::string err = build().err;
  EXPECT_NE(err.find("speeds.csv: 'Slow' is read as slow in "), std::string::npos) << err;
  EXPECT_NE(err.find("judgements.csv: 'beyond practice' is read as beyond_practice in "), std::string::npos) << err;
}

TEST_F(SpreadsheetTables, OptionalColumnsMayBeMissing) {
  change("participants.csv", [](const std::string&) { return std::string("participant\nN1\nN2\nN3\nN4\nN5\nN6\n"); });
  change("answers.csv",
         [](const std::string& csv) { return replacedAll(replacedAll(csv, ",status", ""), ",answered", ""); });
  expectSameModel(
      "answers.csv: without the columns status (an item with a term counts as answered, others as skipped).");
  EXPECT_NE(build().err.find("simulated (the data count as given by persons)"), std::string::npos);
}

TEST_F(SpreadsheetTables, WhatIsNotPlainIsRefusedWithTheRemedy) {
  const auto speeds = readText(study_ + "/speeds.csv");
  const auto expect = [&](const std::string& table, const std::string& text, const std::string& says) {
    const auto before = readText(study_ + '/' + table);
    writeText(study_ + '/' + table, text);
    const ProgramRun run = build();
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
    writeText(study_ + '/' + table, before);
  };
  const std::string header = "participant,level,stroke,time_s,depth_mm,speed_mm_s\n";
  expect("speeds.csv", header + "N1,slow,1,0,0,\"1,234\"\n",
         "found '1,234', wanted a finite number with a decimal point");
  expect("speeds.csv", header + "N1,slow,1,0,0,46,5\n", "(decimal commas? then semicolons between the cells)");
  expect("speeds.csv", replacedAll(speeds, "speed_mm_s", "Speed [cm/s]"), "wanted a column 'speed_mm_s'");
  expect("speeds.csv", replacedAll(speeds, "N2,", "n-02,"),
         "found 'n-02', wanted a participant of participants.csv: 'N2'?");
  expect("speeds.csv", replacedAll(speeds, ",medium,", ",meduim,"),
         "found 'meduim', wanted one of slow, medium, fast (medium?)");
  fs::remove(study_ + "/participants.csv");
  writeText(study_ + "/Study.XLSX", "PK");
  EXPECT_NE(build().err.find("wanted a folder with participants.csv: save each sheet as CSV"), std::string::npos);
}

TEST_F(SpreadsheetTables, SingleTablesAreReadTheSameWay) {
  const ProgramRun plain({"vote", study_ + "/judgements.csv"});
  change("judgements.csv", [](const std::string& csv) { return german(replacedAll(csv, "very_small", "very small")); });
  const ProgramRun vote({"vote", study_ + "/judgements.csv"});
  EXPECT_EQ(vote.out, plain.out);
  EXPECT_NE(vote.err.find("judgements.csv: read with semicolons between the cells, decimal commas"), std::string::npos);
  EXPECT_NE(vote.err.find("'very small' is read as very_small"), std::string::npos) << vote.err;
  EXPECT_EQ(ProgramRun({"agreement", study_ + "/judgements.csv"}).status, 0);
}

}  // namespace
}  // namespace tactus::cli
