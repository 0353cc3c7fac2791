#include "core/store/work_folder.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/files/unfinished.h"

namespace tactus::store {

namespace fs = std::filesystem;

base::Result<WorkFolder> WorkFolder::beside(const std::string& study) {
  auto [name, in_use] = base::makeUnfinishedFolder(study, kImportEnding);
  if (!in_use.isOpen()) {
    const std::error_code reason(errno, std::generic_category());
    std::error_code ignored;
    const auto parent = fs::absolute(study, ignored).parent_path().string();
    return tl::unexpected(
        base::Error{base::ErrorCode::kIo, parent, {}, reason.message(), "a folder that can be written into"});
  }
  return WorkFolder(std::move(name), std::move(in_use));
}

WorkFolder::WorkFolder(std::string path, base::Descriptor in_use)
    : path_(std::move(path)), in_use_(std::move(in_use)) {}
WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), in_use_(std::move(other.in_use_)) {}
WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

std::string WorkFolder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

}  // namespace tactus::store
