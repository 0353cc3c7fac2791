// What holds for every candidate of every pull, on generated models and on the four invented experts.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/analysis/pull/pull.h"
#include "core/analysis/term_conversion.h"
#include "core/base/random.h"

#include "tests/core/analysis/ngt_numbers.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ordered_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

/// Whether each list that summed to one still does, with its terms in the same order.
void expectSumsKept(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& before,
                    const std::vector<fuzzy::Term>& after) {
  const auto order = partitionOrder(variable, before);
  if (!order) return;
  const auto now = partitionOrder(variable, after);
  ASSERT_TRUE(now) << variable.id;
  EXPECT_EQ(*order, *now);
}

/// Takes out what `edit` may change; the rest of the two models must be equal.
void forget(ForceModel& model, const PullEdit& edit) {
  if (editsRule(edit.gesture)) {
    auto& rule = model.experts[expertIndex(model, edit.expert)].rules[edit.rule];
    rule.then.clear();
    rule.weight = 1;
    rule.enabled = true;
  } else if (edit.list.owner.empty()) {
    (edit.list.variable < model.inputs.size() ? model.inputs[edit.list.variable] : model.output).terms.clear();
  } else {
    for (auto& own : model.experts[expertIndex(model, edit.list.owner)].overrides) {
      if (own.variable == variableAt(model, edit.list.variable).id) own.terms.clear();
    }
  }
}

struct Counted {
  std::size_t candidates = 0;
  std::size_t pairs = 0;
};

Counted checkPull(const ForceModel& model, const std::vector<double>& point, double target_n,
                  const PullSettings& settings) {
  const auto found = pull(model, point, target_n, noticeable, settings);
  EXPECT_TRUE(found.has_value());
  if (!found) return {};
  Counted counted{found->candidates.size(), 0};
  for (const PullCandidate& one : found->candidates) {
    SCOPED_TRACE(std::string(name(one.edits[0].gesture)) + " of variable " +
                 std::to_string(one.edits[0].list.variable) + " by " + std::to_string(one.edits[0].delta));
    if (one.edits.size() == 2) ++counted.pairs;
    const ForceModel after = applied(model, one.edits);
    const auto compiled = fuzzy::compile(after);  // also the order of the vertices
    EXPECT_TRUE(compiled.has_value());
    if (!compiled) continue;
    const auto force = settings.expert ? compiled->evaluateExpert(*settings.expert, point) : compiled->evaluate(point);
    const double range_n = model.output.max - model.output.min;
    EXPECT_TRUE(force.fired);
    EXPECT_NEAR(force.force_n, one.force_n, 1e-14 * range_n) << "a few ulp: an expert alone and the mean of one";
    EXPECT_NEAR(force.force_n, one.exact ? target_n : one.force_n, 1e-9 * range_n);
    EXPECT_GE(one.force_n, found->reachable->min_n);
    EXPECT_LE(one.force_n, found->reachable->max_n);
    for (std::size_t v = 0; v <= model.inputs.size(); ++v) {
      expectSumsKept(variableAt(model, v), variableAt(model, v).terms, variableAt(after, v).terms);
    }
    for (const std::size_t locked : settings.locked) {
      EXPECT_EQ(variableAt(model, locked).terms, variableAt(after, locked).terms);
    }
    ForceModel left = model;
    ForceModel right = after;
    for (const PullEdit& edit : one.edits) forget(left, edit), forget(right, edit);
    EXPECT_EQ(left, right) << "nothing else changes";
  }
  return counted;
}

TEST(PullProperties, FourExpertsThatShareTheirTerms) {
  base::Random random(20261123);
  const ForceModel model = support::inventedExperts();
  std::size_t candidates = 0;
  std::size_t pairs = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<double> point;
    for (const auto& input : model.inputs) point.push_back(input.min + random.uniform() * (input.max - input.min));
    PullSettings settings;
    settings.box_points = 64;
    if (i % 2 == 0) settings.expert = i / 2 % 4;
    if (i % 3 == 0) settings.locked = {static_cast<std::size_t>(i % 5)};
    const Counted counted = checkPull(model, point, .15 + .7 * random.uniform(), settings);
    candidates += counted.candidates;
    pairs += counted.pairs;
  }
  EXPECT_GT(candidates, 200U);
  EXPECT_GT(pairs, 5U);
}

