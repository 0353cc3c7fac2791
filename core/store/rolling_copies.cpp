#include "core/store/rolling_copies.h"

#include <filesystem>
#include <initializer_list>
#include <system_error>

#include "core/store/backup.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

std::string nameOf(const std::string& path, int number) { return path + ".copy-" + std::to_string(number); }

tl::unexpected<base::Error> failure(const std::string& path, const std::error_code& error) {
  return tl::unexpected(
      base::Error{base::ErrorCode::kIo, path, {}, error.message(), "a folder in which copies of the study are kept"});
}

}  // namespace

base::Result<void> keepCopy(const StudyFile& file) {
  const std::string& path = file.path();
  const std::string made = nameOf(path, 0);
  std::error_code error;
  fs::remove(made, error);  // of a program that was interrupted
  if (auto copied = backUp(file, made); !copied) return copied;
  const auto mode = fs::status(path, error).permissions();
  if (!error) fs::permissions(made, mode, error);
  if (!error && fs::exists(nameOf(path, 1))) fs::rename(nameOf(path, 1), nameOf(path, 2), error);
  if (!error) fs::rename(made, nameOf(path, 1), error);
  if (!error) return {};
  const auto why = error;
  fs::remove(made, error);
  return failure(nameOf(path, 1), why);
}

base::Result<void> removeCopies(const std::string& path) {
  for (const int number : {0, 1, 2}) {
    std::error_code error;
    fs::remove(nameOf(path, number), error);
    if (error) return failure(nameOf(path, number), error);
  }
  return {};
}

}  // namespace tactus::store
