// The folder of an export: created beside its final place, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::session {

/// What an earlier export of one kind is recognized by.
struct ExportKind {
  std::string_view marker;                              ///< a file at the top of each
  std::string_view text;                                ///< a part of that file
  bool (*is_ours)(const std::filesystem::path& below);  ///< whether such an export writes this file of the folder
};

/// CSV tables with a codebook (study_export.h).
ExportKind tablesExport();

/// How a new export replaces an earlier one.
enum class Swap {
  kAtOnce,      ///< exchanges the names, so that the folder always exists; in two steps if the system cannot do that
  kInTwoSteps,  ///< the way of a file system that cannot exchange names
};

/// The folder is removed again unless `place` succeeds. Its mode is 0700 (only the user can read it); if it replaces an
/// earlier export, it gets that folder's mode.
class ExportFolder {
 public:
  /// Creates a folder beside `folder`. Refused: a `folder` that holds anything but an earlier export of the `kind`.
  static base::Result<ExportFolder> beside(const std::string& folder, const ExportKind& kind = tablesExport());

  ExportFolder(ExportFolder&& other) noexcept;
  ExportFolder& operator=(ExportFolder&&) = delete;
  ~ExportFolder();

  /// The folder for the files until `place`.
  std::string path() const { return temporary_.string(); }

  /// Renames the folder to its final name. An earlier export there is removed.
  base::Result<void> place(Swap swap = Swap::kAtOnce);

 private:
  ExportFolder(std::filesystem::path target, std::filesystem::path temporary, base::Descriptor in_use);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  base::Descriptor in_use_;  ///< a crash releases it
};

/// Whether `folder` holds files, and only files of an export of tables.
bool isExport(const std::filesystem::path& folder);

}  // namespace tactus::session
