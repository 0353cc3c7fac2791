// A new model to fill with rules: the variables of the nasogastric tube study with their default terms.
#pragma once

#include <QString>

#include "app/workbench/model/open_model.h"
#include "core/base/error.h"

namespace tactus::workbench {

/// Inputs, output and terms of elicitation/variables, one expert without rules. Its path is one in `folder` that does
/// not exist yet. `name` is the model's.
base::Result<OpenModel> ngtTemplateModel(const QString& name, const QString& folder);

}  // namespace tactus::workbench
