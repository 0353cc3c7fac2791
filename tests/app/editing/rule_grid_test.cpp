#include "app/editing/rule_grid.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/editing/edit_history.h"
#include "app/editing/rule_edits.h"
#include "app/session/study_source.h"
#include "core/base/random.h"
#include "elicitation/model/model_builder.h"
#include "questionnaires/form_file.h"
#include "questionnaires/published_rules.h"

#include "tests/app/editing/sample_models.h"
#include "tests/support/default_procedure.h"

namespace tactus::editing {
namespace {

using fuzzy::ForceModel;

study::Study studyOfS4() {
  study::Study study;
  study.name = "S4";
  study::Participant s4;
  s4.code = "S4";
  study.participants = {s4};
  return study;
}

ForceModel built(const study::Study& study) {
  elicitation::BuildSettings settings;
  settings.created_utc = "2026-11-21T08:00:00Z";
  const auto model = elicitation::buildModel(study, session::knownForms(support::defaultProcedure()), settings);
  EXPECT_TRUE(model.has_value()) << (model ? "" : model.error().message());
  return model->model;
}

/// S4's answers to the form, which asks about the five regions that the shifted reading of Table A2 means.
ForceModel fromAnswers() {
  auto study = studyOfS4();
  const auto given = questionnaires::s4Rules("ngt-a2-shifted").value();
  for (const auto& item : support::ngtForceForm().items) {
    const auto rule =
        std::find_if(given.begin(), given.end(), [&](const auto& one) { return one.conditions == item.conditions; });
    EXPECT_NE(rule, given.end()) << item.text;
    study.answers.push_back({"S4", "ngt-force-v1", item.number, rule->then, study::Answer::Status::kAnswered});
  }
  return built(study);
}

ForceModel emptied(ForceModel model) {
  model.experts[0].rules.clear();
  const auto compiled = fuzzy::compile(model);
  refreshChecks(model, *compiled);
  return model;
}

/// One click for each cell that `rules` are about.
std::vector<std::pair<CellPlace, GridId>> cellsOf(const std::vector<fuzzy::Rule>& rules) {
  std::vector<std::pair<CellPlace, GridId>> out;
  for (const auto& rule : rules) {
    const bool depth_first = rule.conditions[0].input == "depth";
    const auto& condition = rule.conditions[depth_first ? 1 : 0];
    const auto& region = rule.conditions[depth_first ? 0 : 1];
    out.push_back({{condition.term, region.term}, {"S4", condition.input, "depth"}});
  }
  return out;
}

TEST(RuleGrid, S4sRulesByClicksAreThoseOfTheQuestionnaire) {
  const ForceModel wanted = fromAnswers();
  ASSERT_EQ(wanted.experts[0].rules.size(), 45);
  const ForceModel empty = emptied(wanted);
  base::Random random(7);
  for (int round = 0; round < 3; ++round) {
    auto history = EditHistory::open(empty, "empty", {}, study::RecordIds(1)).value();
    const auto cells = cellsOf(wanted.experts[0].rules);
    std::vector<std::size_t> order(cells.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    // The first round clicks in the order of the form, the others in any.
    for (std::size_t k = order.size() - 1; round > 0 && k > 0; --k) {
      std::swap(order[k], order[static_cast<std::size_t>(random.below(static_cast<int>(k) + 1))]);
    }
    for (const std::size_t k : order) {
      const auto& [cell, grid] = cells[k];
      ASSERT_TRUE(history.apply(must(setAnswer(history.model(), grid, cell, wanted.experts[0].rules[k].then)), {}));
    }
    EXPECT_TRUE(sameBits(history.model(), wanted)) << "round " << round;
    while (history.canUndo()) ASSERT_TRUE(history.undo({}));
    EXPECT_TRUE(sameBits(history.model(), empty));
  }
}

TEST(RuleGrid, TheDefaultReadingOfTableA2ByClicksGivesTheSameForces) {
  auto study = studyOfS4();
  study.rules = questionnaires::s4Rules().value();
  for (auto& rule : study.rules) rule.participant = "S4";
  const ForceModel wanted = built(study);
  ForceModel model = emptied(wanted);
  const auto cells = cellsOf(wanted.experts[0].rules);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    model = must(setAnswer(model, cells[k].second, cells[k].first, wanted.experts[0].rules[k].then)).model;
  }
  // The table begins with lubrication well, the form with poor: the same rules in another order.
  EXPECT_TRUE(std::is_permutation(wanted.experts[0].rules.begin(), wanted.experts[0].rules.end(),
                                  model.experts[0].rules.begin(), model.experts[0].rules.end()));
  const auto compiled = fuzzy::compile(model).value();
  for (const auto& check : wanted.checks) EXPECT_EQ(compiled.evaluate(check.in).force_n, check.force);
}

TEST(RuleGrid, ShowsTheAnswers) {
  const auto model = support::s4AsPrinted();
  const auto grids = gridsOf(model, "S4", "depth");
  ASSERT_EQ(grids.size(), 3);
  EXPECT_EQ(grids[2].condition, "speed");
  const auto grid = ruleGrid(model, grids[0]).value();
  EXPECT_EQ(grid.rows, (std::vector<std::string>{"poor", "medium", "well"}));
  ASSERT_EQ(grid.columns.size(), 6);
  EXPECT_EQ(grid.at(2, 4).then, "medium");  // well and esophagus
  EXPECT_EQ(grid.at(2, 4).rule, 3);
  EXPECT_FALSE(grid.at(2, 2).rule);  // Table A2 has no oropharynx
  EXPECT_FALSE(ruleGrid(model, {"S4", "depth", "depth"}));
  EXPECT_FALSE(ruleGrid(model, {"S4", "force", "depth"}));
  EXPECT_FALSE(ruleGrid(model, {"S9", "speed", "depth"}));
}

TEST(RuleGrid, AnAnswerIsChangedTakenAwayAndGivenAgain) {
  const auto model = support::s4AsPrinted();
  const GridId grid{"S4", "lubrication", "depth"};
  const CellPlace cell{"well", "esophagus"};
  const auto changed = must(setAnswer(model, grid, cell, "large"));
  EXPECT_EQ(changed.label, "S4: IF Tube lubrication is well AND Depth is esophagus: medium to large");
  EXPECT_EQ(changed.model.experts[0].rules[3].then, "large");
  const auto none = must(setAnswer(model, grid, cell, std::nullopt));
  EXPECT_EQ(none.model.experts[0].rules.size(), 44);
  EXPECT_EQ(none.label, "S4: IF Tube lubrication is well AND Depth is esophagus: medium to no answer");
  const std::vector<std::size_t> fourth = {3};
  const auto off = must(enableRules(model, "S4", fourth, false)).model;
  const auto again = must(setAnswer(off, grid, cell, "medium"));
  EXPECT_EQ(again.label, "S4: IF Tube lubrication is well AND Depth is esophagus: medium, counts again");
  EXPECT_EQ(again.model, model);
  refusal(setAnswer(model, grid, cell, "huge"));
  refusal(setAnswer(model, grid, {"well", "elbow"}, "small"));
}

TEST(RuleGrid, ACellWithAConflictKeepsOneRule) {
  const auto model = support::s4AsPrinted();
  const fuzzy::Rule other{{{"depth", "esophagus"}, {"lubrication", "well"}}, "small"};
  const auto both = must(addRule(model, "S4", other)).model;
  const GridId grid{"S4", "lubrication", "depth"};
  EXPECT_TRUE(ruleGrid(both, grid)->at(2, 4).conflict);
  const auto settled = must(setAnswer(both, grid, {"well", "esophagus"}, "large")).model;
  EXPECT_EQ(settled.experts[0].rules.size(), 45);
  const auto kept = must(setAnswer(both, grid, {"well", "esophagus"}, "medium"));
  EXPECT_EQ(kept.label, "S4: IF Tube lubrication is well AND Depth is esophagus: medium, alone");
  EXPECT_EQ(kept.model, model);
  EXPECT_FALSE(ruleGrid(settled, grid)->at(2, 4).conflict);
}

}  // namespace
}  // namespace tactus::editing
