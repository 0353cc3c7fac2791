// The steps of a tube placement as text: data, so that a clinic can have its own.
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
  std::optional<double> from_mm;  ///< depth of the tip from which it is the step at hand; nothing: before the nostril
};

/// The steps of a JSON text `{"steps": [{"title", "text", "from_mm"}]}`. Refused: no JSON, no steps, a step without a
/// title, depths that do not rise.
base::Result<std::vector<ProcedureStep>> readProcedure(const QByteArray& json);

/// The steps that come with the program.
std::vector<ProcedureStep> ngtProcedure();

/// The step at hand with the tip at `depth_mm`: the last one that begins there or before. Nothing: the tube is out, or
/// there is none.
std::optional<std::size_t> stepAt(const std::vector<ProcedureStep>& steps, double depth_mm);

}  // namespace tactus::workbench
