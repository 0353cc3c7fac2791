// The server of the live link: gives the newest model to simulators, answers their questions, and tells them what the
// hand feels. One thread of its own does all of it; docs/live-link.md shows the protocol.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/link/link_lines.h"
#include "app/link/link_sockets.h"
#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/haptics/servo/mailbox.h"

namespace tactus::link {

struct LinkSettings {
  std::uint16_t port = 0;                      ///< of the loopback; 0: a free one
  std::string socket_path;                     ///< of the socket file; empty: none
  std::string token;                           ///< what clients must know; not empty
  std::string program;                         ///< name and version that clients are told
  std::chrono::milliseconds hello_time{5000};  ///< for the first line of a client
};

/// A model for the clients. Immutable.
struct LinkModel {
  fuzzy::CompiledModel compiled;
  /// The text of its model file. Called once, by the server's thread, because it takes milliseconds.
  std::function<std::string()> text;
  std::vector<std::string> inputs = {};  ///< ids, in the order of `compiled`
};

/// For LinkModel::inputs.
std::vector<std::string> inputIds(const fuzzy::ForceModel& model);

/// A connected client, for the screen.
struct LinkClient {
  std::string name;     ///< as it says; may be empty
  std::string address;  ///< `port 53312`, `process 4711`
  bool wants_state = false;
  std::uint64_t number = 0;  ///< of its connection, from 1

  bool operator==(const LinkClient&) const = default;
};

/// Where the simulator of a client is.
struct LinkFelt {
  std::uint64_t client = 0;  ///< LinkClient::number
  Felt felt;
};

class LinkServer {
 public:
  static constexpr std::size_t kMostClients = 16;
  /// The most connections that have not said hello yet or are about to end. One more closes the oldest of them.
  static constexpr std::size_t kMostStrangers = 16;

  /// Listens, and serves `model` from now on. The server's thread calls `clients_changed`, and `felt_arrived` where
  /// takeFelt has something new: once until the next takeFelt, however fast the clients are. Both may be empty.
  static base::Result<std::unique_ptr<LinkServer>> start(LinkSettings settings, LinkModel model,
                                                         std::function<void()> clients_changed = {},
                                                         std::function<void()> felt_arrived = {});
  /// Closes all connections.
  ~LinkServer();
  LinkServer(const LinkServer&) = delete;
  LinkServer& operator=(const LinkServer&) = delete;

  std::uint16_t port() const { return sockets_.port(); }
  const std::string& socketPath() const { return sockets_.socketPath(); }

  /// Serves `model` from now on. Its serial number rises, unless its text is that of the model before. Does not wait:
  /// it replaces a model that the server's thread has not taken yet. Thread: the one that called `start`.
  void publish(LinkModel model);
  /// Sends what the hand feels to the clients that asked for it. Does not wait. Thread: the one that called `start`.
  void publish(LinkStates states);
  /// Whether a client wants to know what the hand feels. Thread: any.
  bool wantsStates() const noexcept { return wants_states_.load(std::memory_order_relaxed); }
  /// The clients that have said hello, in the order of their connections. Thread: any.
  std::vector<LinkClient> clients() const;
  /// Where the simulators of clients are that have said so since the last call: the newest of each. Thread: any.
  std::vector<LinkFelt> takeFelt();

 private:
  class Loop;

  LinkServer(LinkSettings settings, LinkSockets sockets, std::function<void()> clients_changed,
             std::function<void()> felt_arrived);
  void wake();

  const LinkSettings settings_;
  LinkSockets sockets_;
  const std::function<void()> clients_changed_;
  const std::function<void()> felt_arrived_;
  // The end that is written to wakes the server's thread.
  base::Descriptor wake_read_;
  base::Descriptor wake_write_;

  haptics::Mailbox<LinkModel> models_;
  haptics::Mailbox<LinkStates> states_;
  std::atomic<bool> ending_{false};
  std::atomic<bool> wants_states_{false};
  mutable std::mutex mutex_;  ///< guards the next two
  std::vector<LinkClient> clients_;
  std::vector<LinkFelt> felt_;
  std::thread thread_;
};

}  // namespace tactus::link
