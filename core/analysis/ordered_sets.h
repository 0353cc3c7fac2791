// Derivatives of the centroid of ordered output terms in closed form.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/input_pieces.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

/// The rise and the fall of a term side by side: mirror images in one SSE2 register.
using TwoRamps = double __attribute__((vector_size(2 * sizeof(double))));

/// The derivatives of the centroid with respect to one term.
struct LaneGradient {
  TwoRamps foot;      ///< derivatives with respect to a and d
  TwoRamps shoulder;  ///< with respect to b and c
  double strength;
};

/// The output terms of an expert in order. Lane k holds the k-th term.
///
/// Only a part of the rise, the top and the fall of an active set is visible; neighboring active sets cover the rest.
/// The visible part follows from the strengths of the two. With heights relative to the term, m in [t, top] is the
/// visible part of a ramp (top = strength for clip, 1 for scale). So area, moment and their derivatives are polynomials
/// in t and top. They are sums of visible parts, never differences of whole areas, so no digits cancel. Derivatives
/// with respect to the vertices of a ramp are integrals over its height and also hold for a vertical edge.
class OrderedSets {
 public:
  static constexpr std::size_t kMostLanes = 63;  ///< one bit per lane, and one for the end
  static constexpr double kSmallestStrength = 1e-60;
  /// Indexed by lane; 0 at count(). The last one is spare.
  using Strengths = std::array<double, kMostLanes + 2>;
  static constexpr std::size_t kSpare = kMostLanes + 1;
  using Gradients = std::array<LaneGradient, kMostLanes>;  ///< by lane

  /// Nothing if the terms lack the form: a Gaussian, no order, sets that reach beyond the second next one, ramps cut by
  /// the universe [lo, hi], coinciding edges or ramps, widths below a thousandth of the universe.
  static std::optional<OrderedSets> of(std::span<const fuzzy::MembershipFunction> terms,
                                       std::span<const TermSlots> slots, double lo, double hi,
                                       fuzzy::Implication implication);

  std::size_t count() const noexcept { return lanes_.size() - 1; }
  std::size_t laneOf(std::size_t term) const noexcept { return lane_of_[term]; }
  const TermSlots& slotsOf(std::size_t lane) const noexcept { return lanes_[lane].slots; }

  /// Derivatives of the centroid. `active`: one bit per lane with a strength > 0, at least one. Returns the centroid
  /// measured from the lower end of the universe. Nothing if the general sweep is needed: a strength below
  /// kSmallestStrength, or two sets that overlap above a weaker one between them.
  /// Thread: any. Real-time safe: yes.
  std::optional<double> centroid(const Strengths& strength, std::uint64_t active, Gradients& out) const noexcept;

 private:
  /// A lane and a later one, both active, with no active lane between them.
  struct Pair {
    double overlap = 0;      ///< width of the overlap
    double peak = 0;         ///< height at which the ramps cross; above this strength the overlap no longer grows
    double least_ratio = 1;  ///< ratio of strengths (other to first) above which the other covers the end of the first
  };
  struct Lane {
    TwoRamps foot{};            ///< a and d within the universe
    TwoRamps width{};           ///< b - a and d - c
    TwoRamps inwards{};         ///< direction from the foot to the shoulder: b - a and c - d
    TwoRamps moves_foot{};      ///< gain of the ramp if the foot moves by 1: -1 and 1; 0 if it is not visible
    TwoRamps moves_shoulder{};  ///< the same for the shoulder
    std::array<Pair, 3> pairs;  ///< with the next lane, the one after it, and any other
    double cover = 0;  ///< strength at which the lane covers the overlap of its neighbors, >= kSmallestStrength
    TermSlots slots{};
  };
  struct Shown;

  template <bool clip>
  std::optional<double> centroidOf(const Strengths& strength, std::uint64_t active, Gradients& out) const noexcept;

  double lo_ = 0;
  bool clip_ = true;
  std::vector<Lane> lanes_;  ///< plus one without a term
  std::vector<std::size_t> lane_of_;
};

}  // namespace tactus::analysis
