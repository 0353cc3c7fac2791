#include "core/analysis/force_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/analysis/centroid_bound.h"
#include "core/analysis/rule_table.h"

namespace tactus::analysis {
namespace {

using Cache = std::map<std::vector<BoundedTerm>, ForceBounds>;

std::optional<ForceBounds> boundsOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, Cache& cache) {
  const double lo = model.output.min;
  const double hi = model.output.max;
  const auto& terms = termsFor(expert, model.output);
  const auto strengths = largestStrengths(model, expert, resolveRules(model, expert));
  const bool clip = model.implication == fuzzy::Implication::kClip;
  std::vector<BoundedTerm> upright;
  std::vector<BoundedTerm> mirrored;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (strengths[t] == 0) continue;
    const auto f = fuzzy::MembershipFunction::of(terms[t]);
    const BoundedTerm term = BoundedTerm::of(f, clip ? strengths[t] : 1);
    upright.push_back(term.from(lo));
    mirrored.push_back(term.mirroredAt(hi));
  }
  if (upright.empty()) return std::nullopt;
  const auto [it, fresh] = cache.try_emplace(upright);
  if (fresh) {
    const double width = hi - lo;
    // One ulp of a position may be more than the margin where the universe is narrow and far from 0.
    const double margin =
        kRounding * width + 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lo), std::abs(hi));
    it->second = {std::max(lo, lo + lowerCentroidBound(upright, clip, width) - margin),
                  std::min(hi, hi - lowerCentroidBound(mirrored, clip, width) + margin)};
  }
  return it->second;
}

/// Smallest mean of values with weights: those in `always` count in any case, any of the others may.
struct Weighted {
  double value, weight;
  bool always;
};

double smallestMean(std::vector<Weighted> all) {
  double weights = 0;
  double sum = 0;
  for (const auto& item : all) {
    if (!item.always) continue;
    weights += item.weight;
    sum += item.weight * item.value;
  }
  std::sort(all.begin(), all.end(), [](const Weighted& x, const Weighted& y) { return x.value < y.value; });
  if (weights == 0) return all.front().value;
  for (const auto& item : all) {
    if (item.always || item.value >= sum / weights) continue;
    weights += item.weight;
    sum += item.weight * item.value;
  }
  return sum / weights;
}

}  // namespace

std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, std::size_t expert) {
  Cache cache;
  return boundsOf(model, model.experts[expert], cache);
}

std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, const std::vector<bool>& always_fires) {
  Cache cache;
  const std::vector<double> weights = normalizedWeights(model);
  std::vector<Weighted> low;
  std::vector<Weighted> high;
  const double lo = model.output.min;
  const double hi = model.output.max;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const double weight = weights[e];
    if (weight == 0) continue;
    const auto bounds = boundsOf(model, model.experts[e], cache);
    if (!bounds) continue;
    low.push_back({bounds->min_n - lo, weight, always_fires[e]});
    high.push_back({hi - bounds->max_n, weight, always_fires[e]});
  }
  if (low.empty()) return std::nullopt;
  const double margin =
      kRounding * (hi - lo) + 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lo), std::abs(hi));
  return ForceBounds{std::max(lo, lo + smallestMean(low) - margin), std::min(hi, hi - smallestMean(high) + margin)};
}

}  // namespace tactus::analysis
