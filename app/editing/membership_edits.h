// Membership functions moved by hand: a vertex, an edge, a whole term. What a drag, a slider, an arrow key or a typed
// number does.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/editing/term_list.h"

namespace tactus::editing {

struct VertexPlace {
  TermListId list;
  std::string term;
  std::size_t point = 0;  ///< index in Term::points

  bool operator==(const VertexPlace&) const = default;
};

enum class Side { kLeft, kRight };

struct MoveOptions {
  /// The terms sum to one before and after: the vertices of the neighbouring terms move along, each ramp keeps a
  /// millionth of the universe, and the end terms keep to the ends of the universe. Refused for a list that does not
  /// sum to one (makeSumToOne).
  bool sum_to_one = false;
  std::vector<VertexPlace> locked;  ///< these stay; a move that would take one along is refused
};

/// Moves a vertex to `to`, in the unit of the variable; for a Gaussian its mean or its sigma. It stops at the
/// neighbouring vertex of its term (in the mode above also at that of a neighbouring term), one universe beyond the end
/// of the universe, and an output term keeps some width inside: `Edit::stopped` says so. Sigma stays between a
/// ten-thousandth and ten times the universe. Refused: a place that is not there, a number that is not finite, a locked
/// vertex.
base::Result<Edit> moveVertex(const fuzzy::ForceModel& model, const VertexPlace& place, double to,
                              const MoveOptions& options = {});

/// Moves both vertices of an edge by `by`, with the same stops; of a triangle the peak is part of both edges. Refused
/// for a Gaussian.
base::Result<Edit> moveEdge(const fuzzy::ForceModel& model, const TermPlace& place, Side side, double by,
                            const MoveOptions& options = {});

/// Moves the whole term by `by`, with the same stops. Where the terms sum to one, an end term keeps its outer edge.
base::Result<Edit> moveTerm(const fuzzy::ForceModel& model, const TermPlace& place, double by,
                            const MoveOptions& options = {});

/// Sets all points of a term as typed. Refused instead of stopped: points out of order, another number of points.
base::Result<Edit> setPoints(const fuzzy::ForceModel& model, const TermPlace& place, std::span<const double> points);

}  // namespace tactus::editing
