// The terms of an input, cut at all their vertices. Between two neighboring vertices each membership is a line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/membership.h"

namespace tactus::analysis {

/// Slots of a, b, c, d, or of mean and sigma.
using TermSlots = std::array<std::uint32_t, 4>;

/// A part of a term with a membership above 0. Ramp: membership = (x - foot) * slope. Plateau: 1, slope 0.
struct MembershipPiece {
  std::uint16_t term = 0;
  std::uint32_t foot_slot = 0, shoulder_slot = 0;  ///< of the two vertices of the ramp
  double foot = 0, shoulder = 0;                   ///< positions where the ramp is 0 and 1
  double slope = 0;                                ///< negative on a falling ramp
  double base = 1;                                 ///< membership at `foot`: 0 on a ramp
  std::uint32_t group = 0;                         ///< first slot of the term

  bool isActive() const noexcept { return base != 0 || slope != 0; }
  double membership(double x) const noexcept { return base + (x - foot) * slope; }
  /// 1 - membership on a ramp, without cancellation; 0 on a plateau.
  double rest(double x) const noexcept { return (shoulder - x) * slope; }
};

/// For each segment between neighboring vertices: the pieces of its active terms. All segments have the same number of
/// pieces, so that the processor can predict the loop; missing pieces are 0 or repeat others. A point on a vertex
/// belongs to the segment to its right, except on a falling vertical edge (membership 1 at the edge) and at the upper
/// end of the universe.
class InputPieces {
 public:
  /// Cuts the terms of the universe [lo, hi]. Nothing if they need the general path: a Gaussian, a term that consists
  /// of the upper end only, or numbers so extreme that a product with them could underflow.
  static std::optional<InputPieces> of(std::span<const fuzzy::MembershipFunction> terms,
                                       std::span<const TermSlots> slots, double lo, double hi);

  std::size_t segmentCount() const noexcept { return ends_.size(); }
  /// The segment of x in [lo, hi]. Thread: any. Real-time safe: yes.
  std::size_t segmentOf(double x) const noexcept {
    std::size_t segment = first_segment_[static_cast<std::size_t>((x - lo_) * cells_per_unit_)];
    while (x >= ends_[segment]) ++segment;
    return segment;
  }
  /// The pieces of a segment. Thread: any. Real-time safe: yes.
  std::span<const MembershipPiece> piecesOf(std::size_t segment) const noexcept {
    return {pieces_.data() + segment * pieces_per_segment_, pieces_per_segment_};
  }

 private:
  double lo_ = 0;
  double cells_per_unit_ = 0;
  std::vector<std::uint16_t> first_segment_;  ///< per cell; a point in it lies in this segment or a later one
  std::vector<double> ends_;                  ///< ends of the segments, ascending; the last is infinity
  std::size_t pieces_per_segment_ = 1;
  std::vector<MembershipPiece> pieces_;
};

/// Whether x is 0 or so large that products of a few such numbers do not underflow.
inline bool isOrdinary(double x) noexcept { return (x == 0) | (x > 1e-60) | (x < -1e-60); }

}  // namespace tactus::analysis
