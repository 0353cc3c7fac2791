// The sockets on which the live link listens: the loopback, and a socket file where one is wanted.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::link {

// The secret that a client of the live link must know, and the file that only its owner can read it from. Everybody who
// works on a computer can connect to its loopback; the token tells the user's programs from others.

/// Compares in a time that depends on the lengths alone.
bool isSameToken(std::string_view said, std::string_view token) noexcept;

/// A file with a token, one line, for its owner alone (0600).
class TokenFile {
 public:
  /// The file `path`: takes the token in it, or writes a new one of 128 random bits if there is no file. The file stays
  /// afterwards, so that a simulator has to be told only once. Refused: a file with something else in it, or one that
  /// others may read.
  static base::Result<TokenFile> at(const std::string& path);
  /// A new token in a new private folder of the user, which is removed by the destructor.
  static base::Result<TokenFile> inPrivateFolder();

  ~TokenFile();
  TokenFile(TokenFile&& other) noexcept;
  TokenFile& operator=(TokenFile&&) = delete;

  const std::string& path() const { return path_; }
  const std::string& token() const { return token_; }

 private:
  TokenFile(std::string path, std::string token, std::string folder);

  std::string path_;
  std::string token_;
  std::string folder_;  ///< to be removed; empty: none
};

class LinkSockets {
 public:
  /// Listens on 127.0.0.1 (and on ::1 where there is one) at `port`, 0 for a free one, and on the socket file
  /// `socket_path` (mode 0600) unless it is empty. A socket file on which no program listens any more is replaced.
  static base::Result<LinkSockets> open(std::uint16_t port, const std::string& socket_path);
  /// Removes the socket file if it is still its own.
  ~LinkSockets();
  LinkSockets(LinkSockets&& other) noexcept;
  LinkSockets& operator=(LinkSockets&&) = delete;

  std::uint16_t port() const { return port_; }
  const std::string& socketPath() const { return socket_path_; }
  /// Without blocking.
  const std::vector<base::Descriptor>& listening() const { return listening_; }

 private:
  LinkSockets() = default;
  base::Result<void> listenOnLoopback(std::uint16_t port);
  base::Result<void> listenOnFile(const std::string& path);

  std::uint16_t port_ = 0;
  std::string socket_path_;
  std::uint64_t file_device_ = 0;  ///< which file it is, as the system counts them
  std::uint64_t file_number_ = 0;
  std::vector<base::Descriptor> listening_;
};

/// Who is on the other end of `socket`: `port 53312`, or `process 4711` on a socket file.
std::string peerOf(int socket);

}  // namespace tactus::link
