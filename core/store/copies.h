// What else on the disk may hold the data of a participant who withdrew: files and folders that were made from a study.
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

/// Looks, in the folder of the study file `path` and in `also`, for what may hold data of `person`: what is named after
/// the study (copies made before upgrades, damaged journals, leftovers of crashes), other files and folders in which
/// the person's id or one of `codes` stands (backups, exports, tables, models, autosaves). Folders are searched three
/// levels deep. Codes of fewer than three bytes are not looked for. By path; what cannot be read is left out. It cannot
/// know of copies elsewhere.
std::vector<Copy> findCopies(const std::string& path, const study::RecordId& person, std::span<const std::string> codes,
                             std::span<const std::string> also = {});

}  // namespace tactus::store
