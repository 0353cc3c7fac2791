// A new file that is made under another name beside its place and appears whole or not at all.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::store {

/// Thread: one at a time. Removed again unless `place` succeeds. Only the user can read it (0600).
class FreshFile {
 public:
  /// An empty file beside `path`, which must not be there yet.
  static base::Result<FreshFile> beside(const std::string& path);

  FreshFile(FreshFile&& other) noexcept;
  FreshFile& operator=(FreshFile&&) = delete;
  ~FreshFile();

  /// Where the file is made. Whoever writes it must have let go of it before `place`.
  const std::string& temporary() const { return temporary_; }

  /// Syncs the file, gives it its name, never over another file, and syncs the folder.
  base::Result<void> place();

  /// The same error, said of the file's final name.
  base::Error renamed(base::Error error) const;

 private:
  FreshFile(std::string path, std::string temporary, base::Descriptor in_use);

  std::string path_;
  std::string temporary_;
  base::Descriptor in_use_;  ///< a crash releases it
};

}  // namespace tactus::store
