// The folder of an export: made beside its place, then given its name.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::session {

/// How a new export takes the place of an earlier one.
enum class Swap {
  kAtOnce,      ///< the names are exchanged, so that there is always one; in two steps where the system cannot
  kInTwoSteps,  ///< as on a file system that cannot exchange names
};

/// Removed again unless `place` succeeds. Only the user can look into it (0700); one that takes the place of another
/// has the mode of that one.
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
  base::Result<void> place(Swap swap = Swap::kAtOnce);

 private:
  ExportFolder(std::filesystem::path target, std::filesystem::path temporary, base::Descriptor in_use);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  base::Descriptor in_use_;  ///< a crash releases it
};

/// Whether `folder` holds files, and none but those of an export.
bool isExport(const std::filesystem::path& folder);

}  // namespace tactus::session
