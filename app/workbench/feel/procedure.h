// The steps of a tube placement as text. They are data, so that a clinic can have its own.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <vector>

#include "core/base/error.h"

namespace tactus::workbench {

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
