#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/csv.h"
#include "core/model_io/model_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class Simulate : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(model_io::writeModel(support::s4FiveRegions(), model_).has_value());
    writeText(scenario_, R"({ "format": "tactus-scenario", "version": 1,
        "conditions": { "lubrication": 1, "neck_flexion": 45 },
        "motion": [ { "do": "rest", "duration_s": 1 }, { "do": "strokes" } ],
        "events": [ { "at_s": 2, "model": "other.tactus.json" } ] })");
    ASSERT_TRUE(model_io::writeModel(support::s4FiveRegions(), folder_.file("other.tactus.json")).has_value());
  }

  support::TempFolder folder_;
  std::string model_ = folder_.file("s4.tactus.json");
  std::string scenario_ = folder_.file("scenario.json");
  std::string trace_ = folder_.file("trace.csv");
};

TEST_F(Simulate, WritesATraceThatSaysItIsSimulatedAndPrintsWhatCameOut) {
  const ProgramRun run({"simulate", model_, "--scenario", scenario_, "--out", trace_, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json.at("simulated"), true);
  EXPECT_EQ(json.at("ticks"), 3000);
  EXPECT_EQ(json.at("strokes"), 1);
  EXPECT_EQ(json.at("trips").size(), 0u);
  const auto& inference = json.at("inference");
  EXPECT_EQ(
      inference.at("asked").get<int>() + inference.at("released").get<int>() + inference.at("unchanged").get<int>(),
      3000);

  const auto trace = base::CsvTable::read(trace_);
  ASSERT_TRUE(trace) << trace.error().message();
  ASSERT_EQ(trace->rowCount(), 3000u);
  EXPECT_EQ(trace->cell(0, *trace->find("time_s")), "0");
  EXPECT_EQ(trace->cell(2999, *trace->find("time_s")), "2.999");
  EXPECT_EQ(trace->cell(1234, *trace->find("simulated")), "1");
  EXPECT_EQ(trace->cell(1234, *trace->find("neck_flexion")), "45");
  EXPECT_EQ(trace->number(2999, *trace->find("depth_mm")), json.at("depth_mm").get<double>());
}

TEST_F(Simulate, TheSameFilesGiveTheSameBytes) {
  ASSERT_EQ(ProgramRun({"simulate", model_, "--scenario", scenario_, "--out", trace_}).status, 0);
  const std::string again = folder_.file("again.csv");
  ASSERT_EQ(ProgramRun({"simulate", model_, "--scenario", scenario_, "--out", again}).status, 0);
  EXPECT_EQ(readText(trace_), readText(again));
}

TEST_F(Simulate, AWrongScenarioIsOneSentenceAndNoTrace) {
  writeText(scenario_, R"({ "format": "tactus-scenario", "version": 1, "motion": [ { "do": "fly" } ] })");
  const ProgramRun run({"simulate", model_, "--scenario", scenario_, "--out", trace_});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.find("tactus: " + scenario_ + ": /motion/0/do: found the string 'fly', wanted one of rest"), 0u)
      << run.err;
  EXPECT_FALSE(base::CsvTable::read(trace_));

  writeText(scenario_, R"({ "format": "tactus-scenario", "version": 1, "conditions": { "lubrication": 1 },
      "motion": [ { "do": "rest", "duration_s": 1 } ] })");
  const ProgramRun few({"simulate", model_, "--scenario", scenario_, "--out", trace_});
  EXPECT_EQ(few.status, 1);
  EXPECT_NE(few.err.find("neck_flexion"), std::string::npos) << few.err;
}

TEST_F(Simulate, NeverWritesOverItsInputs) {
  const std::string before = readText(scenario_);
  const ProgramRun run({"simulate", model_, "--scenario", scenario_, "--out", scenario_});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.err, "tactus: --out: found '" + scenario_ + "', wanted another file than the model and the scenario\n");
  EXPECT_EQ(readText(scenario_), before);
}

TEST_F(Simulate, WarnsOfConditionsThatTheModelClamps) {
  writeText(scenario_,
            R"({ "format": "tactus-scenario", "version": 1, "conditions": { "lubrication": 80, "neck_flexion": 45 },
      "motion": [ { "do": "rest", "duration_s": 1 } ] })");
  const ProgramRun run({"simulate", model_, "--scenario", scenario_, "--out", trace_});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.err.find("/conditions/lubrication: 80 is outside the model's universe [0, 1]"), std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace tactus::cli
