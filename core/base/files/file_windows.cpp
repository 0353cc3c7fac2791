// Files on Windows, as far as libtactus needs them: it reads. File names are UTF-8, as everywhere in Tactus.
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "core/base/files/file.h"

namespace tactus::base {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> ioError(const std::string& path, std::string found, std::string wanted) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)});
}

/// No path where the bytes are not UTF-8: the conversion then throws.
std::optional<fs::path> asPath(const std::string& path) {
  try {
    return fs::path(std::u8string(path.begin(), path.end()));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::string asText(const fs::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

}  // namespace

Result<std::string> readFile(const std::string& path, std::size_t most_bytes) {
  const auto name = asPath(path);
  if (path.empty()) return ioError(path, "an empty file name", "a readable file");
  if (!name) return ioError(path, "a name that is not UTF-8", "a readable file");
  std::error_code error;
  const fs::file_status status = fs::status(*name, error);
  if (fs::is_directory(status)) return ioError(path, "a folder", "a file");
  if (!fs::is_regular_file(status)) {
    return ioError(path, error ? systemReason(error.default_error_condition().value()) : "no regular file",
                   "a readable file");
  }
  const std::uintmax_t size = fs::file_size(*name, error);
  if (error) return ioError(path, systemReason(error.default_error_condition().value()), "a readable file");
  if (size > most_bytes) {
    return tl::unexpected(Error{ErrorCode::kLimit,
                                path,
                                {},
                                std::to_string(size) + " bytes",
                                "at most " + std::to_string(most_bytes) + " bytes"});
  }
  std::ifstream file(*name, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file || file.gcount() != static_cast<std::streamsize>(bytes.size()))
    return ioError(path, systemReason(errno), "a readable file");
  return bytes;
}

Result<void> requireBelow(const std::string& folder, const std::string& path) {
  const auto root_name = asPath(folder);
  const auto name = asPath(path);
  if (!root_name || !name) return ioError(path, "a name that is not UTF-8", "a file name");
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(*name, error);
  const fs::path root = fs::weakly_canonical(*root_name, error);
  const auto [end, unused] = std::mismatch(root.begin(), root.end(), whole.begin(), whole.end());
  if (error || end == root.end()) return {};
  return ioError(path, "a link to " + base::quoted(asText(whole)) + ", outside of the folder",
                 "a file in the folder itself");
}

}  // namespace tactus::base
