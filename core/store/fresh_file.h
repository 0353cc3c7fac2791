// A new file that is written under a temporary name and appears completely or not at all.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::store {

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

}  // namespace tactus::store
