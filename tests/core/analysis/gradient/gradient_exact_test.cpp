// Gradients against exact rational difference quotients, on generated models and the NGT model.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/analysis/gradient/gradient.h"
#include "core/base/random.h"

#include "tests/reference/exact_gradient.h"
#include "tests/reference/exact_model.h"
#include "tests/support/gradient_slots.h"
#include "tests/support/ngt_model.h"
#include "tests/support/ordered_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using fuzzy::Implication;
using reference::ExactGradient;
using reference::Parameter;
using support::slotOf;

double widthOf(const ForceModel& model, const Parameter& p) {
  if (p.kind == Parameter::Kind::kWeight) return 1;
  const auto& variable = p.variable < model.inputs.size() ? model.inputs[p.variable] : model.output;
  return variable.max - variable.min;
}

std::string describe(const Parameter& p) {
  return std::string(p.kind == Parameter::Kind::kInput    ? "input"
                     : p.kind == Parameter::Kind::kWeight ? "weight"
                                                          : "point") +
         " expert " + (p.expert ? std::to_string(*p.expert) : "-") + " variable " + std::to_string(p.variable) +
         " index " + std::to_string(p.index) + " point " + std::to_string(p.point);
}

struct Tally {
  long nonzero = 0;
  long kinks = 0;      ///< the two one-sided derivatives differ, and ours is one of them or lies between
  long undefined = 0;  ///< ties and jumps
};

/// Whether `value` is the derivative within 1e-12 of the largest of three: the derivative; what cancels in it (see
/// ExactDerivative); the range of the force over that of the parameter, because a change of 1e-12 of the parameter's
/// range for the whole range of the force is beyond any use.
bool agrees(double value, const reference::ExactDerivative& exact, double floor) {
  if (abs(exact.value) > mpq_class(std::numeric_limits<double>::max())) return std::isinf(value);
  if (!std::isfinite(value)) return false;
  const mpq_class bound = 1e-12 * std::max({mpq_class(abs(exact.value)), exact.scale, mpq_class(floor)});
  return abs(mpq_class(value) - exact.value) <= bound;
}

/// Whether the input lies on a vertex of the term that `parameter` belongs to.
bool onVertex(const ForceModel& model, const Parameter& parameter, const std::vector<double>& point) {
  if (parameter.kind != Parameter::Kind::kPoint || parameter.variable == model.inputs.size()) return false;
  const auto& variable = model.inputs[parameter.variable];
  const auto& terms = parameter.expert ? termsFor(model.experts[*parameter.expert], variable) : variable.terms;
  const auto& vertices = terms[parameter.index].points;
  const double x = std::clamp(point[parameter.variable], variable.min, variable.max);
  return std::find(vertices.begin(), vertices.end(), x) != vertices.end();
}

void compare(const ForceModel& model, const std::vector<double>& point, const Parameter& parameter,
             const ExactGradient& exact, double value, Tally& tally) {
  const double width = widthOf(model, parameter);
  const double floor = (model.output.max - model.output.min) / width;
  tally.nonzero += value != 0;
  const auto right = exact.derivative(parameter, 1);
  if (right && agrees(value, *right, floor)) return;
  const auto left = exact.derivative(parameter, -1);
  if (!right && !left) return;  // all points of a triangle coincide: it cannot move
  if (left && agrees(value, *left, floor)) {
    tally.kinks += right.has_value();
    return;
  }
  // The piece to the right may be one that only a move against the order of the points would reach.
  if ((!left || !right) && onVertex(model, parameter, point)) {
    ++tally.kinks;
    return;
  }
  // Equals within 1e-14, some roundings of a membership: nothing but rounding decides between them.
  if ((left && left->jump) || (right && right->jump) || exact.tied(1e-14)) {
    ++tally.undefined;
    return;
  }
  // Within rounding of a kink either side is right. A corner of a set hangs on some roundings of its strength.
  mpq_class low = right ? right->value : left->value;
  mpq_class high = low;
  for (const double offset : {-1e-12 * width, 0.0, 1e-12 * width}) {
    for (const int direction : {-1, 1}) {
      const auto beside = exact.derivative(parameter, direction, offset);
      if (!beside) continue;
      low = std::min(low, beside->value);
      high = std::max(high, beside->value);
    }
  }
  ++tally.kinks;
  EXPECT_TRUE(low <= mpq_class(value) && mpq_class(value) <= high)
      << describe(parameter) << ": " << value << ", exact " << (right ? right->value.get_d() : std::nan(""))
      << " to the right, " << (left ? left->value.get_d() : std::nan("")) << " to the left, beside " << low.get_d()
      << " to " << high.get_d() << ", floor " << floor;
}

