// Other files and folders that may hold the data of a participant who withdrew: copies and exports of a study.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/record_id.h"

namespace tactus::store {

struct Copy {
  std::string path;
  std::string what;  ///< for example `a copy made before an upgrade`

  bool operator==(const Copy&) const = default;
};

/// Searches the folder of the study file `path`, and `also`, for data of `person`:
/// - files named after the study: copies made before upgrades, damaged journals, leftovers of crashes;
/// - other files and folders that contain the person's id or one of `codes`: backups, exports, tables, models,
///   autosaves.
/// Searches folders three levels deep. Ignores codes of fewer than three bytes and unreadable files. Returns copies
/// sorted by path. It cannot find copies in other places.
std::vector<Copy> findCopies(const std::string& path, const study::RecordId& person, std::span<const std::string> codes,
                             std::span<const std::string> also = {});

}  // namespace tactus::store
