// `rebase` on the command line: its numbers are those of app/editing, here its words, its JSON, its file and refusals.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/editing/edit.h"
#include "app/editing/membership_edits.h"
#include "app/editing/rule_edits.h"
#include "core/model_io/model_file.h"
#include "elicitation/model/model_provenance.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

class RebaseCommandTest : public testing::Test {
 protected:
  RebaseCommandTest() {
    fuzzy::ForceModel base = support::s4FiveRegions();
    base.provenance = fuzzy::Provenance{"A study", {}, {}, "Simulated."};
    EXPECT_TRUE(elicitation::setChecks(base));
    fuzzy::ForceModel tuned = editing::setConsequent(base, "S4", 3, "very_large")->model;
    tuned = editing::moveVertex(tuned, {{"depth", ""}, "esophagus", 3}, 600)->model;
    EXPECT_TRUE(elicitation::setChecks(tuned));
    fuzzy::ForceModel target = base;
    target.experts[0].rules[3].then = "very_small";
    target = editing::moveVertex(target, {{"depth", ""}, "esophagus", 3}, 600)->model;
    EXPECT_TRUE(elicitation::setChecks(target));
    EXPECT_TRUE(model_io::writeModel(base, base_));
    EXPECT_TRUE(model_io::writeModel(tuned, tuned_));
    EXPECT_TRUE(model_io::writeModel(target, new_));
  }

  support::TempFolder folder_;
  std::string base_ = folder_.file("base.tactus.json");
  std::string tuned_ = folder_.file("tuned.tactus.json");
  std::string new_ = folder_.file("new.tactus.json");
  std::string out_ = folder_.file("out.tactus.json");
};

TEST_F(RebaseCommandTest, NamesEachEditWithItsPriceOrWhyNot) {
  const ProgramRun run({"rebase", base_, tuned_, new_, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto found = nlohmann::json::parse(run.out);
  ASSERT_EQ(found["edits"].size(), 2);
  const auto& vertex = found["edits"][0];
  EXPECT_EQ(vertex["outcome"], "already so");
  EXPECT_EQ(vertex["carried"], false);
  EXPECT_FALSE(vertex.contains("largest_n"));
  const auto& word = found["edits"][1];
  EXPECT_EQ(word["outcome"], "conflict");
  EXPECT_EQ(word["carried"], true);
  EXPECT_NE(word["note"].get<std::string>().find("The new model has"), std::string::npos);
  EXPECT_GT(word["largest_n"], 0);
  EXPECT_GT(word["noticeable"], 0);
  EXPECT_EQ(word["at"].size(), 4);
  EXPECT_EQ(found["together"]["largest_n"], word["largest_n"]);
}

TEST_F(RebaseCommandTest, WritesTheNewModelWithTheEdits) {
  const ProgramRun run({"rebase", base_, tuned_, new_, "-o", out_});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.out.find("1 of 2 edits carried over"), std::string::npos) << run.out;
  const auto made = model_io::readModel(out_);
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_EQ(made->model.experts[0].rules[3].then, "very_large");
  EXPECT_NE(made->model.provenance->notes.find("Simulated. Carried over: S4: IF"), std::string::npos);
  // Nothing else differs from the tuned version here.
  const ProgramRun same({"diff", tuned_, out_});
  EXPECT_NE(same.out.find("no term, rule or setting differs"), std::string::npos) << same.out;
}

TEST_F(RebaseCommandTest, TakesTheChosenEditsAlone) {
  fuzzy::ForceModel base = model_io::readModel(base_)->model;
  fuzzy::ForceModel tuned = editing::setConsequent(base, "S4", 5, "very_large")->model;
  tuned = editing::setConsequent(tuned, "S4", 8, "very_large")->model;
  EXPECT_TRUE(elicitation::setChecks(tuned));
  ASSERT_TRUE(model_io::writeModel(tuned, tuned_));
  const ProgramRun run({"rebase", base_, tuned_, new_, "--only", "2", "-o", out_});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto made = model_io::readModel(out_)->model;
  EXPECT_EQ(made.experts[0].rules[5].then, base.experts[0].rules[5].then);
  EXPECT_EQ(made.experts[0].rules[8].then, "very_large");
}

TEST_F(RebaseCommandTest, RefusesWhatItCannotCarryOver) {
  const auto expectRefused = [](std::vector<std::string> arguments, const std::string& says) {
    const ProgramRun run(std::move(arguments));
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
  };
  expectRefused({"rebase", base_, tuned_, new_, "--only", "3"}, "a number from 1 to 2");
  expectRefused({"rebase", base_, tuned_, new_, "--only", "1"}, "an edit that applies");
  expectRefused({"rebase", base_, tuned_, new_, "-o", new_}, "new.tactus.json");
  fuzzy::ForceModel other = support::s4FiveRegions();
  for (fuzzy::Rule& rule : other.experts[0].rules) {
    std::erase_if(rule.conditions, [](const auto& condition) { return condition.input == "speed"; });
  }
  std::erase_if(other.experts[0].rules, [](const auto& rule) { return rule.conditions.empty(); });
  other.inputs.pop_back();
  ASSERT_TRUE(model_io::writeModel(other, tuned_));
  expectRefused({"rebase", base_, tuned_, new_}, "tuned.tactus.json: variables");
}

TEST_F(RebaseCommandTest, SaysThatThereIsNothing) {
  const ProgramRun run({"rebase", base_, base_, new_});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "The tuned version has no edit that can be carried over.\n");
}

}  // namespace
}  // namespace tactus::cli
