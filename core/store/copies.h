// Other files and folders that may hold the data of a participant who withdrew: copies and exports of a study.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::store {

// A new file that is written under a temporary name and appears completely or not at all.

// A temporary folder beside a study file, removed with its contents.

/// Behind the study's name: the folder in which an import or a demo's study is prepared (base/files/unfinished.h).
inline constexpr std::string_view kImportEnding = ".import-";

/// A crash leaves it behind: it blocks nothing, and the next export or demo deletes it (app/session/export_folder.h).
class WorkFolder {
 public:
  /// Creates the folder. Only the user can access it (0700).
  static base::Result<WorkFolder> beside(const std::string& study);
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder();

  /// The path of the file `name` in the folder.
  std::string file(const std::string& name) const;

 private:
  WorkFolder(std::string path, base::Descriptor in_use);

  std::string path_;
  base::Descriptor in_use_;
};

/// Thread: one at a time. The destructor deletes the file unless `place` succeeded. Only the user can read it (0600).
class FreshFile {
 public:
  /// Creates an empty file beside `path`. Returns an error if `path` exists.
  static base::Result<FreshFile> beside(const std::string& path);

  FreshFile(FreshFile&& other) noexcept;
  FreshFile& operator=(FreshFile&&) = delete;
  ~FreshFile();

  /// The temporary path. The writer must close the file before `place`.
  const std::string& temporary() const { return temporary_; }

  /// Syncs the file, renames it to its final name and syncs the folder. Never overwrites a file.
  base::Result<void> place();

  /// The same error with the final name of the file.
  base::Error renamed(base::Error error) const;

 private:
  FreshFile(std::string path, std::string temporary, base::Descriptor in_use);

  std::string path_;
  std::string temporary_;
  base::Descriptor in_use_;  ///< a crash releases it
};

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
