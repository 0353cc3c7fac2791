// Whether a study file can be opened for reading only.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"

namespace tactus::store {

/// Why the study file `path` cannot be opened for writing: it, or its folder, may not be written to. Nothing where it
/// can be, or is not there.
std::optional<base::Error> readOnlyReason(const std::string& path);

}  // namespace tactus::store
