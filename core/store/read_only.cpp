#include "core/store/read_only.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "core/store/sqlite_errors.h"

namespace tactus::store {

std::optional<base::Error> readOnlyReason(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::exists(path, problem)) return std::nullopt;
  auto reason = whyNotWritable(path);
  return reason.found.empty() ? std::nullopt : std::optional(std::move(reason));
}

}  // namespace tactus::store
