// One connection of the live link: a socket with the protocol on it. For link_server.cpp.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "app/link/client_session.h"
#include "core/base/files/descriptor.h"

namespace tactus::link {

/// Thread: that of the server. Never blocks.
class LinkConnection {
 public:
  using Clock = std::chrono::steady_clock;

  /// `socket` must not block. The first line must be there at `hello_by`.
  LinkConnection(base::Descriptor socket, Clock::time_point hello_by);

  int socket() const { return socket_.number(); }
  const std::string& address() const { return address_; }
  ClientSession& session() { return session_; }
  const ClientSession& session() const { return session_; }
  bool isGreeted() const { return session_.phase() == ClientSession::Phase::kGreeted; }
  bool isClosed() const { return !socket_.isOpen(); }

  /// Events to poll for.
  short events();
  /// When `keepTime` has something to do; nothing: never.
  std::optional<Clock::time_point> deadline() const { return deadline_; }
  /// Refuses a client that has not said hello in time; closes one that does not take its last line.
  void keepTime(Clock::time_point now);
  /// Reads what is there, at most 64 KiB; what comes after an error is thrown away.
  void read();
  /// Reads lines, and sends what the client takes.
  void work(const SessionNeeds& needs, Clock::time_point now);
  void close() { socket_.close(); }

 private:
  void send();

  base::Descriptor socket_;
  std::string address_;
  ClientSession session_;
  std::optional<Clock::time_point> deadline_;
  bool input_ended_ = false;
  bool output_ended_ = false;
};

}  // namespace tactus::link
