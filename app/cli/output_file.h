// The file that a command writes: what it must not replace.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/commands.h"
#include "core/base/error.h"

namespace tactus::cli {

/// Whether the file `path` is an SQLite database, as a study file is.
bool isDatabase(const std::string& path);

/// Refuses `out` if it is a study file or another database, or one of the `inputs`, or a table of a study in a folder
/// among them. An empty `out` and empty inputs are not looked at.
base::Result<void> requireOutput(const std::string& out, const std::vector<std::string>& inputs);

/// Writes `text`, what the command makes, to the file `out`, and returns `said`. Where `out` is `-`, the text goes to
/// standard output in the place of what the command says; with `json` that is refused.
base::Result<Output> written(const std::string& out, std::string_view text, Output said, bool json);

}  // namespace tactus::cli
