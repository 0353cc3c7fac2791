// A bundle as one zip file, to send and to attach.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

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

}  // namespace tactus::bundle
