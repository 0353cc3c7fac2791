#include "elicitation/fcm.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "elicitation/fcm_descent.h"
#include "elicitation/fcm_samples.h"
#include "elicitation/fcm_starts.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::Result;

constexpr double kLargestM = 100;          // u^m of many clusters underflows beyond it
constexpr double kPinningM = 5;            // above it J has a minimum at nearly every sample
constexpr std::size_t kMostCoarse = 1024;  // entries on which the starts are tried; more only cost time
constexpr std::size_t kMostRefined = 5;    // minima that are followed on all samples
constexpr int kWarmUp = 4;                 // steps of Bezdek's iteration before the first Newton step
constexpr double kSameMinimum = 1e-5;      // of the range: nearer results are one minimum
constexpr double kEqualObjective = 1e-12;  // relative difference of J that rounding explains

Result<void> checkInput(std::span<const double> samples, const FcmSettings& settings) {
  if (settings.clusters < 1 || settings.clusters > kMostClusters) {
    return fail(ErrorCode::kValue, "clusters", std::to_string(settings.clusters),
                "1 to " + std::to_string(kMostClusters));
  }
  if (!(settings.m > 1 && settings.m <= kLargestM)) {
    return fail(ErrorCode::kValue, "fuzziness m", formatNumber(settings.m),
                "a number above 1 and at most " + formatNumber(kLargestM));
  }
  if (samples.empty()) return fail(ErrorCode::kData, "samples", "none", "at least one for each cluster");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!std::isfinite(samples[i])) {
      return fail(ErrorCode::kValue, "sample " + std::to_string(i + 1), formatNumber(samples[i]), "a finite number");
    }
  }
  return {};
}

bool near(const std::vector<double>& a, const std::vector<double>& b, double distance) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::abs(a[k] - b[k]) > distance) return false;
  }
  return true;
}

/// Adds `found` unless the same place is there already.
void addDistinct(std::vector<FcmDescent>& list, FcmDescent found, double distance) {
  for (const auto& other : list) {
    if (near(other.centres, found.centres, distance)) return;
  }
  list.push_back(std::move(found));
}

/// By J; where rounding alone could decide, the one that was found first.
void sortByObjective(std::vector<FcmDescent>& list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const FcmDescent& a, const FcmDescent& b) { return a.objective < b.objective; });
}

std::vector<FcmDescent> tryStarts(const ScaledSamples& samples, const FcmSettings& settings) {
  const CoarseSamples coarse(samples.values(), std::max(kMostCoarse, 8 * settings.clusters));
  const WeightedValues data = coarse.view();
  base::Random random(settings.seed);
  std::vector<FcmDescent> found;
  for (int start = 0; start < std::max(settings.starts, 1); ++start) {
    std::vector<double> centres = start == 0   ? quantileStart(data, settings.clusters)
                                  : start == 1 ? equalWidthStart(data, settings.clusters)
                                               : spreadStart(data, settings.clusters, random);
    if (centres.size() < settings.clusters) continue;
    addDistinct(found, descend(data, std::move(centres), samples.range(), kWarmUp, settings),
                kSameMinimum * samples.range());
  }
  sortByObjective(found);
  return found;
}

std::vector<double> original(const ScaledSamples& samples, const std::vector<double>& centres) {
  std::vector<double> out = centres;
  for (double& centre : out) centre = samples.toOriginal(centre);
  return out;
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
                              " is above 5: the centres pin to single samples, and J has many minima.");
  }
  if (result.stop == FcmStop::kIterationLimit) {
    result.warnings.push_back("The iterations ran out after " + std::to_string(result.iterations) +
                              " steps; the centres are not final.");
  }
  if (!result.other_minima.empty() && result.other_minima.front().objective_ratio < 1.01) {
    result.warnings.push_back(
        "Another minimum of J is within 1 % of the one kept: the data do not decide between them.");
  }
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
  if (auto ok = checkInput(samples, settings); !ok) return tl::unexpected(ok.error());
  const ScaledSamples scaled(samples);
  const auto distinct = scaled.firstDistinct();
  if (distinct.size() < settings.clusters) {
    return fail(ErrorCode::kData, "samples",
                std::to_string(distinct.size()) + (distinct.size() == 1 ? " distinct value" : " distinct values"),
                "at least " + std::to_string(settings.clusters) + ", one for each cluster");
  }

  FcmResult result;
  result.m = settings.m;
  if (distinct.size() == settings.clusters) {
    result.centres.assign(distinct.begin(), distinct.end());
    result.objective = 0;
    result.stop = FcmStop::kExact;
    addWarnings(result);
    return result;
  }

  std::vector<FcmDescent> refined;
  std::vector<FcmDescent> tried = tryStarts(scaled, settings);
  TACTUS_CHECK(!tried.empty());
  if (tried.size() > kMostRefined) tried.resize(kMostRefined);
  for (auto& start : tried) {
    FcmDescent end = descend({scaled.values(), {}}, start.centres, scaled.range(), 0, settings);
    end.iterations += start.iterations;
    addDistinct(refined, std::move(end), kSameMinimum * scaled.range());
  }
  // Of equally low minima the first found stays, so that rounding does not choose.
  auto best = refined.begin();
  for (auto it = refined.begin(); it != refined.end(); ++it) {
    if (it->objective < best->objective * (1 - kEqualObjective)) best = it;
  }
  std::rotate(refined.begin(), best, best + 1);
  const FcmDescent& kept = refined.front();
  result.centres = original(scaled, kept.centres);
  if (std::adjacent_find(result.centres.begin(), result.centres.end(), std::greater_equal<>()) !=
      result.centres.end()) {
    return fail(ErrorCode::kData, "samples", "clusters too close together for the range of the values",
                "values whose clusters double precision can tell apart");
  }
  setObjective(result, kept.objective, scaled.objectiveExponent());
  result.iterations = kept.iterations;
  result.stop = kept.converged ? FcmStop::kConverged : FcmStop::kIterationLimit;
  std::vector<FcmDescent> others(refined.begin() + 1, refined.end());
  sortByObjective(others);
  for (const auto& other : others) {
    if (!other.minimum) continue;
    result.other_minima.push_back({original(scaled, other.centres), other.objective / kept.objective});
  }
  addWarnings(result);
  return result;
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
