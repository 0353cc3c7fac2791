#include "app/link/link_connection.h"

#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

#include "app/link/link_sockets.h"

namespace tactus::link {
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

LinkConnection::LinkConnection(base::Descriptor socket, Clock::time_point hello_by)
    : socket_(std::move(socket)), address_(peerOf(socket_.number())), deadline_(hello_by) {
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

}  // namespace tactus::link
