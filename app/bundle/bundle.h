// A bundle: everything that a simulator team needs of one model, with what each file promises. Format: docs/bundle.md.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/model_io/bundle_manifest.h"

namespace tactus::bundle {

struct BundleSettings {
  std::vector<std::string> accept_holes;  ///< names of holes that may stay, beside those that the model accepts
  std::string created_utc;
  std::string generator;
};

/// The files of a bundle in memory, the manifest last.
struct Bundle {
  fuzzy::ForceModel model;  ///< as the bundle carries it: accepted holes and checks of its own
  model_io::BundleManifest manifest;
  std::vector<std::pair<std::string, std::string>> files;  ///< path, bytes
  std::vector<std::string> warnings;                       ///< files that are left out, and why
};

/// Builds the bundle of a valid model and measures the error of each file. Refused: a hole where the averaged force has
/// no value and that is not accepted, with its name; an accepted name that is no hole.
base::Result<Bundle> makeBundle(fuzzy::ForceModel model, const BundleSettings& settings);

/// The start of each expert's file names: the id with `_` for everything but letters, digits, `-` and `_`, each
/// different.
std::vector<std::string> expertFileNames(const fuzzy::ForceModel& model);

/// Writes all files into `folder`, whole or not at all. Refused: a folder that holds anything but an earlier bundle.
base::Result<void> writeBundle(const Bundle& bundle, const std::string& folder);

}  // namespace tactus::bundle