void compareAt(const ForceModel& model, const GradientModel& gradients, const std::vector<double>& point,
               Tally& tally) {
  const ExactGradient exact(model, point);
  ASSERT_EQ(exact.force(), reference::exactForce(model, point)) << "the two references differ";
  Gradient gradient = gradients.makeGradient();
  gradients.evaluate(point, gradient);
  ASSERT_EQ(gradient.fired, exact.force().has_value());
  // The bound of the evaluator: 1e-12 of the range and 2 ulp of the force.
  const double force = exact.force() ? exact.force()->get_d() : model.default_force_n;
  ASSERT_NEAR(gradient.force_n, force, 1e-12 * (model.output.max - model.output.min) + 4.5e-16 * std::abs(force));
  for (const auto& parameter : exact.parameters())
    compare(model, point, parameter, exact, gradient[slotOf(gradients, parameter)], tally);
}

Tally compareRandomModels(std::uint64_t seed, int models, bool adversarial) {
  base::Random random(seed);
  Tally tally;
  for (int m = 0; m < models; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const ForceModel model = support::randomModel(random, {.gaussians = false, .adversarial = adversarial});
    const auto gradients = GradientModel::of(model);
    EXPECT_TRUE(gradients.has_value()) << gradients.error().message();
    if (gradients) compareAt(model, *gradients, support::randomPoint(random, model), tally);
  }
  return tally;
}

/// That the comparison compared something: most derivatives that are not 0 exist and agree.
void expectMostlySmooth(const Tally& tally) {
  EXPECT_GT(tally.nonzero, 3000);
  EXPECT_LT(tally.kinks, tally.nonzero / 5);
  EXPECT_LT(tally.undefined, tally.nonzero / 20);
  testing::Test::RecordProperty("nonzero", std::to_string(tally.nonzero));
  testing::Test::RecordProperty("kinks", std::to_string(tally.kinks));
  testing::Test::RecordProperty("undefined", std::to_string(tally.undefined));
}

TEST(GradientExact, OrdinaryRandomModels) { expectMostlySmooth(compareRandomModels(11, 500, false)); }

TEST(GradientExact, AdversarialRandomModels) { expectMostlySmooth(compareRandomModels(12, 500, true)); }

// Where the fast path applies, against the exact derivatives and against the general sweep.
TEST(GradientExact, OrderedRandomModels) {
  base::Random random(16);
  Tally tally;
  int closed = 0;
  int experts = 0;
  for (int m = 0; m < 50; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const ForceModel model = support::randomOrderedModel(random);
    const auto gradients = GradientModel::of(model);
    ASSERT_TRUE(gradients.has_value()) << gradients.error().message();
    for (std::size_t e = 0; e < model.experts.size(); ++e) closed += gradients->hasClosedForm(e) ? 1 : 0;
    experts += static_cast<int>(model.experts.size());
    compareAt(model, *gradients, support::randomOrderedPoint(random, model), tally);
  }
  EXPECT_GT(closed, experts / 3);
  EXPECT_GT(tally.nonzero, 1000);
  EXPECT_LT(tally.kinks, tally.nonzero / 5);
  // Rules that share their smallest membership tie for their term; then their weights have no derivative.
  EXPECT_LT(tally.undefined, tally.nonzero / 5);
}

TEST(GradientExact, NgtModel) {
  base::Random random(13);
  Tally tally;
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    ForceModel model = support::s4AsPrinted();
    model.implication = implication;
    const auto gradients = GradientModel::of(model);
    ASSERT_TRUE(gradients.has_value());
    for (int i = 0; i < 20; ++i) {
      compareAt(model, *gradients,
                {random.uniform(), random.uniform(0, 90), random.uniform(0, 600), random.uniform(0, 400)}, tally);
    }
  }
  EXPECT_GT(tally.nonzero, 300);
  // Rules with the same smallest membership tie for their term; then only their weights have no derivative.
  EXPECT_LT(tally.undefined, 10);
}

}  // namespace
}  // namespace tactus::analysis
