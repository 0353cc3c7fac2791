// The steps of the procedure, and the regions that a model knows on the way.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench {

// The regions along the way, as its terms in a model divide it.

/// A range in which one term has the largest membership.
struct DepthRegion {
  QString label;
  double from_mm = 0;
  double to_mm = 0;
  std::string id = {};  ///< of the term
};

/// The regions of `depth`, from the first inward. Places without a term belong to no region. The boundaries are exact
/// to 1/4000 of the universe.
std::vector<DepthRegion> depthRegions(const fuzzy::Variable& depth);

/// The region of `depth_mm`; nothing if it is in none.
std::optional<std::size_t> regionAt(const std::vector<DepthRegion>& regions, double depth_mm);

struct ProcedureStep {
  QString title;
  QString text;
  std::optional<double> from_mm;  ///< the step begins at this depth of the tip; nothing: before the way
};

/// The steps of `procedure` in the language of the program; none without one.
std::vector<ProcedureStep> stepsOf(const procedure::Procedure* procedure);

/// The current step with the tip at `depth_mm`: the last one that begins at or before it. Nothing if the tube is out or
/// there is no step.
std::optional<std::size_t> stepAt(const std::vector<ProcedureStep>& steps, double depth_mm);

}  // namespace tactus::workbench
