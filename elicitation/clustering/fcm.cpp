#include "elicitation/clustering/fcm.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/text.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_search.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::Result;

constexpr double kLargestM = 100;  // u^m of many clusters underflows beyond it
constexpr double kPinningM = 5;    // above it J has a minimum at nearly every sample

Result<void> checkSettings(const FcmSettings& settings) {
  if (settings.clusters < 1 || settings.clusters > kMostClusters) {
    return fail(ErrorCode::kValue, "clusters", std::to_string(settings.clusters),
                "1 to " + std::to_string(kMostClusters));
  }
  if (!(settings.m > 1 && settings.m <= kLargestM)) {
    return fail(ErrorCode::kValue, "fuzziness m", formatNumber(settings.m),
                "a number above 1 and at most " + formatNumber(kLargestM));
  }
  return {};
}

std::vector<double> original(const FcmData& data, std::vector<double> centres) {
  for (double& centre : centres) centre = data.toOriginal(centre);
  return centres;
}

void setObjective(FcmResult& result, double scaled, int exponent) {
  if (scaled == 0) {
    result.objective = 0;
    return;
  }
  result.objective_log10 = std::log10(scaled) + exponent * std::log10(2.0);
  const double value = std::ldexp(scaled, exponent);
  if (std::isnormal(value)) result.objective = value;
}

void addWarnings(FcmResult& result) {
  if (result.m > kPinningM) {
    result.warnings.push_back("Fuzziness m = " + formatNumber(result.m) +
                              " is above 5: the centers pin to single samples, and J has many minima.");
  }
  if (result.stop == FcmStop::kIterationLimit) {
    result.warnings.push_back("The iterations ran out after " + std::to_string(result.iterations) +
                              " steps; the centers are not final.");
  }
  if (!result.other_minima.empty() && result.other_minima.front().objective_ratio < 1.01) {
    result.warnings.push_back(
        "Another minimum of J is within 1 % of the one kept: the data do not decide between them.");
  }
}

Result<FcmResult> fuzzyCMeansOf(std::span<const double> samples, std::span<const double> weights,
                                const FcmSettings& settings) {
  if (auto ok = checkSettings(settings); !ok) return tl::unexpected(ok.error());
  const auto data = prepareFcmData(samples, weights);
  if (!data) return tl::unexpected(data.error());
  const auto distinct = distinctValues(*data, settings.clusters + 1);
  if (distinct.size() < settings.clusters) {
    return fail(ErrorCode::kData, "samples",
                std::to_string(distinct.size()) + (distinct.size() == 1 ? " distinct value" : " distinct values"),
                "at least " + std::to_string(settings.clusters) + ", one for each cluster");
  }

  FcmResult result;
  result.m = settings.m;
  if (distinct.size() == settings.clusters) {
    result.centres = distinct;
    result.objective = 0;
    result.stop = FcmStop::kExact;
    addWarnings(result);
    return result;
  }

  const FcmSearch found = searchMinima(*data, settings);
  if (found.canceled) {
    return fail(ErrorCode::kCancelled, "clustering", "a request to stop", "to go on to the end");
  }
  result.centres = original(*data, found.kept.centres);
  if (std::adjacent_find(result.centres.begin(), result.centres.end(), std::greater_equal<>()) !=
      result.centres.end()) {
    return fail(ErrorCode::kData, "samples", "clusters too close together for the range of the values",
                "values whose clusters double precision can tell apart");
  }
  setObjective(result, found.kept.objective, data->objectiveExponent());
  result.iterations = found.kept.iterations;
  result.passes = found.passes;
  result.stop = found.kept.converged ? FcmStop::kConverged : FcmStop::kIterationLimit;
  for (const auto& other : found.others) {
    result.other_minima.push_back({original(*data, other.centres), other.objective / found.kept.objective});
  }
  addWarnings(result);
  return result;
}

}  // namespace

std::string_view name(FcmStop stop) noexcept {
  switch (stop) {
    case FcmStop::kConverged:
      return "converged";
    case FcmStop::kExact:
      return "exact";
    case FcmStop::kIterationLimit:
      return "iteration_limit";
  }
  return "";
}

Result<FcmResult> fuzzyCMeans(std::span<const double> samples, const FcmSettings& settings) {
  return fuzzyCMeansOf(samples, {}, settings);
}

Result<FcmResult> fuzzyCMeans(std::span<const double> samples, std::span<const double> weights,
                              const FcmSettings& settings) {
  if (weights.empty() && !samples.empty()) {
    return fail(ErrorCode::kData, "weights", "none", std::to_string(samples.size()) + ", one for each sample");
  }
  return fuzzyCMeansOf(samples, weights, settings);
}

void fcmMemberships(double x, std::span<const double> centres, double m, std::span<double> memberships) noexcept {
  double nearest = std::numeric_limits<double>::infinity();
  for (const double centre : centres) nearest = std::min(nearest, std::abs(x - centre));
  double sum = 0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    const double distance = std::abs(x - centres[k]);
    memberships[k] = distance == nearest ? 1.0 : std::pow(nearest / distance, 2 / (m - 1));
    sum += memberships[k];
  }
  for (double& u : memberships) u /= sum;
}

}  // namespace tactus::elicitation
