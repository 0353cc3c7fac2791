#include "app/link/link_sockets.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <netinet/in.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/file.h"
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
  TACTUS_TRY(const auto text, base::readFile(path, 2 * kMostTokenBytes));
  std::string_view token = text;
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
    TACTUS_TRY(auto token, readToken(path));
    return TokenFile(path, std::move(token), {});
  }
  TACTUS_TRY(auto token, makeToken());
  if (auto written = writePrivately(path, token); !written) return tl::unexpected(written.error());
  return TokenFile(path, std::move(token), {});
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
  TACTUS_TRY(auto token, makeToken());
  TokenFile file(folder + "/token", std::move(token), folder);
  if (auto written = writePrivately(file.path(), file.token()); !written) return tl::unexpected(written.error());
  return file;
}

namespace {

using base::Descriptor;
using base::Error;
using base::ErrorCode;
using base::Result;

constexpr int kWaiting = 64;  // connections that the system keeps until they are accepted

tl::unexpected<Error> portError(std::uint16_t port, std::string found, std::string wanted) {
  return base::fail(ErrorCode::kIo, "port " + std::to_string(port), std::move(found), std::move(wanted));
}

tl::unexpected<Error> pathError(const std::string& path, std::string found, std::string wanted) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)});
}

Descriptor makeSocket(int family) {
  return Descriptor(::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

template <class Address>
bool bindAndListen(const Descriptor& socket, const Address& address) {
  return ::bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
         ::listen(socket.number(), kWaiting) == 0;
}

/// The same port for programs that say `localhost` and get ::1 first. Not every computer has it.
Descriptor listenOnLoopback6(std::uint16_t port) {
  Descriptor socket = makeSocket(AF_INET6);
  const int yes = 1;
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_port = htons(port);
  address.sin6_addr = in6addr_loopback;
  if (!socket.isOpen()) return socket;
  ::setsockopt(socket.number(), IPPROTO_IPV6, IPV6_V6ONLY, &yes, sizeof yes);
  ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (!bindAndListen(socket, address)) socket.close();
  return socket;
}

/// Whether a program listens on the socket file.
bool isInUse(const sockaddr_un& address) {
  const Descriptor probe = makeSocket(AF_UNIX);
  return ::connect(probe.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ||
         errno != ECONNREFUSED;
}

}  // namespace

Result<LinkSockets> LinkSockets::open(std::uint16_t port, const std::string& socket_path) {
  LinkSockets sockets;
  if (auto listens = sockets.listenOnLoopback(port); !listens) return tl::unexpected(listens.error());
  if (!socket_path.empty()) {
    if (auto listens = sockets.listenOnFile(socket_path); !listens) return tl::unexpected(listens.error());
  }
  return sockets;
}

Result<void> LinkSockets::listenOnLoopback(std::uint16_t port) {
  Descriptor socket = makeSocket(AF_INET);
  const int yes = 1;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (!socket.isOpen()) return portError(port, base::systemReason(errno), "a socket");
  ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (!bindAndListen(socket, address)) {
    const bool taken = errno == EADDRINUSE;
    return portError(port, taken ? "another program that uses it" : base::systemReason(errno),
                     "a free port; 0 takes any");
  }
  socklen_t size = sizeof address;
  if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&address), &size) != 0)
    return portError(port, base::systemReason(errno), "a port");
  port_ = ntohs(address.sin_port);
  listening_.push_back(std::move(socket));
  if (Descriptor six = listenOnLoopback6(port_); six.isOpen()) listening_.push_back(std::move(six));
  return {};
}

Result<void> LinkSockets::listenOnFile(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    return pathError(path, "a path of " + std::to_string(path.size()) + " bytes",
                     "a socket path of at most " + std::to_string(sizeof address.sun_path - 1) + " bytes");
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  struct stat info {};
  if (::lstat(path.c_str(), &info) == 0) {
    if (!S_ISSOCK(info.st_mode)) return pathError(path, "a file that is not a socket", "a name that is free");
    if (isInUse(address)) return pathError(path, "a socket that another program uses", "a name that is free");
    ::unlink(path.c_str());
  }
  Descriptor socket = makeSocket(AF_UNIX);
  // Linux gives the file the mode of the socket; elsewhere the file has its mode a moment later.
  if (!socket.isOpen() || ::fchmod(socket.number(), 0600) != 0 || !bindAndListen(socket, address))
    return pathError(path, base::systemReason(errno), "a folder that can be written to");
  socket_path_ = path;
  if (::chmod(path.c_str(), 0600) != 0 || ::lstat(path.c_str(), &info) != 0)
    return pathError(path, base::systemReason(errno), "a socket for its owner alone");
  file_device_ = info.st_dev;
  file_number_ = info.st_ino;
  listening_.push_back(std::move(socket));
  return {};
}

LinkSockets::LinkSockets(LinkSockets&& other) noexcept
    : port_(other.port_),
      socket_path_(std::exchange(other.socket_path_, {})),
      file_device_(other.file_device_),
      file_number_(other.file_number_),
      listening_(std::move(other.listening_)) {}

LinkSockets::~LinkSockets() {
  struct stat info {};
  if (socket_path_.empty() || ::lstat(socket_path_.c_str(), &info) != 0) return;
  if (info.st_dev == file_device_ && info.st_ino == file_number_) ::unlink(socket_path_.c_str());
}

std::string peerOf(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getpeername(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return {};
  if (address.ss_family == AF_INET)
    return "port " + std::to_string(ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port));
  if (address.ss_family == AF_INET6)
    return "port " + std::to_string(ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port));
  ucred peer{};
  size = sizeof peer;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) return {};
  return "process " + std::to_string(peer.pid);
}

}  // namespace tactus::link
