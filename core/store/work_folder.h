// A folder beside a study file for what is made on the way; removed with all it holds.
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
  /// Only the user can look into it (0700).
  static base::Result<WorkFolder> beside(const std::string& study);
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  ~WorkFolder();

  /// The path of the file `name` in it.
  std::string file(const std::string& name) const;

 private:
  WorkFolder(std::string path, base::Descriptor in_use);

  std::string path_;
  base::Descriptor in_use_;
};

}  // namespace tactus::store
