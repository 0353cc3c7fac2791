// Whether a bundle still says what it promises: each file unaltered, its forces within their tolerance.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::model_io {

// The manifest of a bundle: which files belong to it, how exactly each of them holds the model. Format: docs/bundle.md.

inline constexpr std::string_view kManifestName = "manifest.json";
/// The signature of the manifest, which therefore cannot name it.
inline constexpr std::string_view kSignatureName = "manifest.json.sig";
/// The expert's approvals of the model; a bundle without any has no such file.
inline constexpr std::string_view kApprovalsName = "approvals.json";

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
  /// `model`, `checks`, `fll`, `fcl`, `fcl-fuzzylite`, `fis`, `fml`, `c`, `tube-c`, `js`, `tube-js`, `tube-checks`,
  /// `table`, `text`, `report`, `approvals`.
  std::string kind;
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

/// The fingerprint of a bundle as people compare it: four groups of 16 digits. `sha256`: of its manifest.
std::string fingerprintText(std::string_view sha256);

/// Who approved the model of a bundle, with the evidence.
struct Approval {
  std::string author;
  std::string text;  ///< `feels right, after 3 edits: 4 strokes on Touch`
  std::string utc;   ///< `2026-11-21T08:00:00Z`

  bool operator==(const Approval&) const = default;
};

/// The file `approvals.json`.
std::string formatApprovals(const std::vector<Approval>& approvals);

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
  std::string generator;                 ///< that wrote the bundle
  std::string model_sha256;              ///< of the model file
  std::string manifest;                  ///< the text, which a signature is of
  std::string fingerprint;               ///< its SHA-256
  std::optional<std::string> signature;  ///< the file beside the manifest; it is not checked here
  std::vector<Approval> approvals;
  std::vector<FileCheck> files;  ///< in the order of the manifest, then what it does not name (kind `unnamed`)

  bool ok() const;
};

/// Reads the bundle in `folder`. Every file must be there with its checksum, none may be a link, and no other may lie
/// there but a signature of the manifest. The model repeats its own checks, and the table of checks is evaluated again;
/// the files for other programs are not read here. Refused: a folder without a
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

/// The same for a table of insertions, `trace,step,position_mm,held,dt_s,` the conditions,
/// `force_n,depth_mm,phase,stroke`, against the renderer with the model's force. A trace begins where its name changes;
/// the conditions may change within it (render::kTraceFadeS). Phase and stroke must be equal, the depth within 1e-9 mm.
/// `at`: number of the trace and step, from 1.
base::Result<TableError> errorOfTubeChecks(const fuzzy::ForceModel& model, std::string text, const std::string& file);

}  // namespace tactus::model_io
