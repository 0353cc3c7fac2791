// The folder of an export: created beside its final place, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::session {

// Leftovers of crashes beside a study file or an export. They may hold data of the study.

/// A file or folder that no running program uses.
struct Leftover {
  std::string path;
  /// Its name shows that Tactus made it (base/unfinished.h), so it can be deleted without a question. False: it looks
  /// like a leftover of an older Tactus, but a person may have made it.
  bool is_ours = false;

  bool operator==(const Leftover&) const = default;
};

/// Everything left beside the study file `study`, and unfinished exports in its folder; sorted by name.
std::vector<Leftover> leftoversOfStudy(const std::string& study);

/// Unfinished exports of this name beside the export folder `folder`; sorted by name.
std::vector<Leftover> leftoversOfExport(const std::string& folder);

/// Deletes the leftovers with `is_ours` that are still unused. Returns the deleted paths.
std::vector<std::string> removeOurs(const std::vector<Leftover>& leftovers);

/// One sentence about a leftover, for the user.
std::string sentence(const Leftover& leftover);

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
