#include "core/fuzzy/centroid.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/core/fuzzy/trapezoid.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

MembershipFunction gaussian(double mean, double sigma) {
  return MembershipFunction::of({"g", "g", Shape::kGaussian, {mean, sigma}});
}

double centroid(const std::vector<std::pair<MembershipFunction, double>>& terms, Implication implication, double lo,
                double hi) {
  std::vector<ActiveTerm> active;
  double largest = 0;
  for (const auto& term : terms) largest = std::max(largest, term.second);
  for (const auto& [function, strength] : terms) active.push_back({&function, strength, strength / largest});
  return lo + centroidOffset(active, implication, lo, hi);
}

// By hand: the trapezoid 0 0 .2 .3 has area .25 and moment .02 + .05 * (.2 + .1 / 3) = .0316667.
TEST(Centroid, OneShoulder) {
  EXPECT_DOUBLE_EQ(centroid({{trapezoid(0, 0, .2, .3), 1}}, Implication::kClip, 0, 1.1), 0.0316666666666666667 / 0.25);
}

// By hand: the triangle 0 2 4 clipped at 1/2 loses its tip and stays symmetric; cut at x = 3 it is no longer so:
// area .5 + 2 * .5 = 1.5 up to 3, moment (.5 * 2/3) / 2 + ... = 1/6 * ... taken piece by piece below.
TEST(Centroid, TheUniverseCutsATerm) {
  EXPECT_DOUBLE_EQ(centroid({{trapezoid(0, 2, 2, 4), 0.5}}, Implication::kClip, 0, 4), 2);
  // Ramp [0, 1] from 0 to .5: area .25, centroid 2/3. Plateau [1, 3] at .5: area 1, centroid 2.
  EXPECT_DOUBLE_EQ(centroid({{trapezoid(0, 2, 2, 4), 0.5}}, Implication::kClip, 0, 3), (0.25 * 2 / 3 + 1 * 2) / 1.25);
}

// Scaling does not move the centroid of a single term, clipping does.
TEST(Centroid, ScaleKeepsTheShape) {
  const auto f = trapezoid(0, 1, 1, 4);
  EXPECT_DOUBLE_EQ(centroid({{f, 0.25}}, Implication::kScale, 0, 4), centroid({{f, 1}}, Implication::kScale, 0, 4));
  EXPECT_DOUBLE_EQ(centroid({{f, 1}}, Implication::kScale, 0, 4), 5.0 / 3);  // (a + b + d) / 3
}

TEST(Centroid, AGapBetweenTwoBlocks) {
  EXPECT_DOUBLE_EQ(centroid({{trapezoid(0, 0, 1, 1), 1}, {trapezoid(9, 9, 10, 10), 0.5}}, Implication::kClip, 0, 10),
                   (0.5 + 0.5 * 9.5) / 1.5);
}

// Three ramps through the point (1, 1/2): the maximum is the outer two.
TEST(Centroid, ThreeLinesThroughOnePoint) {
  const auto falling = trapezoid(0, 0, 0, 2);
  const auto rising = trapezoid(0, 2, 2, 2);
  const auto flat = trapezoid(0, 0, 2, 2);
  EXPECT_DOUBLE_EQ(centroid({{falling, 1}, {rising, 1}, {flat, 0.5}}, Implication::kClip, 0, 2), 1);
}

TEST(Centroid, TinyStrengthsKeepTheirProportion) {
  for (const double scale : {1.0, 1e-100, 1e-300}) {
    EXPECT_DOUBLE_EQ(
        centroid({{trapezoid(0, 0, 1, 1), 3 * scale}, {trapezoid(1, 1, 2, 2), scale}}, Implication::kClip, 0, 2),
        (3 * 0.5 + 1.5) / 4);
  }
}

TEST(Centroid, ASetOneSubnormalWideIsWhereItIs) {
  EXPECT_EQ(centroid({{trapezoid(0, 0, 0, 5e-324), 1}}, Implication::kClip, 0, 2), 0);
  EXPECT_EQ(centroid({{trapezoid(0, 0, 5e-324, 5e-324), 0.5}}, Implication::kScale, -1, 2), 0);
}

