#include "core/analysis/force_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/analysis/rule_table.h"
#include "core/fuzzy/gaussian_pieces.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// The largest error of the moments below, as a share of the universe, with a wide margin.
constexpr double kRounding = 1e-12;
// Moments below this lose digits.
constexpr double kTiny = 1e-280;

/// An output term that rules can conclude, on a universe that starts at 0. A Gaussian has its mean for b and c, and no
/// ends.
struct Candidate {
  double a, b, c, d;
  double sigma;     ///< 0 for a trapezoid
  double strength;  ///< the largest one

  static Candidate of(const fuzzy::MembershipFunction& f, double strength) {
    if (f.gaussian) return {-kInfinity, f.mean, f.mean, kInfinity, f.sigma, strength};
    return {f.a, f.b, f.c, f.d, 0, strength};
  }
  /// As seen from `origin`, and mirrored there.
  Candidate from(double origin) const { return {a - origin, b - origin, c - origin, d - origin, sigma, strength}; }
  Candidate mirroredAt(double origin) const {
    return {origin - d, origin - c, origin - b, origin - a, sigma, strength};
  }
  bool gaussian() const { return sigma > 0; }

  bool operator<(const Candidate& other) const {
    return std::tie(a, b, c, d, sigma, strength) <
           std::tie(other.a, other.b, other.c, other.d, other.sigma, other.strength);
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

/// Half the width of a Gaussian at height `h`.
double reachAt(const Candidate& term, double h) { return term.sigma * std::sqrt(-2 * std::log(h)); }

/// Adds the part of a Gaussian, relative to `strength`, between x0 and x1, cut to [0, width] and at `about`. Sums of
/// positive masses, exact to rounding (gaussian_pieces.h).
void addTail(const Candidate& term, double strength, double x0, double x1, double about, double width, Moments& out) {
  const fuzzy::CurvePiece curve{true, 0, 0, 0, term.b, term.sigma, -std::log(strength)};
  const double from = std::clamp(x0, 0.0, width);
  const double to = std::clamp(x1, 0.0, width);
  const double middle = std::clamp(about, from, to);
  const auto add = [&](double x, double mass) { (x < about ? out.left : out.right) += mass * std::abs(x - about); };
  fuzzy::visitGaussianMasses(curve, from, middle, add);
  fuzzy::visitGaussianMasses(curve, middle, to, add);
}

/// Moments of the term clipped at `strength`, divided by it.
Moments clipped(const Candidate& term, double strength, double about, double width) {
  Moments out;
  if (term.gaussian()) {
    const double plateau = reachAt(term, strength);
    // Beyond this the tail is e^-60 of the highest point in the universe, far below rounding.
    const double nearest = std::max({plateau, -term.b, term.b - width});
    const double end = std::sqrt(nearest * nearest + 120 * term.sigma * term.sigma);
    addTail(term, strength, term.b - end, term.b - plateau, about, width, out);
    addLine(term.b - plateau, term.b + plateau, 1, 1, about, width, out);
    addTail(term, strength, term.b + plateau, term.b + end, about, width, out);
    if (out.left + out.right < kTiny) out.left = kInfinity;  // too far away to be computed: nothing is proved
    return out;
  }
  const double left = std::min(term.b, term.a + strength * (term.b - term.a));
  const double right = std::max(term.c, term.d - strength * (term.d - term.c));
  addLine(term.a, left, 0, 1, about, width, out);
  addLine(left, right, 1, 1, about, width, out);
  addLine(right, term.d, 1, 0, about, width, out);
  return out;
}

/// The cuts of a term at the heights up to its largest strength. Their ends, as the universe shows them, are piecewise
/// linear in a level that rises with the height: the height itself for a trapezoid, the reach from the mean with the
/// sign turned for a Gaussian.
class Cuts {
 public:
  Cuts(const Candidate& term, double width) : term_(term), width_(width) {
    if (term.gaussian()) {
      const double top = -reachAt(term, term.strength);
      const double bottom = std::min(top, -fuzzy::kGaussianReach * term.sigma);
      corners_ = {bottom, std::clamp(-term.b, bottom, top), std::clamp(term.b - width, bottom, top), top};
    } else {
      corners_ = {0, term.strength, term.strength, term.strength};
      if (term.a < 0 && term.b > term.a) corners_[1] = std::min(term.strength, -term.a / (term.b - term.a));
      if (term.d > width && term.d > term.c)
        corners_[2] = std::min(term.strength, (term.d - width) / (term.d - term.c));
    }
    std::sort(corners_.begin(), corners_.end());
  }

  /// Levels between which the ends are linear, from the lowest to the highest.
  const std::array<double, 4>& corners() const { return corners_; }
  double heightAt(double level) const {
    if (!term_.gaussian()) return level;
    const double u = level / term_.sigma;
    return level == corners_.back() ? term_.strength : std::exp(-0.5 * u * u);
  }
  double left(double level) const {
    return std::max(0.0, term_.gaussian() ? term_.b + level : term_.a + level * (term_.b - term_.a));
  }
  double right(double level) const {
    return std::min(width_, term_.gaussian() ? term_.b - level : term_.d - level * (term_.d - term_.c));
  }

 private:
  const Candidate& term_;
  double width_;
  std::array<double, 4> corners_;
};

/// The smallest weight of the right-hand side with which the term has no negative moment about `about` at any strength
/// in (0, largest], clip. The moment as a function of the strength is the integral of that of the cuts, whose sign
/// changes where a piecewise linear function does, so its minimum lies at a zero of that function, at one of its
/// corners or at the largest strength; the weight is found by Dinkelbach's iteration (1967) for the largest ratio.
double weightForClip(const Candidate& term, double about, double width) {
  const Cuts cuts(term, width);
  const auto& corners = cuts.corners();

  double weight = 0;
  const auto consider = [&](double level) {
    const double strength = cuts.heightAt(level);
    if (strength > 0) weight = std::max(weight, clipped(term, strength, about, width).ratio());
  };
  // Strengths towards 0: the whole support, and of a Gaussian also the whole universe.
  const auto consider_cut = [&](double left, double right) {
    const double ratio = right > about ? std::max(0.0, about - left) / (right - about) : kInfinity;
    weight = std::max(weight, ratio * ratio);
  };
  consider_cut(cuts.left(corners[0]), cuts.right(corners[0]));
  if (term.gaussian()) consider_cut(0, width);
  for (const double corner : corners) consider(corner);
  for (int round = 0; round < 50 && weight <= 1; ++round) {
    const double before = weight;
    const double root = std::sqrt(weight);
    const auto sign = [&](double level) { return root * (cuts.right(level) - about) + (cuts.left(level) - about); };
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
      if (std::min(term.d, width) <= about) return false;  // also where it is too narrow to have a moment
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
    const Candidate term = Candidate::of(f, clip ? strengths[t] : 1);
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
