#include "app/link/link_server.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <list>
#include <memory>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <optional>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

#include "app/link/client_session.h"
#include "app/link/link_lines.h"
#include "app/link/link_sockets.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/file.h"

namespace tactus::link {

// One connection of the live link: a socket with the protocol on it. For link_server.cpp.

/// Thread: that of the server. Never blocks.
class LinkConnection {
 public:
  using Clock = std::chrono::steady_clock;

  /// `socket` must not block. The first line must be there at `hello_by`.
  LinkConnection(base::Descriptor socket, std::uint64_t number, Clock::time_point hello_by);

  std::uint64_t number() const { return number_; }
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
  std::uint64_t number_;
  std::string address_;
  ClientSession session_;
  std::optional<Clock::time_point> deadline_;
  bool input_ended_ = false;
  bool output_ended_ = false;
};

namespace {

/// Lines of one client before it is the turn of the others.
constexpr int kLinesInTurn = 64;
/// Bytes sent to one client before it is the turn of the others.
constexpr std::size_t kBytesInTurn = std::size_t{256} << 10U;
/// What the system keeps of lines that a client does not read. More would be older than needed: what was given to the
/// system can no longer be replaced by something newer.
constexpr int kKeptBytes = 32 << 10;
/// For taking the last line, and for throwing away what is still on its way: a connection that is closed with unread
/// bytes would lose that line.
constexpr auto kEndingTime = std::chrono::seconds(2);

}  // namespace

LinkConnection::LinkConnection(base::Descriptor socket, std::uint64_t number, Clock::time_point hello_by)
    : socket_(std::move(socket)), number_(number), address_(peerOf(socket_.number())), deadline_(hello_by) {
  const int yes = 1;
  // A line goes out at once. A socket file has no such setting.
  ::setsockopt(socket_.number(), SOL_SOCKET, SO_SNDBUF, &kKeptBytes, sizeof kKeptBytes);
  ::setsockopt(socket_.number(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

short LinkConnection::events() {
  const bool reads = !input_ended_ && (session_.wantsInput() || session_.phase() == ClientSession::Phase::kEnding);
  const bool writes = !output_ended_ && !session_.output().empty();
  return static_cast<short>((reads ? POLLIN : 0) | (writes ? POLLOUT : 0));
}

void LinkConnection::keepTime(Clock::time_point now) {
  if (!deadline_ || now < *deadline_) return;
  if (session_.phase() == ClientSession::Phase::kHello) {
    session_.refuse("found no hello in time, wanted it as the first line");
    deadline_ = now + kEndingTime;
  } else {
    close();
  }
}

void LinkConnection::read() {
  std::array<char, std::size_t{64} << 10U> bytes;
  const ssize_t got = ::recv(socket_.number(), bytes.data(), bytes.size(), 0);
  if (got > 0) {
    session_.receive({bytes.data(), static_cast<std::size_t>(got)});
  } else if (got == 0) {
    input_ended_ = true;
  } else if (errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK) {
    close();
  }
}

void LinkConnection::work(const SessionNeeds& needs, Clock::time_point now) {
  if (isClosed()) return;
  const auto before = session_.phase();
  session_.work(kLinesInTurn, needs);
  if (session_.phase() != before) {
    deadline_.reset();
    if (session_.phase() == ClientSession::Phase::kEnding) deadline_ = now + kEndingTime;
  }
  send();
  if (isClosed() || session_.hasWork() || !session_.output().empty()) return;
  if (input_ended_) {
    close();
  } else if (session_.phase() == ClientSession::Phase::kEnding && !output_ended_) {
    ::shutdown(socket_.number(), SHUT_WR);
    output_ended_ = true;
  }
}

void LinkConnection::send() {
  std::size_t in_turn = 0;
  for (auto output = session_.output(); !output.empty() && in_turn < kBytesInTurn; output = session_.output()) {
    const ssize_t taken = ::send(socket_.number(), output.data(), output.size(), MSG_NOSIGNAL);
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
    if (taken < 0) return close();
    session_.sent(static_cast<std::size_t>(taken));
    in_turn += static_cast<std::size_t>(taken);
  }
}

namespace {

using Clock = LinkConnection::Clock;

/// How long no connection is accepted when the program has no descriptor left for one.
constexpr auto kPauseOfAccepting = std::chrono::milliseconds(200);

constexpr const char* kFull = "found as many clients as the server takes, wanted fewer: try again when one has left";

/// Blocks all signals for the thread that is started meanwhile: they are for the others.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

int millisecondsUntil(std::optional<Clock::time_point> time, Clock::time_point now) {
  if (!time) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(*time - now).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 60'000));
}

}  // namespace

/// What the server's thread does.
class LinkServer::Loop {
 public:
  explicit Loop(LinkServer& server) : server_(server) {}

  void run() {
    takeModel();
    while (!server_.ending_.load(std::memory_order_acquire)) turn();
  }

 private:
  void turn() {
    std::vector<pollfd> polled;
    polled.push_back({server_.wake_read_.number(), POLLIN, 0});
    const auto& listening = server_.sockets_.listening();
    const bool accepts = Clock::now() >= accepts_at_;
    for (const auto& socket : listening)
      polled.push_back({socket.number(), static_cast<short>(accepts ? POLLIN : 0), 0});
    for (auto& connection : connections_) polled.push_back({connection.socket(), connection.events(), 0});
    ::poll(polled.data(), polled.size(), timeout(Clock::now(), accepts));

    const auto now = Clock::now();
    if (polled[0].revents != 0) drainWake();
    takeModel();
    auto events = polled.begin() + 1 + static_cast<std::ptrdiff_t>(listening.size());
    // Those that are accepted now are polled from the next turn on.
    std::size_t polled_connections = connections_.size();
    for (auto& connection : connections_) {
      if (polled_connections-- == 0) break;
      const short happened = (events++)->revents;
      if ((happened & POLLIN) != 0) {
        connection.read();
      } else if ((happened & (POLLERR | POLLHUP | POLLNVAL)) != 0) {
        connection.close();
      }
    }
    for (std::size_t i = 0; i < listening.size(); ++i) {
      if (polled[1 + i].revents != 0) accept(listening[i].number(), now);
    }
    takeStates();
    work(now);
    tellClients();
  }

  int timeout(Clock::time_point now, bool accepts) const {
    std::optional<Clock::time_point> first;
    const auto include = [&first](Clock::time_point time) { first = first ? std::min(*first, time) : time; };
    if (!accepts) include(accepts_at_);
    for (const auto& connection : connections_) {
      if (connection.session().hasWork()) return 0;
      if (const auto deadline = connection.deadline()) include(*deadline);
    }
    return millisecondsUntil(first, now);
  }

  void drainWake() {
    std::array<char, 64> bytes;
    while (::read(server_.wake_read_.number(), bytes.data(), bytes.size()) > 0) continue;
  }

  void takeModel() {
    const auto* const letter = server_.models_.newest();
    if (letter == nullptr || letter->number == model_letter_) return;
    model_letter_ = letter->number;
    const std::string text = letter->value.text();
    std::string sha256 = base::sha256(text);
    if (model_ && sha256 == model_sha256_) return;
    const std::uint64_t serial = model_ ? model_->serial + 1 : 1;
    model_.emplace(ServedModel{serial, letter->value.compiled,
                               std::make_shared<const std::string>(modelLine(serial, sha256, text)),
                               letter->value.inputs});
    model_sha256_ = std::move(sha256);
    for (auto& connection : connections_) connection.session().offer(*model_);
  }

  void takeStates() {
    const auto* const letter = server_.states_.newest();
    if (letter == nullptr || letter->number == states_letter_) return;
    states_letter_ = letter->number;
    const auto& [setting, states] = letter->value;
    const auto now = Clock::now();
    for (const LinkState& state : states) {
      std::shared_ptr<const std::string> line;
      for (auto& connection : connections_) {
        if (connection.isClosed() || !connection.session().isDue(state.time_s)) continue;
        if (!line) line = std::make_shared<const std::string>(stateLine(state, *setting));
        connection.session().offerState(line);
        connection.work(needsOf(*model_), now);
      }
    }
  }

  void accept(int listening, Clock::time_point now) {
    base::Descriptor socket(::accept4(listening, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket.isOpen()) {
      const bool no_room = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
      if (no_room) accepts_at_ = now + kPauseOfAccepting;
      return;
    }
    const auto is_stranger = [](const LinkConnection& one) { return !one.isGreeted() && !one.isClosed(); };
    if (std::count_if(connections_.begin(), connections_.end(), is_stranger) >= std::ptrdiff_t{kMostStrangers})
      std::find_if(connections_.begin(), connections_.end(), is_stranger)->close();
    connections_.emplace_back(std::move(socket), ++accepted_, now + server_.settings_.hello_time);
    if (greeted() >= kMostClients) connections_.back().session().refuse(kFull);
  }

  std::size_t greeted() const {
    return static_cast<std::size_t>(
        std::count_if(connections_.begin(), connections_.end(),
                      [](const LinkConnection& one) { return one.isGreeted() && !one.isClosed(); }));
  }

  SessionNeeds needsOf(const ServedModel& model) const {
    return {model, server_.settings_.token, server_.settings_.program, greeted() < kMostClients};
  }

  void work(Clock::time_point now) {
    for (auto& connection : connections_) {
      connection.keepTime(now);
      connection.work(needsOf(*model_), now);
    }
    takeFelt();
    connections_.remove_if([](const LinkConnection& one) { return one.isClosed(); });
  }

  /// Keeps where the simulators are for the program, and tells the clients that want to know.
  void takeFelt() {
    std::vector<LinkFelt> arrived;
    for (auto& connection : connections_) {
      auto felt = connection.session().takeFelt();
      if (!felt || connection.isClosed()) continue;
      std::shared_ptr<const std::string> line;
      for (auto& other : connections_) {
        if (&other == &connection || !other.session().hello().wants_felt) continue;
        if (!line) line = std::make_shared<const std::string>(feltLine(*felt, connection.session().hello().name));
        other.session().offerFelt(line);
      }
      arrived.push_back({connection.number(), *std::move(felt)});
    }
    if (arrived.empty()) return;
    bool first = false;
    {
      const std::lock_guard lock(server_.mutex_);
      first = server_.felt_.empty();
      for (LinkFelt& one : arrived) {
        const auto same = [&](const LinkFelt& kept) { return kept.client == one.client; };
        const auto kept = std::find_if(server_.felt_.begin(), server_.felt_.end(), same);
        if (kept == server_.felt_.end()) {
          server_.felt_.push_back(std::move(one));
        } else {
          *kept = std::move(one);
        }
      }
    }
    if (first && server_.felt_arrived_) server_.felt_arrived_();
  }

  void tellClients() {
    std::vector<LinkClient> clients;
    bool wants_states = false;
    for (const auto& connection : connections_) {
      if (!connection.isGreeted()) continue;
      const Hello& hello = connection.session().hello();
      clients.push_back({hello.name, connection.address(), hello.wants_state, connection.number()});
      wants_states = wants_states || hello.wants_state;
    }
    server_.wants_states_.store(wants_states, std::memory_order_relaxed);
    {
      const std::lock_guard lock(server_.mutex_);
      if (server_.clients_ == clients) return;
      server_.clients_ = std::move(clients);
    }
    if (server_.clients_changed_) server_.clients_changed_();
  }

  LinkServer& server_;
  std::list<LinkConnection> connections_;  ///< the oldest first
  std::optional<ServedModel> model_;
  std::string model_sha256_;
  std::uint64_t model_letter_ = 0;
  std::uint64_t states_letter_ = 0;
  std::uint64_t accepted_ = 0;  ///< connections so far
  Clock::time_point accepts_at_{};
};

std::vector<std::string> inputIds(const fuzzy::ForceModel& model) {
  std::vector<std::string> ids;
  for (const fuzzy::Variable& input : model.inputs) ids.push_back(input.id);
  return ids;
}

base::Result<std::unique_ptr<LinkServer>> LinkServer::start(LinkSettings settings, LinkModel model,
                                                            std::function<void()> clients_changed,
                                                            std::function<void()> felt_arrived) {
  TACTUS_CHECK(!settings.token.empty() && model.text);
  TACTUS_TRY(auto sockets, LinkSockets::open(settings.port, settings.socket_path));
  std::unique_ptr<LinkServer> server(
      new LinkServer(std::move(settings), std::move(sockets), std::move(clients_changed), std::move(felt_arrived)));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0)
    return base::fail(base::ErrorCode::kIo, {}, base::systemReason(errno), "a pipe");
  server->wake_read_ = base::Descriptor(ends[0]);
  server->wake_write_ = base::Descriptor(ends[1]);
  server->models_.post(std::move(model));
  const SignalsBlocked blocked;
  server->thread_ = std::thread([raw = server.get()] { Loop(*raw).run(); });
  return server;
}

LinkServer::LinkServer(LinkSettings settings, LinkSockets sockets, std::function<void()> clients_changed,
                       std::function<void()> felt_arrived)
    : settings_(std::move(settings)),
      sockets_(std::move(sockets)),
      clients_changed_(std::move(clients_changed)),
      felt_arrived_(std::move(felt_arrived)) {}

LinkServer::~LinkServer() {
  ending_.store(true, std::memory_order_release);
  if (!thread_.joinable()) return;
  wake();
  thread_.join();
}

void LinkServer::wake() {
  const char byte = 0;
  // A full pipe wakes as well.
  [[maybe_unused]] const ssize_t ignored = ::write(wake_write_.number(), &byte, 1);
}

void LinkServer::publish(LinkModel model) {
  models_.post(std::move(model));
  wake();
}

void LinkServer::publish(LinkStates states) {
  if (!wantsStates() || states.states.empty()) return;
  states_.post(std::move(states));
  wake();
}

std::vector<LinkClient> LinkServer::clients() const {
  const std::lock_guard lock(mutex_);
  return clients_;
}

std::vector<LinkFelt> LinkServer::takeFelt() {
  const std::lock_guard lock(mutex_);
  return std::exchange(felt_, {});
}

}  // namespace tactus::link
