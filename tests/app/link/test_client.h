// A client of the live link for tests: blocking, with a limit on its patience.
#pragma once

#include <cstdint>
#include <netinet/in.h>
#include <optional>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include "core/base/files/descriptor.h"

namespace tactus::link {

class TestClient {
 public:
  static constexpr int kPatienceS = 20;

  /// `buffer`: bytes that the system keeps for a client that does not read; 0: its default.
  explicit TestClient(std::uint16_t port, int buffer = 0) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (buffer > 0) ::setsockopt(socket_.number(), SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
    connect(address);
  }
  explicit TestClient(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    connect(address);
  }

  bool isConnected() const { return connected_; }

  /// Whether everything was taken.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t taken = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (taken <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(taken));
    }
    return true;
  }
  /// What the system takes at once; the number of bytes.
  std::size_t sendSome(std::string_view bytes) {
    const ssize_t taken = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    return taken > 0 ? static_cast<std::size_t>(taken) : 0;
  }
  void endOutput() { ::shutdown(socket_.number(), SHUT_WR); }

  /// The next line; empty at the end of the connection, or when patience has run out.
  std::string line() {
    while (true) {
      if (const auto end = bytes_.find('\n'); end != std::string::npos) {
        std::string out = bytes_.substr(0, end);
        bytes_.erase(0, end + 1);
        return out;
      }
      char chunk[65536];
      const ssize_t got = ::recv(socket_.number(), chunk, sizeof chunk, 0);
      if (got <= 0) {
        ended_ = got == 0;
        return {};
      }
      bytes_.append(chunk, static_cast<std::size_t>(got));
    }
  }
  /// Whether the server has closed the connection in order, seen by `line`.
  bool ended() const { return ended_; }

 private:
  template <class Address>
  void connect(const Address& address) {
    const timeval patience{kPatienceS, 0};
    ::setsockopt(socket_.number(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ::setsockopt(socket_.number(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    connected_ = ::connect(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }

  base::Descriptor socket_;
  bool connected_ = false;
  bool ended_ = false;
  std::string bytes_;
};

inline std::string helloOf(std::string_view token, std::string_view more = R"("want":["model"])") {
  return R"({"hello":"tactus-link","version":1,"token":")" + std::string(token) + "\"," + std::string(more) + "}\n";
}

}  // namespace tactus::link
