// Moves membership functions: a vertex, an edge or a whole term. Used for drags, sliders, arrow keys and typed numbers.
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
  /// The terms sum to one before and after. Vertices of neighboring terms move along, each ramp keeps at least a
  /// millionth of the universe, and the end terms stay at the ends of the universe. Refused if the list does not sum to
  /// one (makeSumToOne).
  bool sum_to_one = false;
  std::vector<VertexPlace> locked;  ///< must not move; a move that would move one is refused
};

/// Moves a vertex to `to`, in the unit of the variable; for a Gaussian its mean or its sigma. `Edit::stopped` says
/// where the move stopped: at the neighboring vertex of the term (with `sum_to_one` also of a neighboring term), or one
/// universe beyond the end of the universe. An output term keeps some width inside. Sigma stays between a
/// ten-thousandth and ten times the universe. Refused: an unknown place, a number that is not finite, a locked vertex.
base::Result<Edit> moveVertex(const fuzzy::ForceModel& model, const VertexPlace& place, double to,
                              const MoveOptions& options = {});

/// Moves both vertices of an edge by `by`, with the same stops. The peak of a triangle belongs to both edges. Refused
/// for a Gaussian.
base::Result<Edit> moveEdge(const fuzzy::ForceModel& model, const TermPlace& place, Side side, double by,
                            const MoveOptions& options = {});

/// Moves the whole term by `by`, with the same stops. If the terms sum to one, an end term keeps its outer edge.
base::Result<Edit> moveTerm(const fuzzy::ForceModel& model, const TermPlace& place, double by,
                            const MoveOptions& options = {});

/// Sets all points of a term to typed values. Never stops short. Refused: points out of order, a wrong number of
/// points.
base::Result<Edit> setPoints(const fuzzy::ForceModel& model, const TermPlace& place, std::span<const double> points);

}  // namespace tactus::editing
