#include "app/editing/term_edits.h"

#include <gtest/gtest.h>

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Points = std::vector<double>;

class TermEdits : public testing::Test {
 protected:
  static std::size_t rulesWith(const fuzzy::ForceModel& model, const std::string& term, std::size_t expert = 0) {
    std::size_t count = 0;
    for (const auto& rule : model.experts[expert].rules) {
      for (const auto& condition : rule.conditions) count += condition.term == term ? 1 : 0;
    }
    return count;
  }

  /// S4 and a copy of S4 called S5.
  static fuzzy::ForceModel twoExperts() {
    auto model = support::s4AsPrinted();
    model.experts.push_back(model.experts[0]);
    model.experts[1].id = model.experts[1].label = "S5";
    return model;
  }

  const fuzzy::ForceModel model_ = support::s4AsPrinted();
};

TEST_F(TermEdits, ANewTermStandsInOrder) {
  const auto& depth = model_.inputs[2];
  const auto term = suggestedTerm(depth, depth.terms, 300);
  EXPECT_EQ(term.points, (Points{255, 285, 315, 345}));
  const auto edit = must(addTerm(model_, kDepth, term));
  ASSERT_EQ(edit.model.inputs[2].terms.size(), 7);
  EXPECT_EQ(edit.model.inputs[2].terms[4].id, "new_term");  // the middle of the esophagus is 317.5
  EXPECT_EQ(suggestedTerm(depth, edit.model.inputs[2].terms, 300).id, "new_term_2");
  refusal(addTerm(edit.model, kDepth, term));
  refusal(addTerm(model_, kDepth, {"x", "X", fuzzy::Shape::kTrapezoid, {1, 2}}));
}

TEST_F(TermEdits, RulesFollowANewName) {
  const auto edit = must(renameTerm(model_, {kDepth, "nasopharynx"}, "epipharynx", "Epipharynx"));
  EXPECT_EQ(rulesWith(edit.model, "nasopharynx"), 0);
  EXPECT_EQ(rulesWith(edit.model, "epipharynx"), 9);
  EXPECT_EQ(edit.label, "Depth / nasopharynx: renamed to Epipharynx");
  const auto word = must(renameTerm(model_, {kForce, "medium"}, "middling", "Middling"));
  EXPECT_EQ(std::count_if(word.model.experts[0].rules.begin(), word.model.experts[0].rules.end(),
                          [](const auto& rule) { return rule.then == "middling"; }),
            12);  // Table A2 has M twelve times
  // `medium` is also a term of lubrication, neck flexion and speed.
  EXPECT_EQ(rulesWith(word.model, "medium"), 15);
  refusal(renameTerm(model_, {kDepth, "nasopharynx"}, "oropharynx", "X"));
  refusal(renameTerm(model_, {kDepth, "nasopharynx"}, "", "X"));
}

TEST_F(TermEdits, ATermInUseIsRemovedOnlyWithItsRules) {
  EXPECT_EQ(refusal(removeTerm(model_, {kDepth, "nasopharynx"}, {})),
            "Depth / nasopharynx: found 9 rules of S4 with this term, wanted none, or that they are removed too");
  const auto edit = must(removeTerm(model_, {kDepth, "nasopharynx"}, {RulesOfTerm::kRemove, true}));
  EXPECT_EQ(edit.model.experts[0].rules.size(), 36);
  EXPECT_EQ(edit.label, "Depth / nasopharynx: removed, with 9 rules of S4");
  // The core 80 to 105 has its middle at 92.5, both ramps are 20 wide.
  EXPECT_EQ(pointsOf(edit.model, "depth", "nasal_cavity"), (Points{0, 0, 82.5, 102.5}));
  EXPECT_EQ(pointsOf(edit.model, "depth", "oropharynx"), (Points{82.5, 102.5, 138, 162}));
  const auto end = must(removeTerm(model_, {kDepth, "stomach"}, {RulesOfTerm::kRemove, true}));
  EXPECT_EQ(pointsOf(end.model, "depth", "esophagus"), (Points{185, 215, 600, 600}));
  EXPECT_TRUE(partitionOrder(end.model.inputs[2], end.model.inputs[2].terms));
}

