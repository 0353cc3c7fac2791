// A lower bound on the centroid of all output sets that the given terms can form. Internal to the bounds on the force.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

// Sampled centroids, as other fuzzy tools compute them. Only for comparison with the exact one.

struct Sampling {
  enum class Rule {
    kMidpoint,  ///< centers of `count` equal cells (fuzzylite)
    kLinspace,  ///< `count` points from end to end (MATLAB, Octave)
  };
  Rule rule = Rule::kMidpoint;
  std::size_t count = 1000;
};

/// The force with sampled instead of exact centroids. Averaging and abstaining as in CompiledModel. `expert`: this
/// expert alone. NaN if a rule fires but its output set lies between the samples.
fuzzy::Evaluation evaluateSampled(const fuzzy::CompiledModel& model, std::span<const double> inputs,
                                  const Sampling& sampling, std::optional<std::size_t> expert = std::nullopt);

// The contribution of a rule's output term to the moments of an output set. Internal to the bounds on the force.

/// An output term of some rule, on a universe that starts at 0. A Gaussian has b = c = mean and infinite a and d.
struct BoundedTerm {
  double a, b, c, d;
  double sigma;     ///< 0 for a trapezoid
  double strength;  ///< the largest one possible

  static BoundedTerm of(const fuzzy::MembershipFunction& f, double strength) {
    if (f.gaussian)
      return {-std::numeric_limits<double>::infinity(), f.mean,  f.mean,
              std::numeric_limits<double>::infinity(),  f.sigma, strength};
    return {f.a, f.b, f.c, f.d, 0, strength};
  }
  /// The term relative to `origin`, and mirrored at it.
  BoundedTerm from(double origin) const { return {a - origin, b - origin, c - origin, d - origin, sigma, strength}; }
  BoundedTerm mirroredAt(double origin) const {
    return {origin - d, origin - c, origin - b, origin - a, sigma, strength};
  }
  bool gaussian() const { return sigma > 0; }
  /// Half the width of a Gaussian at height `h` in (0, 1].
  double reachAt(double h) const { return sigma * std::sqrt(-2 * std::log(h)); }

  bool operator<(const BoundedTerm& other) const {
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

/// Moments about `about` in [0, width] of the term, clipped at `strength` in (0, 1] and cut to [0, width], divided by
/// the strength.
Moments momentsOf(const BoundedTerm& term, double strength, double about, double width);

/// Largest error of the moments as a share of the universe, with a wide margin.
inline constexpr double kRounding = 1e-12;

/// The largest c in [0, width] with a proof that c is a lower bound of the centroid (method: lint.h). Too small
/// by less than kRounding * width. `terms`: not empty, on a universe that starts at 0. `clip`: terms are clipped at any
/// strength up to their own; otherwise they are scaled.
double lowerCentroidBound(const std::vector<BoundedTerm>& terms, bool clip, double width);

}  // namespace tactus::analysis
