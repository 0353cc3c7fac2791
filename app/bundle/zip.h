// A bundle as one zip file, to send and to attach.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/unfinished.h"

namespace tactus::bundle {

/// Files by their path, `/` between folders.
using PackedFiles = std::vector<std::pair<std::string, std::string>>;

/// Whether `path` names a zip file: it ends with `.zip`.
bool isZipName(std::string_view path);

/// The bytes of a zip file with `files` in the folder `folder`. The same files give the same bytes.
base::Result<std::string> zipped(const PackedFiles& files, const std::string& folder);

/// The files of the zip file `path`, without the one folder that may hold them all. Refused: what is no zip file, a
/// path that leads out of its folder, a link, more than 10,000 files or 1 GiB.
base::Result<PackedFiles> unzipped(const std::string& path);

/// The files of a zip file in a folder of their own, beside the other temporary files; it goes with this object.
class UnzippedFolder {
 public:
  /// Returns the errors of `unzipped`, and those of writing.
  static base::Result<UnzippedFolder> of(const std::string& path);
  UnzippedFolder(UnzippedFolder&& other) noexcept;
  UnzippedFolder& operator=(UnzippedFolder&&) = delete;
  ~UnzippedFolder();

  const std::string& path() const noexcept { return folder_.path; }
  /// `text` with the path of the zip file in the place of this folder's, which its user does not know.
  std::string named(std::string text) const;
  /// The same for the file of an error.
  base::Error named(base::Error error) const;

 private:
  UnzippedFolder(std::string zip, base::Unfinished folder) : zip_(std::move(zip)), folder_(std::move(folder)) {}

  std::string zip_;
  base::Unfinished folder_;
};

}  // namespace tactus::bundle