TEST(PullProperties, GeneratedModels) {
  base::Random random(7);
  std::size_t candidates = 0;
  for (int i = 0; i < 150; ++i) {
    const ForceModel model = support::randomOrderedModel(random);
    std::vector<double> point = support::randomOrderedPoint(random, model);
    for (std::size_t k = 0; k < point.size(); ++k) {
      point[k] = std::clamp(point[k], model.inputs[k].min, model.inputs[k].max);
    }
    PullSettings settings;
    settings.box_points = 32;
    if (i % 2 == 0) settings.expert = static_cast<std::size_t>(i) % model.experts.size();
    const double target_n = model.output.min + random.uniform() * (model.output.max - model.output.min);
    candidates += checkPull(model, point, target_n, settings).candidates;
  }
  EXPECT_GT(candidates, 150U);
}

/// All vertices of a list.
std::vector<LockedVertex> verticesOf(const ForceModel& model, const PulledList& list) {
  std::vector<LockedVertex> out;
  for (const fuzzy::Term& term : termsOf(model, list)) {
    for (std::size_t point = 0; point < term.points.size(); ++point) out.push_back({list, term.id, point});
  }
  return out;
}

/// Whether a vertex is where it was. A triangle that becomes a trapezoid keeps its peak as one end of its core.
bool stays(const ForceModel& before, const ForceModel& after, const LockedVertex& vertex) {
  const fuzzy::Term& was = *fuzzy::findTerm(termsOf(before, vertex.list), vertex.term);
  const fuzzy::Term& is = *fuzzy::findTerm(termsOf(after, vertex.list), vertex.term);
  const auto ends = [](const fuzzy::Term& term) {
    return term.points.size() == 3 ? std::vector{term.points[0], term.points[1], term.points[1], term.points[2]}
                                   : term.points;
  };
  if (was.points.size() == is.points.size()) return was.points[vertex.point] == is.points[vertex.point];
  if (vertex.point != 1) return ends(was)[vertex.point == 0 ? 0 : 3] == ends(is)[vertex.point == 0 ? 0 : 3];
  return ends(was)[1] == ends(is)[1] && ends(was)[2] == ends(is)[2];
}

// What a gesture moves is told from its kind alone; here each gesture is made, a little to both sides.
TEST(PullProperties, AGestureMovesWhatItIsSaidToMove) {
  base::Random random(20261128);
  std::size_t moved_vertices = 0;
  for (int i = 0; i < 60; ++i) {
    const ForceModel model = support::randomOrderedModel(random);
    for (std::size_t v = 0; v <= model.inputs.size(); ++v) {
      const PulledList list{v, {}};
      const auto ramps = rampsOf(variableAt(model, v), termsOf(model, list));
      if (!ramps) continue;
      for (const GesturePlace& gesture : gesturesOf(*ramps)) {
        PullEdit edit = termEdit(gesture.gesture, list, gesture.place);
        const DeltaRange range = allowedDeltas(*ramps, gesture.gesture, gesture.place);
        for (const double delta : {range.low / 3, range.high / 3}) {
          if (delta == 0) continue;
          edit.delta = delta;
          const ForceModel after = applied(model, edit);
          for (const LockedVertex& vertex : verticesOf(model, list)) {
            const bool moves = lockedVertexOf(model, edit, std::span(&vertex, 1)) != nullptr;
            EXPECT_NE(moves, stays(model, after, vertex))
                << name(gesture.gesture) << ' ' << gesture.place << ' ' << vertex.term << ' ' << vertex.point;
            moved_vertices += moves ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(moved_vertices, 1000U);
}

}  // namespace
}  // namespace tactus::analysis
