#include "app/bundle/file_errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "app/bundle/compiled_source.h"
#include "core/analysis/sampled_centroid.h"

namespace tactus::bundle {
namespace {

constexpr double kRounding = 1e-12;

/// The next number with two digits above `value`.
double rounded(double value) {
  if (value <= 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::ceil(value / unit) * unit;
}

/// `difference(point)`: of the force there; nothing where there is none to compare.
model_io::Promise measured(std::string rule, double tolerance_n, const std::vector<std::vector<double>>& points,
                           const std::function<double(std::span<const double>)>& difference) {
  model_io::Promise promise{std::move(rule), tolerance_n, 0, {}};
  for (const auto& point : points) {
    const double error_n = std::abs(difference(point));
    if (!(error_n > promise.largest_error_n)) continue;
    promise.largest_error_n = error_n;
    promise.at = point;
  }
  promise.tolerance_n = std::max(promise.tolerance_n, rounded(promise.largest_error_n));
  return promise;
}

}  // namespace

model_io::Promise promiseOf(exchange::Dialect dialect, const fuzzy::CompiledModel& model, std::size_t expert,
                            const std::vector<std::vector<double>>& points) {
  using Rule = analysis::Sampling::Rule;
  const exchange::ReaderRule reader = exchange::readerRule(dialect);
  const analysis::Sampling sampling{reader.midpoint ? Rule::kMidpoint : Rule::kLinspace, reader.count};
  const double range_n = model.outputMax() - model.outputMin();
  const std::string rule = (reader.midpoint ? "midpoint:" : "linspace:") + std::to_string(reader.count);
  return measured(rule, reader.tolerance * range_n, points, [&](std::span<const double> point) {
    const auto exact = model.evaluateExpert(expert, point);
    if (!exact.fired) return 0.0;
    const double sampled_n = analysis::evaluateSampled(model, point, sampling, expert).force_n;
    // The set lies between the samples: such a reader may give anything.
    return std::isnan(sampled_n) ? range_n : sampled_n - exact.force_n;
  });
}

model_io::Promise promiseOf(const BoundedTable& table, const fuzzy::CompiledModel& model,
                            const std::vector<std::vector<double>>& points) {
  model_io::Promise promise = errorOf(table.table, model, points);
  promise.tolerance_n = std::max(promise.tolerance_n, rounded(table.bound.bound_n));
  return promise;
}

model_io::Promise errorOf(const ForceTable& table, const fuzzy::CompiledModel& model,
                          const std::vector<std::vector<double>>& points) {
  return measured("table", 0, points,
                  [&](std::span<const double> point) { return table.force(point) - model.evaluate(point).force_n; });
}

model_io::Promise exactPromise(const fuzzy::ForceModel& model) {
  return {"exact", kRounding * (model.output.max - model.output.min), 0, {}};
}

model_io::Promise promiseOf(const exchange::CSource& source, const fuzzy::CompiledModel& model,
                            const std::vector<std::vector<double>>& points, const std::stop_token& stop) {
  const double bound_n = kRounding * (model.outputMax() - model.outputMin());
  const auto forces = forcesOf(source, points, stop);
  if (!forces) {
    model_io::Promise promise{"exact", bound_n, bound_n, {}};
    promise.measured = false;
    return promise;
  }
  std::size_t next = 0;
  return measured("exact", bound_n, points, [&](std::span<const double> point) {
    const double difference = (*forces)[next++] - model.evaluate(point).force_n;
    // A force that is none at all.
    return std::isnan(difference) ? model.outputMax() - model.outputMin() : difference;
  });
}

}  // namespace tactus::bundle