// Mean of a Gaussian truncated to [lo, hi]: mean + sigma (phi(l) - phi(h)) / (Phi(h) - Phi(l)).
TEST(Centroid, OneGaussianIsATruncatedNormal) {
  const double mean = 0.4, sigma = 0.3, lo = 0, hi = 1.1;
  const auto phi = [](double u) { return std::exp(-u * u / 2) / std::sqrt(2 * std::numbers::pi); };
  const auto cumulative = [](double u) { return 0.5 * std::erfc(-u / std::numbers::sqrt2); };
  const double l = (lo - mean) / sigma, h = (hi - mean) / sigma;
  const double expected = mean + sigma * (phi(l) - phi(h)) / (cumulative(h) - cumulative(l));
  EXPECT_NEAR(centroid({{gaussian(mean, sigma), 1}}, Implication::kClip, lo, hi), expected, 1e-15);
  EXPECT_NEAR(centroid({{gaussian(mean, sigma), 0.01}}, Implication::kScale, lo, hi), expected, 1e-15);
}

/// Centroid by the midpoint rule in long double, a term at a time: slow and obvious.
double sampled(const ForceModel& model, const CompiledModel& compiled, std::size_t expert,
               const std::vector<double>& point, int cells) {
  std::vector<double> strengths(compiled.outputTerms(expert).size());
  compiled.strengths(expert, point, strengths);
  const auto terms = compiled.outputTerms(expert);
  long double area = 0, moment = 0;
  const long double width = (static_cast<long double>(model.output.max) - model.output.min) / cells;
  for (int i = 0; i < cells; ++i) {
    const long double x = model.output.min + width * (i + 0.5L);
    long double top = 0;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const long double membership = terms[t](static_cast<double>(x));
      top = std::max(top, model.implication == Implication::kClip ? std::min<long double>(strengths[t], membership)
                                                                  : strengths[t] * membership);
    }
    area += top, moment += top * x;
  }
  return static_cast<double>(moment / area);
}

TEST(Centroid, MixturesOfGaussiansAndTrapezoidsAgreeWithSampling) {
  base::Random random(4);
  for (int m = 0; m < 60; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = true, .adversarial = false});
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value()) << compiled.error().message();
    const auto point = support::randomPoint(random, model);
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto force = compiled->evaluateExpert(e, point);
      if (!force.fired) continue;
      // Vertical edges cost the midpoint rule one cell, 5e-6 of the range here.
      EXPECT_NEAR(force.force_n, sampled(model, *compiled, e, point, 200000),
                  1e-5 * (model.output.max - model.output.min));
    }
  }
}

// Smooth sets leave the midpoint rule an error of about 1e-11, so the agreement says much more here.
TEST(Centroid, OverlappingGaussiansAgreeWithSampling) {
  const std::vector<std::pair<MembershipFunction, double>> sets = {
      {gaussian(0.2, 0.1), 0.7}, {gaussian(0.5, 0.3), 0.4}, {gaussian(0.9, 0.05), 1}};
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    long double area = 0, moment = 0;
    constexpr int kCells = 2000000;
    for (int i = 0; i < kCells; ++i) {
      const double x = 1.1 * (i + 0.5) / kCells;
      double top = 0;
      for (const auto& [f, s] : sets)
        top = std::max(top, implication == Implication::kClip ? std::min(s, f(x)) : s * f(x));
      area += top, moment += static_cast<long double>(top) * x;
    }
    EXPECT_NEAR(centroid(sets, implication, 0, 1.1), static_cast<double>(moment / area), 1e-11);
  }
}

TEST(Centroid, AGaussianFarOutsideTheUniverseIsItsTail) {
  // Thirty sigmas below the universe the tail falls like exp(-30 u): its centroid is sigma / 30 above the edge, less
  // about sigma / 30^3 (series of the inverse Mills ratio: E[u] - 30 = 1/30 - 2/30^3 + 10/30^5 - ...).
  const double expected = 1.0 / 30 - 2.0 / 27000 + 10.0 / 24300000;
  EXPECT_NEAR(centroid({{gaussian(-30, 1), 1}}, Implication::kClip, 0, 5), expected, 1e-8);
}

// All positions are multiples of 1/64, so moving the universe to a million changes none of them. The part of the
// triangle's ramp below a strength of 3e-13 is shorter than an ulp there.
TEST(Centroid, BesideAGaussianAWeakTriangleFarFromZeroKeepsItsShape) {
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    for (const double strength : {1.0, 0.25, 3e-13, 1e-100, 1e-300}) {
      const auto at = [&](double origin) {
        const double offset = centroid({{trapezoid(origin + .125, origin + .25, origin + .25, origin + .375), strength},
                                        {gaussian(origin + .75, .015625), strength}},
                                       implication, origin, origin + 1);
        return offset - origin;
      };
      // An ulp at a million is 1.2e-10.
      EXPECT_NEAR(at(1e6), at(0), 1.2e-10) << strength;
    }
  }
}

}  // namespace
}  // namespace tactus::fuzzy
