// The file that a command writes: what it must not replace.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace tactus::cli {

/// Refuses `out` if it is a study file or another database, or one of the `inputs`, or a table of a study in a folder
/// among them. An empty `out` and empty inputs are not looked at.
base::Result<void> requireOutput(const std::string& out, const std::vector<std::string>& inputs);

}  // namespace tactus::cli
