#include "tests/stress/agreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gmpxx.h>
#include <limits>
#include <vector>

#include "core/base/text.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/scene.h"

#include "tests/reference/exact_model.h"
#include "tests/support/random_model.h"

namespace tactus::stress {
namespace {

using fuzzy::Evaluation;
using fuzzy::ForceModel;
using Point = std::vector<double>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ulpOf(double value) {
  const double magnitude = std::abs(value);
  return std::nextafter(magnitude, kInfinity) - magnitude;
}

std::string textOf(const Evaluation& force) {
  return base::formatNumber(force.force_n) + (force.fired ? " (fired)" : " (not fired)");
}

std::string textOf(const Point& point) {
  std::vector<std::string> parts;
  for (const double value : point) parts.push_back(base::formatNumber(value));
  return "[" + base::joined(parts, ", ") + "]";
}

/// The arrays that batches read and write.
struct Arrays {
  std::vector<std::vector<double>> columns;
  std::vector<std::span<const double>> views;
  std::vector<double> force_n;
  std::vector<std::uint8_t> fired;

  Arrays(const std::vector<Point>& points, const std::vector<std::size_t>& inputs)
      : force_n(points.size()), fired(points.size()) {
    for (const std::size_t input : inputs) {
      auto& column = columns.emplace_back();
      for (const Point& point : points) column.push_back(point[input]);
    }
    views.assign(columns.begin(), columns.end());
  }

  fuzzy::BatchResult result() { return {force_n, fired}; }
  Evaluation at(std::size_t point) const { return {force_n[point], fired[point] != 0}; }
};

class Checker {
 public:
  Checker(const ForceModel& model, base::Random& random) : model_(model), random_(random) {}

  Agreement run(int count) {
    const auto compiled = fuzzy::compile(model_);
    if (!compiled) {
      found_.disagreement = "the model does not compile: " + compiled.error().message();
      return found_;
    }
    const std::vector<Point> points = makePoints(count);
    const auto scene = fuzzy::Scene::specialize(*compiled, fixed_);
    if (!scene) {
      found_.disagreement = "the model does not specialize: " + scene.error().message();
      return found_;
    }
    std::vector<std::size_t> all(model_.inputs.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    Arrays batch(points, all);
    fuzzy::evaluateBatch(*compiled, batch.views, batch.result());
    Arrays scene_batch(points, free_);
    scene->evaluateBatch(scene_batch.views, scene_batch.result());

    for (std::size_t p = 0; p < points.size(); ++p) {
      const Evaluation one = compiled->evaluate(points[p]);
      checkMean(points[p], one);
      checkEntryPoint("evaluateBatch", points[p], batch.at(p), one);
      Point free_inputs;
      for (const std::size_t input : free_) free_inputs.push_back(points[p][input]);
      checkEntryPoint("Scene::evaluate", points[p], scene->evaluate(free_inputs), one);
      checkEntryPoint("Scene::evaluateBatch", points[p], scene_batch.at(p), one);
    }
    const auto expert = static_cast<std::size_t>(random_.below(static_cast<int>(model_.experts.size())));
    const Point& point = points.front();
    if (isFinite(point)) {
      check("evaluateExpert", point, compiled->evaluateExpert(expert, point),
            reference::exactExpertForce(model_, expert, point));
    }
    return found_;
  }

 private:
  static bool isFinite(const Point& point) {
    return std::all_of(point.begin(), point.end(), [](double value) { return std::isfinite(value); });
  }

  /// Chooses which inputs are fixed; the points share these values. The last point is not finite, if any input is free.
  std::vector<Point> makePoints(int count) {
    const Point common = support::randomPoint(random_, model_);
    fixed_.resize(common.size());
    for (std::size_t i = 0; i < common.size(); ++i) {
      if (random_.below(3) == 0) {
        fixed_[i] = common[i];
      } else {
        free_.push_back(i);
      }
    }
    std::vector<Point> points;
    for (int p = 0; p <= count; ++p) {
      Point point = support::randomPoint(random_, model_);
      for (std::size_t i = 0; i < point.size(); ++i) point[i] = fixed_[i].value_or(point[i]);
      points.push_back(std::move(point));
    }
    if (!free_.empty()) {
      const std::array<double, 3> bad = {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity};
      const auto input = free_[static_cast<std::size_t>(random_.below(static_cast<int>(free_.size())))];
      points.back()[input] = bad[static_cast<std::size_t>(random_.below(3))];
    }
    return points;
  }

  double bound(double force_n) const { return 1e-12 * (model_.output.max - model_.output.min) + 2 * ulpOf(force_n); }

  void disagree(const char* who, const Point& point, const std::string& what) {
    if (!found_.disagreement) found_.disagreement = std::string(who) + " at " + textOf(point) + ": " + what;
  }

  void checkMean(const Point& point, const Evaluation& one) {
    if (!isFinite(point)) {
      if (one.fired || !std::isnan(one.force_n)) disagree("evaluate", point, textOf(one) + ", wanted NaN (not fired)");
      return;
    }
    check("evaluate", point, one, reference::exactForce(model_, point));
  }

  void check(const char* who, const Point& point, const Evaluation& force, const std::optional<mpq_class>& exact) {
    if (force.fired != exact.has_value()) {
      return disagree(who, point, textOf(force) + (exact ? ", wanted fired" : ", wanted not fired"));
    }
    if (!exact) {
      if (force.force_n != model_.default_force_n) disagree(who, point, textOf(force) + ", wanted the default force");
      return;
    }
    if (!std::isfinite(force.force_n)) return disagree(who, point, textOf(force));
    const double error = std::abs(mpq_class(mpq_class(force.force_n) - *exact).get_d());
    found_.largest_share = std::max(found_.largest_share, error / bound(force.force_n));
    if (error > bound(force.force_n)) {
      disagree(
          who, point,
          textOf(force) + ", wanted " + base::formatNumber(exact->get_d()) + ", off by " + base::formatNumber(error));
    }
  }

  void checkEntryPoint(const char* who, const Point& point, const Evaluation& force, const Evaluation& one) {
    const bool both_nan = std::isnan(force.force_n) && std::isnan(one.force_n);
    const double ulps = both_nan ? 0 : entryPointUlps(force.force_n, one.force_n, model_.output.min);
    if (one.fired && !std::isnan(ulps)) found_.largest_ulps = std::max(found_.largest_ulps, ulps);
    const bool close = one.fired ? ulps <= 4 || std::abs(force.force_n - one.force_n) <= bound(one.force_n)
                                 : both_nan || force.force_n == one.force_n;
    if (force.fired != one.fired || !close) disagree(who, point, textOf(force) + ", one point gives " + textOf(one));
  }

  const ForceModel& model_;
  base::Random& random_;
  std::vector<std::optional<double>> fixed_;
  std::vector<std::size_t> free_;
  Agreement found_;
};

}  // namespace

double entryPointUlps(double a, double b, double output_min) {
  if (a == b) return 0;
  const double magnitude = std::max({std::abs(a), std::abs(b), std::abs(a - output_min), std::abs(b - output_min)});
  return std::abs(a - b) / ulpOf(magnitude);
}

Agreement checkBuildment(const ForceModel& model, base::Random& random, int points) {
  return Checker(model, random).run(points);
}

}  // namespace tactus::stress
