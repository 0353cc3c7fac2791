// A new file that is written under a temporary name and appears completely or not at all.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::store {

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
