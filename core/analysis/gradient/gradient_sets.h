// Output sets after implication, cut into lines, and the sums that make a gradient of them.
#pragma once

#include <array>
#include <span>

#include "core/analysis/gradient/gradient_centroid.h"
#include "core/fuzzy/implied_trapezoid.h"

namespace tactus::analysis {

using fuzzy::Position;

/// A term after implication: a trapezoid, or a Gaussian, which ends where it is 0 in double precision, and has no
/// plateau where nothing clips it.
struct ImpliedSet : fuzzy::ImpliedTrapezoid {
  double log_ramp;  ///< logarithm of `ramp_height`, for Gaussians

  static ImpliedSet of(const fuzzy::ActiveTerm& term, fuzzy::Implication implication, double largest) noexcept;

  /// Height at x in [left, right].
  double at(const Position& x) const noexcept;
  /// Height just left of x, and just right of it.
  double leftLimit(const Position& x) const noexcept { return left < x && x <= right ? at(x) : 0; }
  double rightLimit(const Position& x) const noexcept { return left <= x && x < right ? at(x) : 0; }
};

enum class Part { kRise, kTop, kFall };

/// A set over an interval in which it is a line.
struct Line {
  std::size_t set;
  Part part;
  double y0, y1;          ///< heights at the two ends
  double climb;           ///< |y1 - y0|, without cancellation
  double share0, share1;  ///< membership at the two ends, on ramps
  double rest0, rest1;    ///< 1 - membership, without cancellation

  /// `set` between x0 and x1, neighbouring corners in [left, right].
  static Line of(std::size_t index, const ImpliedSet& set, const Position& x0, const Position& x1) noexcept;
};

/// Integrals over the pieces of the maximum: its area and first moment, and the same of the derivatives of the maximum
/// with respect to the points and the logarithm of the strength of each set. Heights are relative to the largest
/// strength, positions to an origin of the caller's.
class GradientSums {
 public:
  GradientSums(std::span<const ImpliedSet> sets, fuzzy::Implication implication) noexcept;

  /// Adds the part of a line between the shares t0 < t1 in [0, 1] of its interval, which begins at x0.
  void addLine(const Line& line, double x0, double width, double t0, double t1) noexcept;
  /// Adds mass at one position of a Gaussian, `u` sigmas from its mean.
  void addGaussianMass(std::size_t set, double x, double mass, double u) noexcept;
  /// Adds what the vertices of vertical edges in [lo, hi] do.
  void addVerticalEdges(double lo, double hi, const Position& origin) noexcept;

  /// The centroid measured from the origin, and the derivatives.
  double finish(std::span<SetGradient> out) const noexcept;

 private:
  static constexpr std::size_t kStrength = 4;  ///< after the points
  struct Integral {
    double mass, moment;
  };

  void add(std::size_t set, std::size_t parameter, double mass, double moment) noexcept {
    auto& sum = of_set_[set][parameter];
    sum.mass += mass;
    sum.moment += moment;
  }
  /// A vertical edge at x, as the limit of a ramp: what its outer vertex does above the height `outer_from`, and its
  /// inner one above `inner_from`.
  void addEdge(std::size_t set, std::size_t outer, std::size_t inner, double x, double outer_from,
               double inner_from) noexcept;

  std::span<const ImpliedSet> sets_;
  bool scale_;
  Integral whole_{0, 0};
  std::array<std::array<Integral, 5>, fuzzy::kMostTerms> of_set_;
};

/// The sweep where Gaussians are among the sets: crossings are bisected to the last bit, pieces of Gaussians integrated
/// by ten-point Gauss-Legendre quadrature. `corners` are sorted.
void sweepWithGaussians(std::span<const ImpliedSet> sets, std::span<const Position> corners,
                        GradientSums& sums) noexcept;

}  // namespace tactus::analysis
