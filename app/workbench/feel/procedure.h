// The steps of a tube placement as text. They are data, so that a clinic can have its own.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

// The anatomical regions along the path of the tube, as the depth terms of a model divide it.

/// A range in which one term has the largest membership.
struct DepthRegion {
  QString label;
  double from_mm = 0;
  double to_mm = 0;
  std::string id = {};  ///< of the term
};

/// The regions of `depth`, from the nostril inward. Places without a term belong to no region. The boundaries are exact
/// to 1/4000 of the universe.
std::vector<DepthRegion> depthRegions(const fuzzy::Variable& depth);

/// The region of `depth_mm`; nothing if it is in none.
std::optional<std::size_t> regionAt(const std::vector<DepthRegion>& regions, double depth_mm);

struct ProcedureStep {
  QString title;
  QString text;
  std::optional<double> from_mm;  ///< the step begins at this depth of the tip; nothing: before the nostril
};

/// Reads a JSON text `{"steps": [{"title", "text", "from_mm"}]}`. Refused: no JSON, no steps, a step without a title,
/// depths that do not ascend.
base::Result<std::vector<ProcedureStep>> readProcedure(const QByteArray& json);

/// The built-in steps.
std::vector<ProcedureStep> ngtProcedure();

/// The current step with the tip at `depth_mm`: the last one that begins at or before it. Nothing if the tube is out or
/// there is no step.
std::optional<std::size_t> stepAt(const std::vector<ProcedureStep>& steps, double depth_mm);

}  // namespace tactus::workbench
