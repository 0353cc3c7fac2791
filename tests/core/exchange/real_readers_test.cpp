// Another program reads our files and computes the forces that we expect of it: fuzzylite, where it is installed.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <string>

#include "core/analysis/centroid_bound.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/exchange/dialect.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/fuzzylite_program.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::exchange {
namespace {

constexpr double kVertexGap = 1e-4;  // fuzzylite takes numbers for equal that are closer than 1e-6
constexpr double kShare = 1e-9;      // of the output's range: what a program may differ that computes the same
constexpr int kPoints = 200;

bool hasNarrowGap(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  for (const fuzzy::Term& term : terms) {
    if (term.shape == fuzzy::Shape::kGaussian) continue;
    for (std::size_t i = 1; i < term.points.size(); ++i) {
      const double gap = term.points[i] - term.points[i - 1];
      if (gap > 0 && gap < kVertexGap * std::max(1.0, variable.max - variable.min)) return true;
    }
  }
  return false;
}

bool hasNarrowGap(const fuzzy::ForceModel& model) {
  for (const fuzzy::Expert& expert : model.experts) {
    if (hasNarrowGap(model.output, fuzzy::termsFor(expert, model.output))) return true;
    for (const fuzzy::Variable& input : model.inputs) {
      if (hasNarrowGap(input, fuzzy::termsFor(expert, input))) return true;
    }
  }
  return false;
}

/// Points inside the universes, none of them beside a vertex.
std::vector<std::vector<double>> pointsOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                          base::Random& random) {
  std::vector<std::vector<double>> points;
  while (points.size() < kPoints) {
    std::vector<double> point;
    bool beside = false;
    for (const fuzzy::Variable& input : model.inputs) {
      const double x = input.min + (input.max - input.min) * random.uniform();
      for (const fuzzy::Term& term : fuzzy::termsFor(expert, input)) {
        for (const double vertex : term.points) beside = beside || std::abs(x - vertex) < 1e-5;
      }
      point.push_back(x);
    }
    if (!beside) points.push_back(std::move(point));
  }
  return points;
}

/// fuzzylite takes strengths below 1e-6 for 0, which the tails of Gaussians have.
bool hasFaintStrength(const fuzzy::CompiledModel& model, std::size_t expert, const std::vector<double>& point) {
  std::vector<double> strengths(model.outputTerms(expert).size());
  model.strengths(expert, point, strengths);
  return std::any_of(strengths.begin(), strengths.end(), [](double s) { return s > 0 && s < 2e-6; });
}

class Fuzzylite : public testing::Test {
 protected:
  void SetUp() override {
    if (program_.isThere()) return;
    std::cout << "SKIPPED: fuzzylite is not installed, so no other program reads our files here\n";
    GTEST_SKIP();
  }

  void expectSame(const fuzzy::ForceModel& model, Dialect dialect, const std::string& format, base::Random& random) {
    const auto compiled = fuzzy::compile(model);
    const analysis::Sampling sampling{analysis::Sampling::Rule::kMidpoint,
                                      format == "fcl" ? program_.cellsOfFcl() : 1000};
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      SCOPED_TRACE("expert " + std::to_string(e) + " as " + std::string(name(dialect)));
      const auto text = exchange::format(model, e, dialect, {std::string(64, 'a'), "2026-11-21", "tactus"});
      ASSERT_TRUE(text) << text.error().message();
      const auto points = pointsOf(model, model.experts[e], random);
      const auto found = program_.outputs(*text, format, points);
      ASSERT_EQ(found.size(), points.size()) << *text;
      for (std::size_t p = 0; p < points.size(); ++p) {
        if (hasFaintStrength(*compiled, e, points[p])) continue;
        ++compared_;
        const auto wanted = analysis::evaluateSampled(*compiled, points[p], sampling, e);
        const bool has_force = wanted.fired && !std::isnan(wanted.force_n);
        ASSERT_EQ(!std::isnan(found[p]), has_force) << "point " << p << '\n' << *text;
        if (!has_force) continue;
        const double apart = std::abs(found[p] - wanted.force_n) / (model.output.max - model.output.min);
        largest_ = std::max(largest_, apart);
        ASSERT_LE(apart, kShare) << "point " << p << '\n' << *text;
      }
    }
  }

  support::FuzzyliteProgram program_;
  double largest_ = 0;
  int compared_ = 0;
};

TEST_F(Fuzzylite, ReadsTheNgtModelInItsDialects) {
  base::Random random(1);
  expectSame(support::s4FiveRegions(), Dialect::kFll, "fll", random);
  expectSame(support::s4FiveRegions(), Dialect::kFclFuzzylite, "fcl", random);
}

TEST_F(Fuzzylite, AgreesForRandomModels) {
  base::Random random(2);
  int models = 0;
  while (models < 30) {
    const auto model = support::randomModel(random, {.gaussians = models % 3 == 0, .adversarial = false});
    if (hasNarrowGap(model)) continue;
    SCOPED_TRACE("model " + std::to_string(models++));
    expectSame(model, Dialect::kFll, "fll", random);
    expectSame(model, Dialect::kFclFuzzylite, "fcl", random);
    if (HasFatalFailure()) return;
  }
  RecordProperty("largest_share_of_range", base::formatNumber(largest_));
  std::cout << "largest difference: " << largest_ << " of the range, at " << compared_ << " points\n";
  EXPECT_GT(compared_, 10'000);
}

}  // namespace
}  // namespace tactus::exchange
