// The native model file `*.tactus.json`, version 1: reader and writer. Format: docs/model-file.md.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::model_io {

inline constexpr std::size_t kMostModelFileBytes = std::size_t{32} << 20U;  ///< 32 MiB

/// A model and the warnings of its reader (unknown keys below the top level are dropped).
struct ReadModel {
  fuzzy::ForceModel model;
  std::vector<std::string> warnings;  ///< one sentence each, with file and JSON place; at most 101
};

/// Reads a model from `text`; `file` is its name in errors. Validates the model and repeats its checks. Returns an
/// error if a check differs by more than 1e-12 of the output range. Errors have the JSON place; syntax errors have line
/// and column.
base::Result<ReadModel> parseModel(std::string_view text, const std::string& file);

/// Reads the model file `path` of at most 32 MiB.
base::Result<ReadModel> readModel(const std::string& path);

/// The text of a model file, with keys in the order of the format. Omits optional keys that have their default. Reading
/// the text gives an equal model.
std::string formatModel(const fuzzy::ForceModel& model);

/// Validates `model` and writes it to `path`, completely or not at all. Returns an error for every model that
/// `readModel` would refuse, also for wrong checks.
base::Result<void> writeModel(const fuzzy::ForceModel& model, const std::string& path);
/// The text that `writeModel` writes to `path`, with the same errors.
base::Result<std::string> modelText(const fuzzy::ForceModel& model, const std::string& path);

}  // namespace tactus::model_io
