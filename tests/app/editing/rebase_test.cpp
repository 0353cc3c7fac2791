#include "app/editing/rebase.h"

#include <gtest/gtest.h>
#include <numeric>

#include "app/editing/history_versions.h"
#include "app/editing/rule_edits.h"
#include "app/editing/term_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using fuzzy::ForceModel;
using Outcome = CarriedEdit::Outcome;

/// Two experts with the rules of S4, as a build leaves them.
ForceModel built(const std::string& when = "2026-11-21T08:00:00Z") {
  ForceModel model = support::s4AsPrinted();
  model.experts.push_back(model.experts[0]);
  model.experts[1].id = "S5";
  model.experts[1].label = "S5";
  model.created_utc = when;
  model.generator = "tactus";
  return model;
}

SharedModel shared(ForceModel model) { return ready(std::move(model)).value(); }

Rebase rebased(const ForceModel& base, const ForceModel& tuned, const ForceModel& target,
               std::span<const VertexPlace> locked = {}) {
  auto out = rebase(base, tuned, shared(target), locked);
  EXPECT_TRUE(out) << out.error().message();
  return std::move(*out);
}

std::vector<std::size_t> every(const Rebase& rebase) {
  std::vector<std::size_t> out(rebase.edits.size());
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

ForceModel allOf(const Rebase& rebase) { return must(carryOver(rebase, every(rebase))).model; }

/// Edits of each kind, as the bench makes them.
ForceModel tunedModel(ForceModel model) {
  const auto edit = [&model](base::Result<Edit> made) { model = must(std::move(made)).model; };
  edit(setConsequent(model, "S4", 3, "large"));
  edit(setRuleWeight(model, "S4", 3, 0.5));
  edit(setConsequent(model, "S5", 7, "small"));
  const std::size_t last = 44;
  edit(removeRules(model, "S5", std::span(&last, 1)));
  edit(moveVertex(model, {kDepth, "nasopharynx", 3}, 132, {true, {}}));
  edit(setExpertWeight(model, "S5", 0.25));
  edit(renameTerm(model, {{"speed", ""}, "slow"}, "gentle", "Gentle"));
  edit(makeOwn(model, {"force", "S5"}));
  edit(moveVertex(model, {{"force", "S5"}, "small", 1}, 0.3));
  model.default_force_n = 0.125;
  model.implication = fuzzy::Implication::kScale;
  return model;
}

const CarriedEdit& editOf(const Rebase& rebase, const std::string& what) {
  for (const CarriedEdit& edit : rebase.edits) {
    if (edit.what.find(what) != std::string::npos) return edit;
  }
  ADD_FAILURE() << "no edit of " << what;
  static const CarriedEdit kNone;
  return kNone;
}

TEST(Rebase, OntoTheBaseGivesTheTunedModel) {
  const ForceModel base = built();
  const ForceModel tuned = tunedModel(base);
  const Rebase found = rebased(base, tuned, base);
  for (const CarriedEdit& edit : found.edits) {
    EXPECT_EQ(edit.outcome, Outcome::kApplies) << edit.what << ": " << edit.note;
    EXPECT_FALSE(edit.what.empty());
    EXPECT_NE(edit.before, edit.after) << edit.what;
  }
  EXPECT_TRUE(sameBits(allOf(found), tuned));
}

TEST(Rebase, PuncturesAreCarriedWithTheirTerms) {
  ForceModel base = built();
  base.events = {{"nasopharynx", 0.5}, {"oropharynx", 0.25}, {"stomach", 0.75}};
  ForceModel tuned = must(renameTerm(base, {kDepth, "oropharynx"}, "mesopharynx", "Mesopharynx")).model;
  SplitOptions split;
  split.cuts = {100};
  tuned = must(splitTerm(tuned, {kDepth, "nasopharynx"}, split)).model;
  tuned.events[1].share = 0.125;
  tuned.events.pop_back();
  tuned.events.push_back({"esophagus", 0.0625});
  const Rebase same = rebased(base, tuned, base);
  for (const CarriedEdit& edit : same.edits) EXPECT_EQ(edit.outcome, Outcome::kApplies) << edit.what << edit.note;
  EXPECT_EQ(allOf(same).events, tuned.events);
  const CarriedEdit& share = editOf(same, "oropharynx: puncture");
  EXPECT_EQ(share.before, "25 % of the force is lost");
  EXPECT_EQ(share.after, "12.5 % of the force is lost");
  // What the data did to a puncture meanwhile is a conflict; a term that is gone is named.
  ForceModel target = base;
  target.events[1].share = 0.375;
  const Rebase other = rebased(base, tuned, target);
  EXPECT_EQ(editOf(other, "oropharynx: puncture").outcome, Outcome::kConflict);
  target.inputs[2].terms.pop_back();
  target.inputs[2].terms.erase(target.inputs[2].terms.begin() + 4);
  fuzzy::eraseLostEvents(target);
  for (auto& expert : target.experts) {
    std::erase_if(expert.rules, [](const fuzzy::Rule& rule) {
      return std::any_of(rule.conditions.begin(), rule.conditions.end(), [](const fuzzy::Condition& condition) {
        return condition.term == "esophagus" || condition.term == "stomach";
      });
    });
  }
  const Rebase without = rebased(base, tuned, target);
  EXPECT_EQ(editOf(without, "esophagus: puncture").outcome, Outcome::kDoesNotApply);
}

TEST(Rebase, OntoTheTunedModelNothingIsToDo) {
  const ForceModel base = built();
  const ForceModel tuned = tunedModel(base);
  const Rebase found = rebased(base, tuned, tuned);
  ASSERT_FALSE(found.edits.empty());
  for (const CarriedEdit& edit : found.edits) {
    EXPECT_EQ(edit.outcome, Outcome::kAlreadySo) << edit.what << ": " << edit.note;
  }
  EXPECT_TRUE(sameBits(allOf(found), tuned));
}

TEST(Rebase, SeveralEditsOfOneThingAreOne) {
  const ForceModel base = built();
  ForceModel tuned = must(setConsequent(base, "S4", 3, "large")).model;
  tuned = must(setConsequent(tuned, "S4", 3, "very_large")).model;
  tuned = must(setRuleWeight(tuned, "S4", 3, 0.5)).model;
  tuned = must(moveVertex(tuned, {kDepth, "nasopharynx", 3}, 132)).model;
  tuned = must(moveVertex(tuned, {kDepth, "nasopharynx", 3}, 134)).model;
  // There and back.
  tuned = must(setExpertWeight(tuned, "S5", 0.25)).model;
  tuned = must(setExpertWeight(tuned, "S5", 1)).model;
  const Rebase found = rebased(base, tuned, base);
  ASSERT_EQ(found.edits.size(), 2);
  EXPECT_EQ(editOf(found, "S4: IF").after, "very_large, weight 0.5");
  EXPECT_EQ(editOf(found, "nasopharynx: right foot").after, "134 mm");
}

TEST(Rebase, AnEditOfWhatTheDataMovedIsAConflict) {
  const ForceModel base = built();
  const std::string was = base.experts[0].rules[3].then;
  const std::string wanted = was == "small" ? "medium" : "small";
  const ForceModel tuned = must(setConsequent(base, "S4", 3, wanted)).model;
  ForceModel target = built("2026-11-28T08:00:00Z");
  target.experts[0].rules[3].then = "very_large";
  target.experts[0].rules[3].weight = 0.75;
  const Rebase found = rebased(base, tuned, target);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].outcome, Outcome::kConflict);
  EXPECT_EQ(found.edits[0].note, "The new model has very_large, weight 0.75.");
  // The edit changed the word alone.
  const fuzzy::Rule made = allOf(found).experts[0].rules[3];
  EXPECT_EQ(made.then, wanted);
  EXPECT_EQ(made.weight, 0.75);
  EXPECT_EQ(allOf(found).created_utc, target.created_utc);
}

