// The native model file `*.tactus.json`, version 1: the one reader and the one writer. Format: docs/model-file.md.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::model_io {

inline constexpr std::size_t kMostModelFileBytes = std::size_t{32} << 20U;  ///< 32 MiB

/// A model and the warnings of reading it (keys below the top level that were dropped).
struct ReadModel {
  fuzzy::ForceModel model;
  std::vector<std::string> warnings;  ///< one sentence each, with file and JSON place; at most 101
};

/// Reads a model from `text`, said to be of `file` in errors. The model is validated and its checks are evaluated
/// again; a mismatch above 1e-12 of the output's range is refused. Errors carry the JSON place, syntax errors line and
/// column.
base::Result<ReadModel> parseModel(std::string_view text, const std::string& file);

/// Reads the model file `path` of at most 32 MiB.
base::Result<ReadModel> readModel(const std::string& path);

/// The text of a model file, keys in the order of the format, optional keys left out where they hold their default.
/// `formatModel` of a model that was read gives a text that reads as the same model.
std::string formatModel(const fuzzy::ForceModel& model);

/// Validates `model` and writes it to `path`, whole or not at all. Nothing is written that `readModel` would refuse, so
/// wrong checks are an error here too.
base::Result<void> writeModel(const fuzzy::ForceModel& model, const std::string& path);

}  // namespace tactus::model_io
