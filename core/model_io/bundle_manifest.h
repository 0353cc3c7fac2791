// The manifest of a bundle: which files belong to it, how exactly each of them holds the model. Format: docs/bundle.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::model_io {

inline constexpr std::string_view kManifestName = "manifest.json";

/// What a file of forces promises.
struct Promise {
  std::string rule;  ///< `exact`, `midpoint:N`, `linspace:N` or `table`: how its reader computes the centroid
  double tolerance_n = 0;
  double largest_error_n = 0;  ///< as measured when the bundle was written
  std::vector<double> at;      ///< the inputs of that point; empty without an error
  bool measured = true;        ///< false: `largest_error_n` is a bound, because the file could not be run there

  bool operator==(const Promise&) const = default;
};

struct BundleFile {
  std::string path;  ///< in the folder of the bundle, with `/`
  std::string sha256;
  std::string kind;  ///< `model`, `checks`, `fll`, `fcl`, `fcl-fuzzylite`, `fis`, `fml`, `c`, `table`, `text`, `report`
  std::string expert;              ///< id; empty where it holds no single expert
  std::optional<Promise> promise;  ///< nothing for a file without forces

  bool operator==(const BundleFile&) const = default;
};

struct BundleManifest {
  std::string model;  ///< path of the model file
  std::string created_utc;
  std::string generator;
  std::vector<BundleFile> files;

  bool operator==(const BundleManifest&) const = default;
};

/// The manifest in `text`; `file` is its name in errors. Refused: unknown members, a path that leads out of the folder.
base::Result<BundleManifest> parseManifest(std::string_view text, const std::string& file);

std::string formatManifest(const BundleManifest& manifest);

}  // namespace tactus::model_io
