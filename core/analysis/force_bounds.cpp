#include "core/analysis/force_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/analysis/rule_table.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The largest error of the moments below, as a share of the universe, with a wide margin.
constexpr double kRounding = 1e-12;

/// An output term that rules can conclude, on a universe that starts at 0.
struct Candidate {
  double a, b, c, d;
  double strength;  ///< the largest one

  bool operator<(const Candidate& other) const {
    return std::tie(a, b, c, d, strength) < std::tie(other.a, other.b, other.c, other.d, other.strength);
  }
};

/// Moments about a point, each >= 0.
struct Moments {
  double left = 0;
  double right = 0;

  double ratio() const { return left == 0 ? 0 : left / right; }
};

/// Adds the moment of a line from height y0 at x0 to y1 at x1; the piece lies on one side of `about`.
void addPiece(double x0, double x1, double y0, double y1, double about, Moments& out) {
  if (x1 <= x0) return;
  const double moment = (x1 - x0) * ((x0 - about) * (2 * y0 + y1) + (x1 - about) * (y0 + 2 * y1)) / 6;
  (moment < 0 ? out.left : out.right) += std::abs(moment);
}

/// Adds a line from height y0 at x0 to y1 at x1, cut to [0, width] and at `about`.
void addLine(double x0, double x1, double y0, double y1, double about, double width, Moments& out) {
  if (x1 <= x0) return;
  const auto at = [&](double x) { return y0 + (y1 - y0) * ((x - x0) / (x1 - x0)); };
  const double from = std::clamp(x0, 0.0, width);
  const double to = std::clamp(x1, 0.0, width);
  const double middle = std::clamp(about, from, to);
  addPiece(from, middle, at(from), at(middle), about, out);
  addPiece(middle, to, at(middle), at(to), about, out);
}

/// Moments of the term clipped at `strength`, divided by it.
Moments clipped(const Candidate& term, double strength, double about, double width) {
  const double left = std::min(term.b, term.a + strength * (term.b - term.a));
  const double right = std::max(term.c, term.d - strength * (term.d - term.c));
  Moments out;
  addLine(term.a, left, 0, 1, about, width, out);
  addLine(left, right, 1, 1, about, width, out);
  addLine(right, term.d, 1, 0, about, width, out);
  return out;
}

/// The smallest weight of the right-hand side with which the term has no negative moment about `about` at any strength
/// in (0, largest], clip. The moment as a function of the strength is the integral of that of the cuts, whose sign
/// changes where a piecewise linear function does, so its minimum lies at a zero of that function, at one of its
/// corners or at the largest strength; the weight is found by Dinkelbach's iteration (1967) for the largest ratio.
double weightForClip(const Candidate& term, double about, double width) {
  const auto left = [&](double h) { return std::max(0.0, term.a + h * (term.b - term.a)); };
  const auto right = [&](double h) { return std::min(width, term.d - h * (term.d - term.c)); };
  if (right(0) <= about) return kInfinity;

  std::array<double, 4> corners = {0, term.strength, term.strength, term.strength};
  if (term.a < 0 && term.b > term.a) corners[1] = std::min(term.strength, -term.a / (term.b - term.a));
  if (term.d > width && term.d > term.c) corners[2] = std::min(term.strength, (term.d - width) / (term.d - term.c));
  std::sort(corners.begin(), corners.end());

  double weight = 0;
  const auto consider = [&](double strength) {
    if (strength > 0) weight = std::max(weight, clipped(term, strength, about, width).ratio());
  };
  const double first = std::max(0.0, about - left(0)) / (right(0) - about);
  weight = first * first;  // strengths towards 0
  for (const double corner : corners) consider(corner);
  for (int round = 0; round < 50 && weight <= 1; ++round) {
    const double before = weight;
    const double root = std::sqrt(weight);
    const auto sign = [&](double h) { return root * (right(h) - about) + (left(h) - about); };
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const double y0 = sign(corners[k - 1]);
      const double y1 = sign(corners[k]);
      if (y0 < 0 && y1 > 0) consider(corners[k - 1] + (corners[k] - corners[k - 1]) * (y0 / (y0 - y1)));
    }
    if (weight <= before * (1 + 1e-14)) break;
  }
  return weight;
}

/// Largest c in [0, width] that is proved to be a lower bound of the centroid; `terms` is not empty.
double lowerBound(const std::vector<Candidate>& terms, bool clip, double width) {
  const auto proved = [&](double about) {
    double weights = 0;
    for (const auto& term : terms) {
      if (std::max(term.a, 0.0) >= about) continue;
      weights += clip ? weightForClip(term, about, width) : clipped(term, 1, about, width).ratio();
      if (weights > 1) return false;
    }
    return true;
  };
  double low = width;
  for (const auto& term : terms) low = std::min(low, std::max(term.a, 0.0));
  double high = width;
  // To an accuracy below the rounding that is taken off in the end.
  while (high - low > width * (kRounding / 4)) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (proved(middle) ? low : high) = middle;
  }
  return low;
}

using Cache = std::map<std::vector<Candidate>, ForceBounds>;

std::optional<ForceBounds> boundsOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, Cache& cache) {
  const double lo = model.output.min;
  const double hi = model.output.max;
  const auto& terms = termsFor(expert, model.output);
  const auto strengths = largestStrengths(model, expert, resolveRules(model, expert));
  const bool clip = model.implication == fuzzy::Implication::kClip;
  std::vector<Candidate> upright;
  std::vector<Candidate> mirrored;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (strengths[t] == 0) continue;
    const auto f = fuzzy::MembershipFunction::of(terms[t]);
    if (f.gaussian) return ForceBounds{lo, hi};
    const double strength = clip ? strengths[t] : 1;
    upright.push_back({f.a - lo, f.b - lo, f.c - lo, f.d - lo, strength});
    mirrored.push_back({hi - f.d, hi - f.c, hi - f.b, hi - f.a, strength});
  }
  if (upright.empty()) return std::nullopt;
  const auto [it, fresh] = cache.try_emplace(upright);
  if (fresh) {
    const double width = hi - lo;
    // One ulp of a position may be more than the margin where the universe is narrow and far from 0.
    const double margin =
        kRounding * width + 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lo), std::abs(hi));
    it->second = {std::max(lo, lo + lowerBound(upright, clip, width) - margin),
                  std::min(hi, hi - lowerBound(mirrored, clip, width) + margin)};
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
  double largest = 0;
  for (const auto& expert : model.experts) largest = std::max(largest, expert.weight);
  std::vector<Weighted> low;
  std::vector<Weighted> high;
  const double lo = model.output.min;
  const double hi = model.output.max;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto& expert = model.experts[e];
    const double weight = expert.weight / largest;
    if (weight == 0) continue;
    const auto bounds = boundsOf(model, expert, cache);
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