TEST_F(TermEdits, APunctureFollowsItsTerm) {
  auto model = model_;
  model.events = {{"oropharynx", 0.5}, {"nasopharynx", 0.25}};
  using Events = std::vector<fuzzy::TubeEvent>;
  EXPECT_EQ(must(renameTerm(model, {kDepth, "nasopharynx"}, "epipharynx", "Epipharynx")).model.events,
            (Events{{"oropharynx", 0.5}, {"epipharynx", 0.25}}));
  const auto removed = must(removeTerm(model, {kDepth, "nasopharynx"}, {RulesOfTerm::kRemove, false}));
  EXPECT_EQ(removed.model.events, (Events{{"oropharynx", 0.5}}));
  EXPECT_TRUE(removed.label.ends_with(", with its puncture")) << removed.label;
  // A word of the same name of another input, and an expert's own list, have no puncture.
  EXPECT_EQ(must(renameTerm(model, {{"lubrication", ""}, "medium"}, "oropharynx", "X")).model.events, model.events);
  const auto own = must(makeOwn(model, {"depth", "S4"}));
  EXPECT_EQ(must(renameTerm(own.model, {{"depth", "S4"}, "nasopharynx"}, "x", "X")).model.events, model.events);
  // The place is the end of the core, which the last part keeps.
  SplitOptions split;
  split.cuts = {100};
  const auto parts = must(splitTerm(model, {kDepth, "nasopharynx"}, split)).model;
  EXPECT_EQ(parts.events, (Events{{"oropharynx", 0.5}, {"nasopharynx_2", 0.25}}));
  EXPECT_EQ(fuzzy::endOfCore(parts.inputs[2], *fuzzy::findTerm(parts.inputs[2].terms, "nasopharynx_2")),
            fuzzy::endOfCore(model.inputs[2], *fuzzy::findTerm(model.inputs[2].terms, "nasopharynx")));
}

TEST_F(TermEdits, TheLastTermStays) {
  auto model = model_;
  model.inputs[0].terms.resize(1);
  model.experts[0].rules.clear();
  refusal(removeTerm(model, {{"lubrication", ""}, "poor"}, {}));
}

TEST_F(TermEdits, AnOwnListIsEditedForOneExpertAlone) {
  const auto model = twoExperts();
  const TermListId own{"depth", "S5"};
  const auto made = must(makeOwn(model, own));
  EXPECT_EQ(made.label, "S5, Depth: own terms");
  EXPECT_EQ(made.model.experts[1].overrides.at(0).terms, model.inputs[2].terms);
  refusal(makeOwn(made.model, own));
  const auto renamed = must(renameTerm(made.model, {own, "nasopharynx"}, "epipharynx", "E")).model;
  EXPECT_EQ(rulesWith(renamed, "epipharynx", 0), 0);
  EXPECT_EQ(rulesWith(renamed, "epipharynx", 1), 9);
  EXPECT_EQ(renamed.inputs, model.inputs);
  // The shared list does not concern S5 any more.
  const auto shared = must(removeTerm(renamed, {kDepth, "nasopharynx"}, {RulesOfTerm::kRemove, false})).model;
  EXPECT_EQ(shared.experts[0].rules.size(), 36);
  EXPECT_EQ(shared.experts[1].rules.size(), 45);
}

TEST_F(TermEdits, BackToTheSharedListRulesMayBeLost) {
  const TermListId own{"depth", "S5"};
  const auto made = must(makeOwn(twoExperts(), own)).model;
  EXPECT_EQ(must(backToShared(made, own, RulesOfTerm::kRefuse)).model, twoExperts());
  const auto renamed = must(renameTerm(made, {own, "nasopharynx"}, "epipharynx", "E")).model;
  refusal(backToShared(renamed, own, RulesOfTerm::kRefuse));
  const auto back = must(backToShared(renamed, own, RulesOfTerm::kRemove));
  EXPECT_EQ(back.model.experts[1].rules.size(), 36);
  EXPECT_TRUE(back.model.experts[1].overrides.empty());
  refusal(backToShared(made, kDepth, RulesOfTerm::kRemove));
}

}  // namespace
}  // namespace tactus::editing
