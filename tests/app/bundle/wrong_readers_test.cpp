// Readers of a model with one mistake each are caught by the checks that a bundle puts into the file. They are written
// here once more, without the help of the code that chooses the points.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "app/bundle/bundle.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

#include "tests/support/ngt_model.h"

namespace tactus::bundle {
namespace {

/// A slow reader: sampled centroid of 2000 cells per point, switches for its mistakes.
struct Reader {
  bool weights = true, enabled = true, clamps = true, abstains = true, expert_weights = true, default_force = true;
  bool least = true, weightless_are_silent = true;

  static double membership(const fuzzy::Term& term, double x) {
    const auto& p = term.points;
    const double b = p[1];
    const double c = term.shape == fuzzy::Shape::kTriangle ? p[1] : p[2];
    const double d = p.back();
    if (x < b) return x > p[0] ? (x - p[0]) / (b - p[0]) : 0;
    return x <= c ? 1 : x < d ? (d - x) / (d - c) : 0;
  }

  fuzzy::Evaluation expert(const fuzzy::ForceModel& model, const fuzzy::Expert& from,
                           const std::vector<double>& point) const {
    std::vector<double> strengths(model.output.terms.size());
    for (const fuzzy::Rule& rule : from.rules) {
      if (enabled && !rule.enabled) continue;
      double strength = 1;
      for (const fuzzy::Condition& condition : rule.conditions) {
        for (std::size_t i = 0; i < point.size(); ++i) {
          if (model.inputs[i].id != condition.input) continue;
          const double x = clamps ? std::clamp(point[i], model.inputs[i].min, model.inputs[i].max) : point[i];
          const double one = membership(*fuzzy::findTerm(fuzzy::termsFor(from, model.inputs[i]), condition.term), x);
          strength = least ? std::min(strength, one) : strength * one;
        }
      }
      if (weights) strength *= rule.weight;
      for (std::size_t t = 0; t < strengths.size(); ++t) {
        if (model.output.terms[t].id == rule.then) strengths[t] = std::max(strengths[t], strength);
      }
    }
    double area = 0;
    double moment = 0;
    for (int cell = 0; cell < 2000; ++cell) {
      const double y = model.output.min + (model.output.max - model.output.min) * (cell + 0.5) / 2000;
      double height = 0;
      for (std::size_t t = 0; t < strengths.size(); ++t) {
        height = std::max(height, std::min(strengths[t], membership(model.output.terms[t], y)));
      }
      area += height;
      moment += height * y;
    }
    if (area == 0) return {default_force ? model.default_force_n : 0, false};
    return {moment / area, true};
  }

  fuzzy::Evaluation force(const fuzzy::ForceModel& model, const std::vector<double>& point) const {
    double sum = 0;
    double total = 0;
    bool fired = false;
    for (const fuzzy::Expert& one : model.experts) {
      const auto alone = expert(model, one, point);
      if (one.weight == 0 && weightless_are_silent) continue;
      fired = fired || alone.fired;
      const double weight = expert_weights ? one.weight : 1;
      if (abstains && !alone.fired) continue;
      sum += weight * alone.force_n;
      total += weight;
    }
    if (total == 0) return {default_force ? model.default_force_n : 0, fired};
    return {sum / total, fired};
  }
};

/// Two experts with every feature that a reader may get wrong.
fuzzy::ForceModel everyFeature() {
  fuzzy::ForceModel model = support::s4Shifted();
  model.default_force_n = 0.2;
  model.experts[0].rules[3].weight = 0.4;
  model.experts[0].rules[7].enabled = false;
  // The first expert's terms end at the end of the universe: beyond it nothing holds where nothing is clamped.
  fuzzy::Expert second;
  second.id = "S2";
  second.weight = 3;
  second.rules.push_back({{{"speed", "fast"}, {"depth", "stomach"}}, "very_large"});
  second.rules.push_back({{{"speed", "slow"}}, "small"});
  model.experts.push_back(second);
  // The only one who speaks everywhere.
  fuzzy::Expert weightless;
  weightless.id = "S3";
  weightless.weight = 0;
  for (const fuzzy::Term& term : model.inputs[0].terms) {
    weightless.rules.push_back({{{model.inputs[0].id, term.id}}, "large"});
  }
  model.experts.push_back(weightless);
  return model;
}

/// How many checks of the bundle's own model file a reader fails. The sampling is good to 1e-4 N.
int caught(const fuzzy::ForceModel& model, const Reader& reader) {
  int out = 0;
  for (const fuzzy::Check& check : model.checks) {
    const auto force = reader.force(model, check.in);
    if (force.fired != check.fired || std::abs(force.force_n - check.force) > 1e-3) ++out;
  }
  return out;
}

TEST(WrongReaders, EachIsCaughtByTheChecksOfTheFile) {
  auto accepted = everyFeature();
  BundleSettings settings;
  settings.table_error_n = 1e3;  // the table is not the matter here
  auto made = makeBundle(accepted, settings);
  for (int tries = 0; !made && tries < 20; ++tries) {
    // The name of the hole stands in the message, between quotes.
    const std::string wanted = made.error().wanted;
    const auto open = wanted.find('\'');
    ASSERT_NE(open, std::string::npos) << made.error().message();
    settings.accept_holes.push_back(wanted.substr(open + 1, wanted.rfind('\'') - open - 1));
    made = makeBundle(accepted, settings);
  }
  ASSERT_TRUE(made) << made.error().message();
  const fuzzy::ForceModel& model = made->model;
  ASSERT_FALSE(model.checks.empty());
  EXPECT_EQ(caught(model, Reader{}), 0);
  EXPECT_GT(caught(model, Reader{.weights = false}), 0);
  EXPECT_GT(caught(model, Reader{.enabled = false}), 0);
  EXPECT_GT(caught(model, Reader{.clamps = false}), 0);
  EXPECT_GT(caught(model, Reader{.abstains = false}), 0);
  EXPECT_GT(caught(model, Reader{.expert_weights = false}), 0);
  EXPECT_GT(caught(model, Reader{.default_force = false}), 0);
  EXPECT_GT(caught(model, Reader{.least = false}), 0);
  EXPECT_GT(caught(model, Reader{.weightless_are_silent = false}), 0);
}

}  // namespace
}  // namespace tactus::bundle
