// A temporary folder beside a study file, removed with its contents.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::store {

/// Behind the study's name: the folder in which an import or a demo's study is prepared (base/files/unfinished.h).
inline constexpr std::string_view kImportEnding = ".import-";

/// A crash leaves it behind: it blocks nothing, and the next export or demo deletes it (app/session/leftovers.h).
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

}  // namespace tactus::store
