// The folder of an export: made beside its place, then given its name.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace tactus::session {

/// Removed again unless `place` succeeds.
class ExportFolder {
 public:
  /// A new folder beside `folder`. Refused: a `folder` that holds anything but an earlier export.
  static base::Result<ExportFolder> beside(const std::string& folder);

  ExportFolder(ExportFolder&& other) noexcept;
  ExportFolder& operator=(ExportFolder&&) = delete;
  ~ExportFolder();

  /// Where the files are made.
  std::string path() const { return temporary_.string(); }

  /// Gives the folder its name, in place of an earlier export, which is removed.
  base::Result<void> place();

 private:
  ExportFolder(std::filesystem::path target, std::filesystem::path temporary);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
};

}  // namespace tactus::session
