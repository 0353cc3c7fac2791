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

/// The rise and the fall of a term side by side: mirror images, and one SSE2 register.
using TwoRamps = double __attribute__((vector_size(2 * sizeof(double))));

/// What one term does to the centroid.
struct LaneGradient {
  TwoRamps foot;      ///< derivatives with respect to a and d
  TwoRamps shoulder;  ///< with respect to b and c
  double strength;
};

/// The output terms of an expert in their order, a lane each, from 0 on.
///
/// Of an active set only a part of its rise, of its top and of its fall shows; the rest lies under the active sets next
/// to it, and what that is follows from the strengths of the two. With heights relative to the term, m in [t, top] is
/// what shows of a ramp (top = strength for clip and 1 for scale), so area, moment and their derivatives are
/// polynomials in t and top. They are sums of what shows, never differences of wholes, so nothing cancels. Derivatives
/// with respect to the vertices of a ramp are integrals over its height and hold for a vertical edge too.
class OrderedSets {
 public:
  static constexpr std::size_t kMostLanes = 63;  ///< a bit each, and one for the end
  static constexpr double kSmallestStrength = 1e-60;
  /// By lane; 0 at count(). The last one is to spare.
  using Strengths = std::array<double, kMostLanes + 2>;
  static constexpr std::size_t kSpare = kMostLanes + 1;
  using Gradients = std::array<LaneGradient, kMostLanes>;  ///< by lane

  /// Nothing where the terms do not have the form: a Gaussian, no order, sets that reach beyond the second next one,
  /// ramps cut by the universe [lo, hi], edges or ramps that coincide, widths below a thousandth of the universe.
  static std::optional<OrderedSets> of(std::span<const fuzzy::MembershipFunction> terms,
                                       std::span<const TermSlots> slots, double lo, double hi,
                                       fuzzy::Implication implication);

  std::size_t count() const noexcept { return lanes_.size() - 1; }
  std::size_t laneOf(std::size_t term) const noexcept { return lane_of_[term]; }
  const TermSlots& slotsOf(std::size_t lane) const noexcept { return lanes_[lane].slots; }

  /// Derivatives of the centroid for the lanes in `active`, a bit each: those with a strength > 0, at least one.
  /// Returns the centroid measured from the lower end of the universe, or nothing where the general sweep is needed: a
  /// strength below kSmallestStrength, or two sets that overlap above a weaker one between them. Thread: any. Real-time
  /// safe: yes.
  std::optional<double> centroid(const Strengths& strength, std::uint64_t active, Gradients& out) const noexcept;

 private:
  /// A lane and a later one, both active, no lane between them so.
  struct Pair {
    double overlap = 0;      ///< its width
    double peak = 0;         ///< height at which the ramps cross: strength above which it grows no more
    double least_ratio = 1;  ///< strength, in those of the first, above which the other one covers its end
  };
  struct Lane {
    TwoRamps foot{};            ///< a and d within the universe
    TwoRamps width{};           ///< b - a and d - c
    TwoRamps inwards{};         ///< from the foot to the shoulder: b - a and c - d
    TwoRamps moves_foot{};      ///< what the ramp gains where the foot moves by 1: -1 and 1, 0 where it does not show
    TwoRamps moves_shoulder{};  ///< the same for the shoulder
    std::array<Pair, 3> pairs;  ///< with the next lane, with the one after that, with any other
    double cover = 0;  ///< strength with which it covers the overlap of its two neighbours, at least kSmallestStrength
    TermSlots slots{};
  };
  struct Shown;

  template <bool clip>
  std::optional<double> centroidOf(const Strengths& strength, std::uint64_t active, Gradients& out) const noexcept;

  double lo_ = 0;
  bool clip_ = true;
  std::vector<Lane> lanes_;  ///< and one that stands for no term
  std::vector<std::size_t> lane_of_;
};

}  // namespace tactus::analysis
