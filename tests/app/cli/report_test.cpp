// `tactus report`: the page of a study file or a folder of tables, with the options of `build`.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/tables/csv.h"
#include "core/study/csv_tables.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class Report : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(study::writeStudyFolder(study_, support::ngtInputIds(), tables_)); }

  support::TempFolder folder_;
  study::Study study_ = support::tableStudy(1, {.nurses = 2, .rows_per_s = 60});
  std::string tables_ = folder_.file("tables");
  std::string out_ = folder_.file("R.html");
};

TEST_F(Report, WritesThePageAndTakesTheOptionsOfBuild) {
  const ProgramRun run(
      {"report", tables_, "--out", out_, "--alpha", "0.8", "--force-terms", "frequency", "--replicates", "20"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, out_ + ": report of 2 participants, 2 experts\n");
  const std::string page = readText(out_);
  EXPECT_NE(page.find("<td>Core ends at membership α</td><td>0.8</td>"), std::string::npos);
  EXPECT_NE(page.find("<td>From</td><td>frequency</td>"), std::string::npos);
}

TEST_F(Report, OfAStudyWithoutAnswersSaysSoWhereBuildRefuses) {
  std::filesystem::remove(tables_ + "/answers.csv");
  std::filesystem::remove(tables_ + "/rules.csv");
  EXPECT_EQ(ProgramRun({"build", tables_, "--out", folder_.file("m.tactus.json")}).status, 1);
  const ProgramRun run({"report", tables_, "--out", out_, "--replicates", "0", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("\"experts\": 0"), std::string::npos) << run.out;
  EXPECT_NE(readText(out_).find("There are no answers and no rules."), std::string::npos);
}

TEST_F(Report, AMistakeWritesNothing) {
  const ProgramRun run({"report", folder_.file("absent.tactus"), "--out", out_});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.err.find("absent.tactus"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(out_));
  EXPECT_EQ(ProgramRun({"report", tables_}).status, 2);
}

TEST_F(Report, StudyCompareSaysWhichChoicesMatter) {
  const ProgramRun text({"study", "compare", tables_});
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("alpha, now 0.95"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("atter here: "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("not possible: "), std::string::npos) << "the tables hold no categories";
  const ProgramRun run({"study", "compare", tables_, "--json", "--alpha", "0.9"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("experts"), 2);
  EXPECT_EQ(json.at("points"), 4096);
  std::set<std::string> alphas;
  for (const auto& one : json.at("variants")) {
    if (one.at("factor") == "alpha") alphas.insert(one.at("value"));
    if (!one.at("available").get<bool>()) continue;
    EXPECT_GE(one.at("largest_n").get<double>(), one.at("rms_n").get<double>());
  }
  for (const auto& one : json.at("factors")) EXPECT_NE(one.at("sentence"), "") << one.at("factor");
  EXPECT_EQ(alphas, (std::set<std::string>{"0.8", "0.95", "1"})) << "all but the one that is set";
  EXPECT_EQ(ProgramRun({"study", "compare", folder_.file("absent")}).status, 1);
}

TEST_F(Report, StudyBandsSayWhoseWordsAndWhoseRules) {
  const std::string out = folder_.file("bands.csv");
  const ProgramRun text({"study", "bands", tables_, "--replicates", "20", "--out", out});
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("whose words, whose rules"), std::string::npos) << text.out;
  EXPECT_NE(unwrapped(text.out).find("The two do not add up."), std::string::npos) << text.out;
  const auto table = base::CsvTable::read(out);
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_EQ(table->rowCount(), 121U);
  for (const char* column : {"depth_mm", "force_n", "again_low_n", "others_high_n", "next_low_n", "words_high_n"})
    EXPECT_TRUE(table->find(column)) << column;

  const ProgramRun run({"study", "bands", tables_, "--replicates", "0", "--at", "speed=100", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("at").at("speed"), 100);
  EXPECT_EQ(json.at("at").at("neck_flexion"), 60);
  for (const auto& band : json.at("bands"))
    EXPECT_EQ(band.at("available"), band.at("band") == "next" || band.at("band") == "words") << band.at("band");
  std::size_t seen = 0;
  for (const auto& point : json.at("points")) {
    double low = 1e9, high = -1e9, sum = 0, count = 0;
    for (const auto& force : point.at("own_words_n")) {
      if (force.is_null()) continue;
      low = std::min(low, force.get<double>());
      high = std::max(high, force.get<double>());
      sum += force.get<double>();
      ++count;
    }
    if (count == 0) continue;
    ++seen;
    EXPECT_EQ(point.at("words_low_n"), low);
    EXPECT_EQ(point.at("words_high_n"), high);
    EXPECT_NEAR(point.at("own_words_mean_n").get<double>(), sum / count, 1e-12);
  }
  EXPECT_GT(seen, 0U);
  EXPECT_FALSE(json.at("word_intervals").empty());
  EXPECT_NE(json.at("words_and_rules").at("sentence"), "");

  const ProgramRun along({"study", "bands", tables_, "--at", "depth=100"});
  EXPECT_EQ(along.status, 1);
  EXPECT_NE(along.err.find("--at"), std::string::npos) << along.err;
  EXPECT_NE(ProgramRun({"study", "bands", tables_, "--at", "sped=100"}).err.find("speed"), std::string::npos);
}

}  // namespace
}  // namespace tactus::cli
