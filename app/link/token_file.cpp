#include "app/link/token_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "core/base/files/descriptor.h"
#include "core/base/files/file.h"
#include "core/base/files/system_reason.h"
#include "core/base/files/unfinished.h"
#include "core/base/text.h"

namespace tactus::link {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;

constexpr std::size_t kFewestTokenBytes = 16;
constexpr std::size_t kMostTokenBytes = 256;

tl::unexpected<Error> fileError(const std::string& path, std::string found, std::string wanted) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)});
}

/// 128 random bits in hexadecimal digits.
Result<std::string> makeToken() {
  std::array<unsigned char, 16> bits{};
  if (::getentropy(bits.data(), bits.size()) != 0)
    return base::fail(ErrorCode::kIo, {}, "no random numbers: " + base::systemReason(errno), "a random token");
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string token;
  for (const unsigned char byte : bits) {
    token += kHex[byte >> 4U];
    token += kHex[byte & 15U];
  }
  return token;
}

/// The file appears whole, with its mode; one that is there meanwhile is not replaced.
Result<void> writePrivately(const std::string& path, const std::string& token) {
  auto [temporary, file] = base::makeUnfinishedFile(path, 0600);
  if (!file.isOpen()) return fileError(path, base::systemReason(errno), "a folder that can be written to");
  const std::string line = token + '\n';
  const bool written = ::write(file.number(), line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
                       ::fsync(file.number()) == 0 &&
                       // Some file systems have no second names.
                       (::link(temporary.c_str(), path.c_str()) == 0 ||
                        (errno == EPERM && std::rename(temporary.c_str(), path.c_str()) == 0));
  const int error = errno;
  ::unlink(temporary.c_str());
  if (!written) return fileError(path, base::systemReason(error), "a file that can be written");
  return {};
}

Result<std::string> readToken(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return fileError(path, base::systemReason(errno), "a token file");
  if (S_ISREG(info.st_mode) && (info.st_mode & 077U) != 0) {
    std::array<char, 8> mode{};
    std::snprintf(mode.data(), mode.size(), "%04o", info.st_mode & 07777U);
    return fileError(path, "a token file that others may read (mode " + std::string(mode.data()) + ")", "mode 0600");
  }
  const auto text = base::readFile(path, 2 * kMostTokenBytes);
  if (!text) return tl::unexpected(text.error());
  std::string_view token = *text;
  while (token.ends_with('\n') || token.ends_with('\r')) token.remove_suffix(1);
  const bool fits = token.size() >= kFewestTokenBytes && token.size() <= kMostTokenBytes &&
                    std::all_of(token.begin(), token.end(), [](char c) { return c > ' ' && c < '\x7f'; });
  if (fits) return std::string(token);
  return fileError(path, "no token",
                   "one line of " + std::to_string(kFewestTokenBytes) + " to " + std::to_string(kMostTokenBytes) +
                       " letters and digits, or no file");
}

}  // namespace

bool isSameToken(std::string_view said, std::string_view token) noexcept {
  unsigned difference = said.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < said.size() && !token.empty(); ++i) {
    difference |= static_cast<unsigned char>(said[i]) ^ static_cast<unsigned char>(token[i % token.size()]);
  }
  return difference == 0 && !token.empty();
}

TokenFile::TokenFile(std::string path, std::string token, std::string folder)
    : path_(std::move(path)), token_(std::move(token)), folder_(std::move(folder)) {}

TokenFile::TokenFile(TokenFile&& other) noexcept
    : path_(std::move(other.path_)), token_(std::move(other.token_)), folder_(std::exchange(other.folder_, {})) {}

TokenFile::~TokenFile() {
  if (folder_.empty()) return;
  ::unlink(path_.c_str());
  ::rmdir(folder_.c_str());
}

Result<TokenFile> TokenFile::at(const std::string& path) {
  struct stat info {};
  if (::lstat(path.c_str(), &info) == 0) {
    auto token = readToken(path);
    if (!token) return tl::unexpected(token.error());
    return TokenFile(path, std::move(*token), {});
  }
  auto token = makeToken();
  if (!token) return tl::unexpected(token.error());
  if (auto written = writePrivately(path, *token); !written) return tl::unexpected(written.error());
  return TokenFile(path, std::move(*token), {});
}

Result<TokenFile> TokenFile::inPrivateFolder() {
  // The folder of the user's session is emptied by the system, also after a crash of this program.
  const char* const session = std::getenv("XDG_RUNTIME_DIR");
  std::error_code ignored;
  const bool is_private = session != nullptr && *session == '/' && ::access(session, W_OK | X_OK) == 0;
  const auto parent = is_private ? std::filesystem::path(session) : std::filesystem::temp_directory_path(ignored);
  std::string folder = (parent / "tactus-link-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr)
    return fileError(parent.string(), base::systemReason(errno), "a folder for a token file");
  auto token = makeToken();
  if (!token) return tl::unexpected(token.error());
  TokenFile file(folder + "/token", std::move(*token), folder);
  if (auto written = writePrivately(file.path(), file.token()); !written) return tl::unexpected(written.error());
  return file;
}

}  // namespace tactus::link
