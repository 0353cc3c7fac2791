// Whether a bundle still says what it promises: each file unaltered, its forces within their tolerance.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/model_io/bundle_manifest.h"

namespace tactus::model_io {

/// The result for one file.
struct FileCheck {
  BundleFile file;
  bool ok = false;
  bool evaluated = false;      ///< its forces were computed again here, and `largest_error_n` is of now
  double largest_error_n = 0;  ///< otherwise as promised
  std::string wrong;           ///< one sentence where `ok` is false
};

struct BundleCheck {
  fuzzy::ForceModel model;
  std::string generator;         ///< that wrote the bundle
  std::string fingerprint;       ///< SHA-256 of the manifest
  std::vector<FileCheck> files;  ///< in the order of the manifest, then what it does not name (kind `unnamed`)

  bool ok() const;
};

/// Reads the bundle in `folder`. Every file must be there with its checksum, none may be a link, and no other may lie
/// there. The model repeats its own checks, and the
/// table of checks is evaluated again; the files for other programs are not read here. Refused: a folder without a
/// manifest or with a broken one, and a model that cannot be read, because then nothing can be evaluated (kMismatch: it
/// is missing, altered, or its checks fail).
base::Result<BundleCheck> checkBundle(const std::string& folder);

/// The largest difference between the forces of a table `id,…,force,fired` and those of `model`. `fired` must be equal.
struct TableError {
  double largest_n = 0;
  std::vector<double> at;
  std::size_t points = 0;
};
base::Result<TableError> errorOfChecks(const fuzzy::ForceModel& model, std::string text, const std::string& file);

}  // namespace tactus::model_io
