#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/tables/csv.h"
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

/// The trace is what the summary is counted against: ticks of 1 ms, and beginnings.
TEST_F(Simulate, SaysWhichLimitsActedHowOftenAndHowLong) {
  writeText(scenario_, R"({ "format": "tactus-scenario", "version": 1,
      "conditions": { "lubrication": 1, "neck_flexion": 45 }, "device": { "max_force_n": 0.2 },
      "motion": [ { "do": "rest", "duration_s": 1 }, { "do": "strokes" } ],
      "events": [ { "at_s": 2.5, "fault": "warm_motors", "duration_s": 0.1 } ] })");
  const ProgramRun run({"simulate", model_, "--scenario", scenario_, "--out", trace_, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto trace = base::CsvTable::read(trace_);
  ASSERT_TRUE(trace) << trace.error().message();
  const auto column = *trace->find("limited");
  std::map<std::string, std::pair<int, double>> seen;
  for (std::size_t row = 0; row < trace->rowCount(); ++row) {
    const auto namesIn = [&](std::size_t at) {
      std::set<std::string> names;
      std::istringstream parts{std::string(trace->cell(at, column))};
      for (std::string name; std::getline(parts, name, '+');) names.insert(name);
      return names;
    };
    const auto before = row > 0 ? namesIn(row - 1) : std::set<std::string>();
    for (const auto& name : namesIn(row)) {
      seen[name].first += before.count(name) == 0 ? 1 : 0;
      seen[name].second += 1;
    }
  }
  EXPECT_EQ(seen.erase("release"), 1u);
  EXPECT_TRUE(seen.count("fade_in") == 1 && seen.count("trip") == 1);
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json.at("limits").size(), seen.size());
  for (const auto& limit : json.at("limits")) {
    const auto& [times, ticks] = seen.at(limit.at("limit").get<std::string>());
    EXPECT_EQ(limit.at("times"), times);
    EXPECT_DOUBLE_EQ(limit.at("seconds").get<double>(), ticks / 1000);
  }
  EXPECT_EQ(json.at("trips").at(0).at("sentence"), "the motors are too warm");

  const ProgramRun text({"simulate", model_, "--scenario", scenario_, "--out", trace_});
  EXPECT_NE(text.out.find("  limits that acted: "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("fade_in "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("trip: at 2.5 s: the motors are too warm\n"), std::string::npos) << text.out;
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
  EXPECT_EQ(run.err.find("tactus: " + scenario_ + ": /motion/0/do: found the string 'fly', wanted 'rest', '"), 0u)
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
  EXPECT_EQ(run.err, "tactus: " + scenario_ + ": --out: found a file that the command reads, wanted another file\n");
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
