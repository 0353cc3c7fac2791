// A grip: the part of a term list that the mouse or the keys move. It is a vertex, an edge, or a whole term.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/editing/term_list.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

// The terms that a model had before an edit.

/// The terms of `variable` in `model`, those of the expert where `list` is an expert's own; none where there is no such
/// list.
std::vector<fuzzy::Term> termsBefore(const fuzzy::ForceModel& model, const editing::TermListId& list,
                                     const fuzzy::Variable& variable);

// Where a new term has the most room.

/// The middle of the widest gap between `terms` of `variable`; without gaps, the middle of the right half of the widest
/// core. In the unit of the variable.
double roomiestPlace(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

struct Grip {
  enum class Part { kVertex, kLeftEdge, kRightEdge, kTerm };

  std::size_t term = 0;  ///< index in the list of terms
  Part part = Part::kTerm;
  std::size_t point = 0;  ///< for a vertex: index in Term::points
  bool mirrored = false;  ///< the left one of a Gaussian's two sigma handles: it grows to the left

  bool operator==(const Grip&) const = default;
};

/// The place of a grip on the plot.
struct GripHandle {
  Grip grip;
  double x = 0;           ///< in the unit of the variable
  double membership = 0;  ///< 0 to 1
};

/// The handles of term `index` of `terms`, in the order of the x axis.
std::vector<GripHandle> handlesOf(const std::vector<fuzzy::Term>& terms, std::size_t index);

/// Whether `terms` have the part that `grip` names.
bool holds(const std::vector<fuzzy::Term>& terms, const Grip& grip);

/// The points of its term that move with `grip`, as indices in Term::points.
std::vector<std::size_t> pointsOf(const std::vector<fuzzy::Term>& terms, const Grip& grip);

/// The name and the value of the grip: `Nasopharynx: left shoulder 80 mm`, `Nasopharynx: left edge 60 to 80 mm`.
QString gripText(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, const Grip& grip);

// Finds the part of a term under the mouse. Plain geometry in pixels.

/// The rectangle of a membership plot, and the values at its sides.
struct PlotFrame {
  QRectF area;      ///< px
  double low = 0;   ///< value at the left side, in the unit of the variable
  double high = 1;  ///< at the right side
  double top = 1;   ///< membership at the upper side; 0 at the lower side

  QPointF pixelOf(double x, double membership) const;
  double valueAt(double x_px) const;
};

// The largest distance to the mouse, px. Sized for fingers on a touch screen and tired eyes, not for the marks.
inline constexpr double kVertexReach = 12;
inline constexpr double kEdgeReach = 7;

/// The nearest vertex within reach; else the nearest edge; else the term whose shape contains `place`. Of vertices at
/// one place it takes the one that can move to the side of the mouse. A part of the term `preferred` wins.
std::optional<Grip> gripAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred);

}  // namespace tactus::workbench