TEST(Rebase, WhatTheDataDidAlreadyIsSaid) {
  const ForceModel base = built();
  const ForceModel tuned = must(moveVertex(base, {kDepth, "nasopharynx", 3}, 134)).model;
  ForceModel target = tuned;
  target.created_utc = "2026-11-28T08:00:00Z";
  const Rebase found = rebased(base, tuned, target);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].outcome, Outcome::kAlreadySo);
  EXPECT_FALSE(found.edits[0].note.empty());
  EXPECT_TRUE(sameBits(allOf(found), target));
}

TEST(Rebase, AnExpertWhoIsGoneIsNamed) {
  const ForceModel base = built();
  const ForceModel tuned = must(setConsequent(base, "S5", 3, "very_large")).model;
  ForceModel target = base;
  target.experts.pop_back();
  const Rebase found = rebased(base, tuned, target);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].outcome, Outcome::kDoesNotApply);
  EXPECT_EQ(found.edits[0].note, "S5 is not in the new model.");
  EXPECT_TRUE(sameBits(allOf(found), target));
}

TEST(Rebase, ATermThatIsGoneAndAShapeThatIsAnotherAreNamed) {
  const ForceModel base = built();
  ForceModel tuned = must(moveVertex(base, {kForce, "large", 0}, 0.62)).model;
  tuned = must(moveVertex(tuned, {kForce, "small", 0}, 0.22)).model;
  ForceModel target = must(removeTerm(base, {kForce, "large"}, {RulesOfTerm::kRemove, false})).model;
  target = must(convertShape(target, {kForce, "small"}, fuzzy::Shape::kGaussian)).model;
  const Rebase found = rebased(base, tuned, target);
  EXPECT_EQ(editOf(found, "/ large").outcome, Outcome::kDoesNotApply);
  EXPECT_NE(editOf(found, "/ large").note.find("is not in the new model"), std::string::npos);
  EXPECT_EQ(editOf(found, "/ small").outcome, Outcome::kDoesNotApply);
  EXPECT_NE(editOf(found, "/ small").note.find("gaussian instead of"), std::string::npos);
}

