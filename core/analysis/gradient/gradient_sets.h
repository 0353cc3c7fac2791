// Output sets after implication, cut into lines, and the sums for their gradient.
#pragma once

#include <array>
#include <span>

#include "core/analysis/gradient/gradient_centroid.h"
#include "core/fuzzy/implied_trapezoid.h"

namespace tactus::analysis {

using fuzzy::Position;

/// A term after implication: a trapezoid or a Gaussian. A Gaussian ends where it is 0 in double precision, and has a
/// plateau only if it is clipped.
struct ImpliedSet : fuzzy::ImpliedTrapezoid {
  double log_ramp;  ///< logarithm of `ramp_height`, for Gaussians

  static ImpliedSet of(const fuzzy::ActiveTerm& term, fuzzy::Implication implication, double largest) noexcept;

  /// Height at x in [left, right].
  double at(const Position& x) const noexcept;
  /// Left limit and right limit of the height at x.
  double leftLimit(const Position& x) const noexcept { return left < x && x <= right ? at(x) : 0; }
  double rightLimit(const Position& x) const noexcept { return left <= x && x < right ? at(x) : 0; }
};

enum class Part { kRise, kTop, kFall };

/// A set on an interval on which it is a line.
struct Line {
  std::size_t set;
  Part part;
  double y0, y1;          ///< heights at the two ends
  double climb;           ///< |y1 - y0|, without cancellation
  double share0, share1;  ///< membership at the two ends, on ramps
  double rest0, rest1;    ///< 1 - membership, without cancellation

  /// The line of `set` between x0 and x1, neighboring corners in [left, right].
  static Line of(std::size_t index, const ImpliedSet& set, const Position& x0, const Position& x1) noexcept;
};

/// Integrals over the pieces of the maximum: its area and first moment, and the same for its derivatives with respect
/// to the points and the logarithm of the strength of each set. Heights are relative to the largest strength, positions
/// to an origin chosen by the caller.
class GradientSums {
 public:
  GradientSums(std::span<const ImpliedSet> sets, fuzzy::Implication implication) noexcept;

  /// Adds a part of a line, between the shares t0 < t1 in [0, 1] of its interval. The interval starts at x0.
  void addLine(const Line& line, double x0, double width, double t0, double t1) noexcept;
  /// Adds a mass at one position of a Gaussian, `u` sigmas from its mean.
  void addGaussianMass(std::size_t set, double x, double mass, double u) noexcept;
  /// Adds the contribution of the vertices of vertical edges in [lo, hi].
  void addVerticalEdges(double lo, double hi, const Position& origin) noexcept;

  /// Returns the centroid measured from the origin, and writes the derivatives.
  double finish(std::span<SetGradient> out) const noexcept;

 private:
  static constexpr std::size_t kStrength = 4;  ///< index after the points
  struct Integral {
    double mass, moment;
  };

  void add(std::size_t set, std::size_t parameter, double mass, double moment) noexcept {
    auto& sum = of_set_[set][parameter];
    sum.mass += mass;
    sum.moment += moment;
  }
  /// Adds a vertical edge at x as the limit of a ramp: its outer vertex above the height `outer_from`, its inner vertex
  /// above `inner_from`.
  void addEdge(std::size_t set, std::size_t outer, std::size_t inner, double x, double outer_from,
               double inner_from) noexcept;

  std::span<const ImpliedSet> sets_;
  bool scale_;
  Integral whole_{0, 0};
  std::array<std::array<Integral, 5>, fuzzy::kMostTerms> of_set_;
};

/// The sweep for sets that include Gaussians. Crossings are bisected to the last bit; pieces of Gaussians are
/// integrated by ten-point Gauss-Legendre quadrature. `corners`: sorted.
void sweepWithGaussians(std::span<const ImpliedSet> sets, std::span<const Position> corners,
                        GradientSums& sums) noexcept;

}  // namespace tactus::analysis
