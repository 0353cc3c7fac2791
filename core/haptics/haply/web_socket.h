// WebSockets on the loopback, by Boost.Beast: a client for one thread, and a server on a thread of its own. Boost is
// included by web_socket.cpp alone, because its headers take seconds to compile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::haptics {

/// A larger message ends the connection.
inline constexpr std::size_t kMostMessageBytes = std::size_t{256} << 10U;

/// The connection to a service of this computer. Thread: one.
class WebSocketClient {
 public:
  /// Connects to `localhost`: 127.0.0.1, or ::1 if no program listens there. Refused: no program listens, it does not
  /// speak WebSocket, it does not answer in `patience_s`. `service`: its name for errors.
  static base::Result<std::unique_ptr<WebSocketClient>> connect(const std::string& service, std::uint16_t port,
                                                                double patience_s);
  /// Closes the connection; waits at most 0.1 s for the other side to agree.
  ~WebSocketClient();
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  /// The next message; nothing if none has come in `patience_s`. It is valid until the next call. Refused: the
  /// connection has ended, or the message is too large; then it has ended, too.
  base::Result<std::optional<std::string_view>> receive(double patience_s);
  /// Whether bytes wait that `receive` has not taken.
  bool hasMore() const;
  /// Sends a text. Refused: the connection has ended, or the other side takes nothing for 0.1 s.
  base::Result<void> send(std::string_view text);

 private:
  struct Connection;
  explicit WebSocketClient(std::unique_ptr<Connection> connection);

  std::unique_ptr<Connection> connection_;
};

/// The reply to one message of a client.
struct WebSocketReply {
  std::optional<std::string> text;  ///< nothing: the message has no reply
  double delay_s = 0;               ///< how long the reply waits; the client's next message is read afterwards
  bool dies = false;                ///< cuts all connections and listens no more, as when the program has died
};

/// What a server does. Called on the thread of the server. `client`: a number of the connection, from 1.
class WebSocketHandler {
 public:
  virtual ~WebSocketHandler() = default;
  /// The first message to a client; nothing: there is none.
  virtual std::optional<std::string> greet(std::uint64_t client) = 0;
  virtual WebSocketReply reply(std::uint64_t client, std::string_view text) = 0;
  /// The connection has ended.
  virtual void left(std::uint64_t client) = 0;
};

/// Serves at most kMostClients at once; a further one is closed with a sentence as its reason.
class WebSocketServer {
 public:
  static constexpr std::size_t kMostClients = 8;

  /// Listens at `port` of 127.0.0.1 (and of ::1 where there is one); 0: a free port. `handler` must outlive the server.
  static base::Result<std::unique_ptr<WebSocketServer>> start(std::uint16_t port, WebSocketHandler& handler);
  /// Cuts all connections and waits for the thread.
  ~WebSocketServer();
  WebSocketServer(const WebSocketServer&) = delete;
  WebSocketServer& operator=(const WebSocketServer&) = delete;

  std::uint16_t port() const noexcept;

 private:
  struct Core;
  explicit WebSocketServer(std::unique_ptr<Core> core);

  std::unique_ptr<Core> core_;
};

}  // namespace tactus::haptics
