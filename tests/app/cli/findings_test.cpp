// What `tactus build` and `tactus check` say of the rules: short for people, complete as JSON.
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/cli/findings_text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "questionnaires/form_file.h"

#include "tests/app/cli/run_program.h"
#include "tests/support/default_procedure.h"
#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

class Findings : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(study_);
    writeText(study_ + "/participants.csv",
              "participant,years_experience,category,handedness,weight,simulated\nA,12,,,,\nB,4,,,,\n");
    std::string answers = "participant,form,item,term,status\n";
    for (const char* who : {"A", "B"}) {
      for (const auto& item : support::ngtForceForm().items) {
        answers += std::string(who) + ",ngt-force-v1," + std::to_string(item.number);
        const bool skipped = *who == 'B' && item.number <= 10;
        answers += skipped ? ",,skipped\n" : *who == 'A' ? ",small,answered\n" : ",large,answered\n";
      }
    }
    writeText(study_ + "/answers.csv", answers);
  }

  ProgramRun build(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"build", study_, "--out", out_});
    return ProgramRun(more);
  }

  support::TempFolder folder_;
  std::string study_ = folder_.file("study");
  std::string out_ = folder_.file("m.tactus.json");
};

TEST_F(Findings, BuildListsAFewOfEachKind) {
  const ProgramRun run = build();
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string text = unwrapped(run.out);
  EXPECT_NE(text.find("missing_item: 10 B: no rule for depth is nasal_cavity and lubrication is poor: item 1 "
                      "(answers.csv, line 47), skipped ("),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("\n    and 6 more, see --json\n"), std::string::npos) << run.out;
  EXPECT_NE(text.find(" A gives 0.350 N by item "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\n  experts_apart: "), std::string::npos) << run.out;
}

TEST_F(Findings, BuildHasAllOfThemAndTheModelUnderEachWeightAsJson) {
  const ProgramRun run = build({"--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json result = Json::parse(run.out);
  const auto model = model_io::readModel(out_);
  ASSERT_TRUE(model);
  const auto compiled = fuzzy::compile(model->model).value();
  int missing = 0;
  for (const auto& finding : result.at("findings")) {
    if (finding.at("kind") == "missing_item") {
      ++missing;
      EXPECT_EQ(finding.at("expert"), "B");
      EXPECT_EQ(finding.at("sources").at(0).at("form"), "ngt-force-v1");
      EXPECT_LE(finding.at("sources").at(0).at("item"), 10);
      EXPECT_GT(finding.at("sources").at(0).at("line"), 46);
    }
    if (finding.at("kind") == "experts_apart") {
      EXPECT_EQ(finding.at("experts"), Json({"A", "B"}));
      const auto at = finding.at("from").get<std::vector<double>>();
      // The file holds the shortest numbers that read back, so the forces are the same.
      EXPECT_NEAR(finding.at("newtons"),
                  compiled.evaluateExpert(1, at).force_n - compiled.evaluateExpert(0, at).force_n, 1e-12);
    }
  }
  EXPECT_EQ(missing, 10);

  const auto& weights = result.at("weights");
  ASSERT_EQ(weights.size(), 4U);
  EXPECT_EQ(weights.at(0).at("policy"), "equal");
  EXPECT_EQ(weights.at(0).at("largest_n"), 0);
  EXPECT_EQ(weights.at(1).at("weights"), Json({12, 4}));
  // small .35 N and large .7 N, each symmetric: (12 · .35 + 4 · .7)/16 = .4375 N against .525 N.
  EXPECT_NEAR(weights.at(1).at("largest_n"), 0.0875, 1e-12);
  EXPECT_EQ(weights.at(2).at("available"), false);
  EXPECT_NE(weights.at(2).at("reason").get<std::string>().find("column 'category'"), std::string::npos);
}

TEST_F(Findings, ATableOfWeightsIsComparedToo) {
  const std::string table = folder_.file("w.csv");
  writeText(table, "participant,weight\nA,0\nB,1\n");
  const ProgramRun run = build({"--weights", table, "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json result = Json::parse(run.out);
  const auto& last = result.at("weights").back();
  EXPECT_EQ(last.at("policy"), "file");
  EXPECT_EQ(last.at("table"), table);
  EXPECT_NEAR(last.at("largest_n"), 0.175, 1e-12);
  EXPECT_EQ(result.at("notes").front().get<std::string>().find("There are no insertion speeds"), 0U);
}

TEST(FindingsOfAModel, CheckKnowsTheDeclarationsOfTheKnownInputs) {
  const support::TempFolder folder;
  const std::string file = folder.file("s4.tactus.json");
  auto model = support::s4AsPrinted();
  ASSERT_TRUE(model_io::writeModel(model, file).has_value());
  const ProgramRun run({"check", file});
  ASSERT_EQ(run.status, 0) << run.err;
  // Table A2: large flexion gives more force than medium in the laryngopharynx, the esophagus and the stomach.
  for (const char* region : {"laryngopharynx", "esophagus", "stomach"}) {
    EXPECT_NE(unwrapped(run.out).find(std::string("S4: against the declared direction: neck_flexion from medium to "
                                                  "large where depth is ") +
                                      region),
              std::string::npos)
        << run.out;
  }
  // Poor lubrication is three levels above medium in the nasal cavity, the nasopharynx and the laryngopharynx.
  const ProgramRun as_json({"check", file, "--json"});
  const Json result = Json::parse(as_json.out);
  int jumps = 0;
  for (const auto& finding : result.at("findings")) jumps += finding.at("kind") == "level_jump" ? 1 : 0;
  EXPECT_EQ(jumps, 3);

  // Of inputs with other names nothing is declared.
  model.inputs[1].id = "angle";
  for (auto& rule : model.experts[0].rules) {
    for (auto& condition : rule.conditions) {
      if (condition.input == "neck_flexion") condition.input = "angle";
    }
  }
  ASSERT_TRUE(model_io::writeModel(model, file).has_value());
  EXPECT_EQ(ProgramRun({"check", file}).out.find("against_declaration"), std::string::npos);
}

TEST(FindingsText, AFewOfAKindUnderTheirKind) {
  using elicitation::RuleFinding;
  RuleFinding finding;
  finding.kind = RuleFinding::Kind::kConflict;
  finding.experts = {"A"};
  finding.text = "two rules";
  finding.newtons = 0.25;
  EXPECT_EQ(findingsAsText(std::vector(4, finding), "N"),
            "  conflict: 4\n    A: two rules (0.250 N)\n    A: two rules (0.250 N)\n"
            "    A: two rules (0.250 N)\n    A: two rules (0.250 N)\n");
  const std::string many = findingsAsText(std::vector(9, finding), "N");
  EXPECT_NE(many.find("\n    and 5 more, see --json\n"), std::string::npos) << many;
  finding.at_least = true;
  finding.experts.clear();
  EXPECT_EQ(findingsAsText(std::vector(1, finding), "N"), "  conflict: 1\n    mean: two rules (0.250 N or more)\n");
  EXPECT_EQ(findingsAsText({}, "N"), "");
}

}  // namespace
}  // namespace tactus::cli
