// `duel` on the command line: its numbers are those of experiments, here its options, its JSON and its refusals.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/tables/csv.h"
#include "core/model_io/model_file.h"
#include "core/store/duel_records.h"
#include "core/store/entries.h"
#include "core/store/sessions.h"
#include "experiments/duel_run.h"

#include "tests/app/cli/run_program.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

Json jsonOf(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const ProgramRun run(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  return Json::parse(run.out);
}

TEST(DuelPlanCommand, SaysTrialsAndCriticalCount) {
  const Json plan = jsonOf({"duel", "plan", "--jnd", "1", "--power", "0.8"});
  EXPECT_EQ(plan["trials"], 23);
  EXPECT_EQ(plan["critical"], 16);
  EXPECT_EQ(plan["catch_trials"], 2);
  EXPECT_NEAR(plan["share_right"].get<double>(), 0.75, 1e-12);
  EXPECT_EQ(plan["abx"]["trials"], 188);
  EXPECT_NEAR(plan["sequential"]["right_step"].get<double>(), .405465, 5e-7);
  const ProgramRun text({"duel", "plan", "--jnd", "1"});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("23 trials; 16 right"), std::string::npos) << text.out;
}

TEST(DuelPlanCommand, ComparesTwoModelsAlongAStroke) {
  const support::TempFolder folder;
  const std::string a = folder.file("a.tactus.json");
  const std::string b = folder.file("b.tactus.json");
  fuzzy::ForceModel model = support::s4FiveRegions();
  ASSERT_TRUE(model_io::writeModel(model, a));
  model.experts[0].rules[2].then = "large";
  ASSERT_TRUE(model_io::writeModel(model, b));
  const std::vector<std::string> stroke = {"--at", "lubrication=1,neck_flexion=60,speed=5", "--from", "190", "--to",
                                           "210"};
  std::vector<std::string> arguments = {"duel", "plan", a, b};
  arguments.insert(arguments.end(), stroke.begin(), stroke.end());
  const Json plan = jsonOf(arguments);
  EXPECT_NEAR(plan["stroke"]["largest_jnd"].get<double>(), 1.2393, 5e-5);  // as in noticeable_force_test.cpp
  EXPECT_EQ(plan["jnd"], plan["stroke"]["rms_jnd"]);
  EXPECT_GT(plan["trials"], 23);

  // The same model twice: no number of trials finds it.
  arguments[3] = a;
  const ProgramRun same(arguments);
  EXPECT_EQ(same.status, 0);
  EXPECT_NE(same.err.find("it is not felt"), std::string::npos) << same.err;

  EXPECT_EQ(ProgramRun({"duel", "plan", a, b}).status, 2) << "without a stroke";
  EXPECT_EQ(ProgramRun({"duel", "plan"}).status, 2);
  EXPECT_EQ(ProgramRun({"duel", "plan", "--jnd", "0"}).status, 2);
  EXPECT_EQ(ProgramRun({"duel"}).status, 2);
  const ProgramRun far({"duel", "plan", "--jnd", "0.01"});
  EXPECT_EQ(far.status, 1);
  EXPECT_NE(far.err.find("5000 trials"), std::string::npos) << far.err;
}

TEST(DuelSimulateCommand, AgreesWithTheExactChances) {
  for (const char* rule : {"fixed", "sequential"}) {
    const Json runs = jsonOf({"duel", "simulate", "--rule", rule, "--trials", "23", "--jnd", "1", "--runs", "2000"});
    EXPECT_TRUE(runs["simulated"]);
    EXPECT_NEAR(runs["found"].get<double>(), runs["exact"].get<double>(), 0.04) << rule;  // four standard errors
  }
  const Json none = jsonOf({"duel", "simulate", "--order-bias", "0.5", "--runs", "2000"});
  EXPECT_TRUE(none["exact"].is_null());
  EXPECT_LE(none["found"].get<double>(), 0.07);
  const Json own = jsonOf({"duel", "simulate", "--rule", "own-jnd", "--trials", "40", "--runs", "100"});
  EXPECT_GT(own["within_25_percent"].get<double>(), 0.5);
}

class DuelResultsCommand : public testing::Test {
 protected:
  /// Stores `answers` of a duel as simulated persons give them.
  void keep(int trials, std::size_t left_out) {
    study::SessionRecord session = records_.session(study_.person.id);
    session.kind = study::SessionKind::kUsability;
    ASSERT_TRUE(store::append(study_.file, session));
    study::DuelStart start;
    start.entry = records_.entry(session.id);
    start.setting.simulated = true;
    start.a.name = "before";
    start.b.name = "after";
    start.to_mm = 60;
    start.speed_mm_s = 60;
    start.trials = trials;
    start.seed = 5;
    ASSERT_TRUE(store::append(study_.file, start));
    auto answers = experiments::simulatedAnswers(start, {3}, 1);
    answers.resize(answers.size() - left_out);
    for (auto& answer : answers) {
      answer.entry = records_.entry(session.id);
      ASSERT_TRUE(store::append(study_.file, answer));
    }
  }

  support::TempFolder folder_;
  store::SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  store::OpenStudy study_ = store::makeStudy(path_, records_);
};

TEST_F(DuelResultsCommand, GivesVerdictsAndTrials) {
  keep(18, 0);
  keep(18, 1);
  ASSERT_TRUE(study_.file.close());
  const std::string csv = folder_.file("trials.csv");
  const Json results = jsonOf({"duel", "results", path_, "--out", csv});
  ASSERT_EQ(results["duels"].size(), 2U);
  EXPECT_EQ(results["duels"][0]["outcome"], "differ");
  EXPECT_EQ(results["duels"][0]["critical"], 13);
  const std::string sentence = results["duels"][0]["sentence"];
  EXPECT_NE(sentence.find("'after' is felt as heavier"), std::string::npos);
  // Of the other one nothing is said that tells who leads.
  EXPECT_EQ(results["duels"][1]["outcome"], "unfinished");
  EXPECT_EQ(results["duels"][1]["trials"], 17);
  EXPECT_FALSE(results["duels"][1].contains("right"));
  const auto table = base::CsvTable::read(csv);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rowCount(), 20U);  // 18 pairs, two catch trials

  const ProgramRun text({"duel", "results", path_});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("Not finished"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("(simulated)"), std::string::npos);
  EXPECT_EQ(ProgramRun({"duel", "results", path_, "--out", path_}).status, 1);
}

TEST_F(DuelResultsCommand, AStudyWithoutAny) {
  ASSERT_TRUE(study_.file.close());
  const ProgramRun run({"duel", "results", path_});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "No blind comparison in this study.\n");
  EXPECT_EQ(ProgramRun({"duel", "results", folder_.file("none.tactus")}).status, 1);
}

}  // namespace
}  // namespace tactus::cli