TEST(Rebase, ALockedVertexIsNamed) {
  const ForceModel base = built();
  const ForceModel tuned = must(moveVertex(base, {kDepth, "nasopharynx", 3}, 134)).model;
  const std::vector<VertexPlace> locked = {{kDepth, "nasopharynx", 3}};
  const Rebase found = rebased(base, tuned, base, locked);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].outcome, Outcome::kDoesNotApply);
  EXPECT_NE(found.edits[0].note.find("the right foot is locked"), std::string::npos);
}

TEST(Rebase, ARampOfAPartitionIsOneEdit) {
  const ForceModel base = must(makeSumToOne(built(), kDepth)).model;
  const auto& depth = variableIn(base, "depth");
  const fuzzy::Term& first = depth.terms[0];
  const double to = first.points[2] + 2;
  const ForceModel tuned = must(moveVertex(base, {kDepth, first.id, 2}, to, {true, {}})).model;
  const Rebase found = rebased(base, tuned, base);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].what, "Depth (S4, S5): between nasal_cavity and nasopharynx");
  // The data moved another ramp: both stay partitions.
  const fuzzy::Term& third = depth.terms[2];
  ForceModel target = must(moveVertex(base, {kDepth, third.id, 2}, third.points[2] + 1, {true, {}})).model;
  const ForceModel made = allOf(rebased(base, tuned, target));
  EXPECT_TRUE(partitionOrder(variableIn(made, "depth"), variableIn(made, "depth").terms));
  EXPECT_EQ(pointsOf(made, "depth", first.id)[2], to);
  EXPECT_EQ(pointsOf(made, "depth", third.id)[2], third.points[2] + 1);
}

TEST(Rebase, ARenamedTermKeepsWhatTheDataMoved) {
  const ForceModel base = built();
  const ForceModel tuned = must(renameTerm(base, {kDepth, "nasopharynx"}, "upper", "Upper pharynx")).model;
  ForceModel target = must(moveVertex(base, {kDepth, "nasopharynx", 3}, 136)).model;
  target = must(setConsequent(target, "S4", 3, "very_large")).model;
  const Rebase found = rebased(base, tuned, target);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].outcome, Outcome::kApplies);
  EXPECT_EQ(found.edits[0].after, "Upper pharynx");
  EXPECT_TRUE(
      sameBits(allOf(found), must(renameTerm(target, {kDepth, "nasopharynx"}, "upper", "Upper pharynx")).model));
}

