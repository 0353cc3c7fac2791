// Experts and inputs of a model as the command line names them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/analysis/reasons.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

// The names and numbers of a model as the commands print them.
using analysis::conditionsOf;
using analysis::labelOf;
using analysis::signedNewtons;
using analysis::variableLabel;
using analysis::withUnit;
using analysis::wordLabel;

/// A model file as the commands use it: read, checked and compiled, with the file's name in every error.
struct OpenedModel {
  fuzzy::ForceModel model;
  fuzzy::CompiledModel compiled;      ///< of `model`
  std::vector<std::string> warnings;  ///< of the reader, one sentence each
};

/// Reads the model file `path` of at most 32 MiB.
base::Result<OpenedModel> openedModel(const std::string& path);

/// The same for `text`, which the caller has read from the file `path`.
base::Result<OpenedModel> openedModel(std::string_view text, const std::string& path);

/// The index of the expert with the id `id` in the model of file `path`; nothing for an empty `id`, which means the
/// mean of all. Returns an error with the known ids for another one.
base::Result<std::optional<std::size_t>> expertOption(const fuzzy::ForceModel& model, const std::string& path,
                                                      const std::string& id);

/// `lubrication=1` as the index of an input and its value. `option` is named in the error.
base::Result<std::pair<std::size_t, double>> inputOption(const fuzzy::ForceModel& model, const std::string& option,
                                                         const std::string& text);

/// One value for each input of the model, from texts such as `lubrication=1`. `option` is named in the errors, which
/// say how entries and decimals are written where a comma stands in a number.
base::Result<std::vector<double>> pointOption(const fuzzy::ForceModel& model, const std::string& option,
                                              const std::vector<std::string>& texts);

/// The number of an input or of the output, which follows the inputs.
base::Result<std::size_t> variableOption(const fuzzy::ForceModel& model, const std::string& option,
                                         const std::string& id);

}  // namespace tactus::cli
