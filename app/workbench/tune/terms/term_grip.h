// A grip: the part of a term list that the mouse or the keys move. It is a vertex, an edge, or a whole term.
#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

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

}  // namespace tactus::workbench