// The copies of a rule say what the new answers say, but for the word that was tuned.
TEST(Rebase, ASplitTermTakesTheRulesOfTheNewModel) {
  const ForceModel base = built();
  SplitOptions options;
  const auto points = pointsOf(base, "depth", "esophagus");
  options.cuts = {(points[1] + points[2]) / 2};
  ForceModel tuned = must(splitTerm(base, {kDepth, "esophagus"}, options)).model;
  const auto isOfPart = [&](const fuzzy::Rule& rule) {
    return names(rule, tuned, variableIn(tuned, "depth"), "esophagus_2");
  };
  const auto& rules = tuned.experts[0].rules;
  const auto second = static_cast<std::size_t>(std::find_if(rules.begin(), rules.end(), isOfPart) - rules.begin());
  const std::string tuned_word = rules[second].then == "very_small" ? "small" : "very_small";
  tuned = must(setConsequent(tuned, "S4", second, tuned_word)).model;

  ForceModel target = built("2026-11-28T08:00:00Z");
  for (fuzzy::Rule& rule : target.experts[0].rules) {
    if (names(rule, target, variableIn(target, "depth"), "esophagus")) rule.then = "very_large";
  }
  const Rebase found = rebased(base, tuned, target);
  ASSERT_EQ(found.edits.size(), 1);
  EXPECT_EQ(found.edits[0].before, "esophagus");
  EXPECT_EQ(found.edits[0].after, "esophagus 1, esophagus 2");
  ASSERT_TRUE(found.edits[0].canApply()) << found.edits[0].note;
  const ForceModel made = allOf(found);
  ForceModel wanted = must(splitTerm(target, {kDepth, "esophagus"}, options)).model;
  wanted.experts[0].rules[second].then = tuned_word;
  EXPECT_TRUE(sameBits(made, wanted));
}

TEST(Rebase, EditsOfDifferentPartsApplyInAnyOrder) {
  const ForceModel base = built();
  const ForceModel tuned = tunedModel(base);
  ForceModel target = built("2026-11-28T08:00:00Z");
  target.experts[0].rules[10].then = "very_large";
  target = must(moveVertex(target, {kDepth, "stomach", 1}, 560)).model;
  const Rebase found = rebased(base, tuned, target);
  const ForceModel together = allOf(found);
  for (const bool backwards : {false, true}) {
    ForceModel model = target;
    std::vector<std::size_t> order = every(found);
    if (backwards) std::reverse(order.begin(), order.end());
    for (const std::size_t edit : order) {
      const Rebase now = rebased(base, tuned, model);
      ASSERT_EQ(now.edits.size(), found.edits.size());
      model = must(carryOver(now, std::span(&edit, 1))).model;
    }
    EXPECT_TRUE(sameBits(model, together)) << backwards;
  }
}

TEST(Rebase, ThePriceIsThatOfTheEditOnTheNewModel) {
  const ForceModel base = built();
  const ForceModel tuned = must(setConsequent(base, "S4", 3, "very_large")).model;
  ForceModel target = base;
  target.experts[1].weight = 3;
  const Rebase found = rebased(base, tuned, target);
  const auto price = priceOf(found, every(found)).value();
  const auto by_hand = must(setConsequent(target, "S4", 3, "very_large"));
  const auto wanted = editImpact(found.target->model, found.target->compiled, by_hand.model, by_hand.compiled);
  EXPECT_GT(price.largest_n, 0);
  EXPECT_EQ(price.largest_n, wanted.largest_n);
  EXPECT_EQ(price.noticeable, wanted.noticeable);
  EXPECT_EQ(price.at, wanted.at);
  // Without edits nothing changes.
  EXPECT_EQ(priceOf(found, {}).value().largest_n, 0);
}

TEST(Rebase, OtherVariablesAreRefused) {
  const ForceModel base = built();
  ForceModel other = base;
  other.inputs.pop_back();
  EXPECT_FALSE(rebase(base, other, shared(base)));
}

// A study: built, tuned, built anew, and opened again.
TEST(Rebase, TheBeginningOfTheEditsIsTheBuild) {
  auto history = EditHistory::open(built(), "Built", {}, study::RecordIds(1)).value();
  history.apply(must(setConsequent(history.model(), "S4", 3, "large")), {});
  history.apply(must(setConsequent(history.model(), "S4", 4, "large")), {});
  const StateId tuned = history.current();
  history.apply(must(finished(built("2026-11-28T08:00:00Z"), "Built anew")), {});
  const StateId anew = history.current();
  history.apply(must(setConsequent(history.model(), "S4", 5, "large")), {});

  const auto check = [&](const EditHistory& one) {
    const StateReader read = [&one](StateId state) { return one.readyOf(state); };
    EXPECT_EQ(beginningOf(one, tuned, anew, read).value(), 0);
    EXPECT_EQ(beginningOf(one, anew, tuned, read).value(), anew);
    EXPECT_EQ(beginningOf(one, one.current(), tuned, read).value(), anew);
    // In one build only what the other version lacks counts.
    EXPECT_EQ(beginningOf(one, tuned, 1, read).value(), 1);
  };
  check(history);
  const auto versions = unstoredVersions(history);
  check(historyFrom(versions, study::RecordIds(2), 0).value());
}

}  // namespace
}  // namespace tactus::editing
