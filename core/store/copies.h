// Other files and folders that may hold the data of a participant who withdrew: copies and exports of a study.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::store {

// The copies that are kept of a study when a program opens it for writing.

/// Copies the study, as it was opened, to `<file>.copy-1`, with the study's mode; the one that was there becomes
/// `<file>.copy-2`, and an older one goes. Each is a study of its own: renamed, it can be opened. `eraseTraces`
/// (withdrawal.h) removes both. On failure those that were there stay.
base::Result<void> keepCopy(const StudyFile& file);

/// Removes both copies of the study `path`; none there is no failure.
base::Result<void> removeCopies(const std::string& path);

// Copies of a study made while it is open.

class Connection;
class StudyFile;

/// Copies the committed records of the study to the new file `target`, through SQLite's backup interface. The copy is
/// checked and synced, and appears completely or not at all. Returns an error if `target` exists, and so for the study
/// itself.
/// Never copy an open study by other means: its journal would be missing.
base::Result<void> backUp(const StudyFile& file, const std::string& target);

/// The same for a connection. For core/store only.
base::Result<void> copyDatabase(Connection& connection, const std::string& target);

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
