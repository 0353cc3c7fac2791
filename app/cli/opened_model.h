// A model file as the commands use it: read, checked and compiled, with the file's name in every error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

struct OpenedModel {
  fuzzy::ForceModel model;
  fuzzy::CompiledModel compiled;      ///< of `model`
  std::vector<std::string> warnings;  ///< of the reader, one sentence each
};

/// Reads the model file `path` of at most 32 MiB.
base::Result<OpenedModel> openedModel(const std::string& path);

/// The same for `text`, which the caller has read from the file `path`.
base::Result<OpenedModel> openedModel(std::string_view text, const std::string& path);

}  // namespace tactus::cli
