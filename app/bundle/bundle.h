// A bundle: everything that a simulator team needs of one model, with what each file promises. Format: docs/bundle.md.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bundle/bounded_table.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/model_io/bundle_check.h"

namespace tactus::procedure {
struct Procedure;
}

namespace tactus::bundle {

struct BundleSettings {
  std::vector<std::string> accept_holes;  ///< names of holes that may stay, beside those that the model accepts
  std::string created_utc;
  std::string generator;
  std::optional<double> table_error_n = {};  ///< that the look-up table may have anywhere, > 0; nothing: the usual one
  std::stop_token stop = {};                 ///< the making ends soon after a request, with kCancelled
  /// Called before each file, in the thread that makes the bundle.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
  std::vector<model_io::Approval> approvals = {};  ///< of the model, as its history has them
  /// Whose files go along where the model names it; null: only of a procedure that the program carries.
  std::shared_ptr<const procedure::Procedure> procedure = {};
};

/// The files of a bundle in memory, the manifest last; behind it its signature, where it has one.
struct Bundle {
  fuzzy::ForceModel model;   ///< as the bundle carries it: accepted holes and checks of its own
  std::string model_sha256;  ///< of its file
  model_io::BundleManifest manifest;
  std::vector<std::pair<std::string, std::string>> files;  ///< path, bytes
  std::string fingerprint;                                 ///< SHA-256 of the manifest
  std::vector<model_io::Approval> approvals;
  std::vector<std::string> warnings;  ///< files that are left out, and why
  std::vector<std::string> holes;     ///< names of the holes of the averaged force that were found; all are accepted
  bool every_hole_is_known = true;    ///< false: the search was cut off
};

/// Builds the bundle of a valid model and measures the error of each file. Refused: a hole where the averaged force has
/// no value and that is not accepted, with its name; an accepted name that is no hole.
base::Result<Bundle> makeBundle(fuzzy::ForceModel model, const BundleSettings& settings);

/// The start of each expert's file names: the id with `_` for everything but letters, digits, `-` and `_`, each
/// different.
std::vector<std::string> expertFileNames(const fuzzy::ForceModel& model);

/// The page `report.html`, on two printed pages. `bundle`: with all other files; `compiled`: made from its model.
std::string bundleReport(const Bundle& bundle, const fuzzy::CompiledModel& compiled);

/// The signature of a manifest, as OpenSSH writes it. `private_key`: a file; the program ssh-keygen may ask for its
/// passphrase on the terminal.
base::Result<std::string> signatureOf(std::string_view manifest, const std::string& private_key);

/// Who signed `manifest`: the fingerprint of the key in the file `public_key`, `SHA256:47DE…`. Refused: a signature by
/// another key, of another text, or none at all.
base::Result<std::string> signerOf(std::string_view manifest, std::string_view signature,
                                   const std::string& public_key);

/// Refused: a folder that holds anything but an earlier bundle, which may be replaced.
base::Result<void> mayHoldBundle(const std::string& folder);

/// Writes all files into `folder`, whole or not at all. Refused as in `mayHoldBundle`. A request to stop ends it with
/// kCancelled and nothing written, unless the last step has begun.
base::Result<void> writeBundle(const Bundle& bundle, const std::string& folder, const std::stop_token& stop = {});

/// Writes all files into one zip file, in a folder of its name; whole or not at all. What was there goes.
base::Result<void> writeBundleZip(const Bundle& bundle, const std::string& file);

}  // namespace tactus::bundle
