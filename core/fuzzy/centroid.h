// Exact centroid of the aggregated output set.
#pragma once

#include <span>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

/// An output term and the strength with which it fires.
struct ActiveTerm {
  const MembershipFunction* function;
  double strength;  ///< in (0, 1]
  double height;    ///< strength relative to the largest one, in (0, 1]; exact even if strengths are subnormal
};

/// Centroid over [lo, hi] of the pointwise maximum of the terms, measured from `lo`. Each term is clipped at its
/// strength or scaled by it. `terms`: 1 to kMostTerms; each overlaps [lo, hi] in positive width.
///
/// Trapezoids: the maximum is piecewise linear, so area and moment are sums of closed forms over the pieces between all
/// vertices and crossings; nothing is sampled. Heights are relative to the largest strength, so tiny strengths keep
/// full precision. If a Gaussian is active: see gaussianCentroidOffset.
/// Thread: any. Real-time safe: yes.
double centroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi) noexcept;

/// As centroidOffset, for terms that include Gaussians. Crossings are bracketed and bisected to the last bit. Linear
/// pieces are integrated in closed form. Gaussian pieces are integrated by ten-point Gauss-Legendre quadrature on parts
/// so short that the quadrature error is below rounding. Error at most 1e-12 of hi - lo.
double gaussianCentroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo,
                              double hi) noexcept;

struct AreaAndMoment;

/// Area and first moment, measured from `lo`, of the slices of each term: where it is the highest, the first of equals
/// (lines or heights that differ by less than 1e-12 of their size are equal: one flank, rounded twice). Sum of moments
/// / sum of areas is the centroid's offset, as exact as there. `slices`: one per term, written here. Thread: any.
/// Real-time safe: yes.
void sliceMoments(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi,
                  std::span<AreaAndMoment> slices) noexcept;

/// The same for terms that include Gaussians; adds to `slices`, which are 0.
void gaussianSliceMoments(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi,
                          std::span<AreaAndMoment> slices) noexcept;

/// Area and first moment of a piecewise function: the sums over its pieces.
struct AreaAndMoment {
  double area = 0;
  double moment = 0;

  /// Adds a trapezoid that starts at x0, is `width` wide, and has the heights y0 and y1 at its ends. The caller passes
  /// the width itself, because a difference of positions loses the width of a set that is only a few ulps wide.
  void addLinear(double x0, double width, double y0, double y1) noexcept {
    const double piece = width * (y0 + y1) / 2;
    area += piece;
    moment += piece * x0 + width * width * (y0 + 2 * y1) / 6;
  }
};

}  // namespace tactus::fuzzy
