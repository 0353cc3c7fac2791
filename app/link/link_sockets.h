// The sockets on which the live link listens: the loopback, and a socket file where one is wanted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"

namespace tactus::link {

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
