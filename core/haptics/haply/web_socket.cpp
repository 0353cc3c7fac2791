#include "core/haptics/haply/web_socket.h"

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <map>
#include <thread>
#include <utility>

#include "core/haptics/device/device_threads.h"

namespace tactus::haptics {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using Tcp = asio::ip::tcp;
using Stream = websocket::stream<beast::tcp_stream>;
using Code = beast::error_code;
using Clock = std::chrono::steady_clock;

constexpr double kSendPatienceS = 0.1;
constexpr double kClosePatienceS = 0.1;

Clock::duration durationOf(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

asio::ip::address loopback4() { return asio::ip::address_v4::loopback(); }
asio::ip::address loopback6() { return asio::ip::address_v6::loopback(); }

/// Each message is one text. A small one leaves at once, without waiting for more to send.
void prepare(Stream& stream) {
  Code ignored;
  beast::get_lowest_layer(stream).socket().set_option(Tcp::no_delay(true), ignored);
  stream.text(true);
  stream.auto_fragment(false);
  stream.read_message_max(kMostMessageBytes);
}

tl::unexpected<base::Error> refused(const std::string& place, std::string found, std::string wanted) {
  return base::fail(base::ErrorCode::kIo, place, std::move(found), std::move(wanted));
}

}  // namespace

// The client. Its operations run while it waits for one of them, and at no other time.

struct WebSocketClient::Connection {
  explicit Connection(std::string name) : place(std::move(name)) {}

  /// Whether the operation has ended in time; `ended` is what its handler sets.
  template <class Ended>
  bool waitFor(const Ended& ended, double patience_s) {
    const auto end = Clock::now() + durationOf(patience_s);
    io.restart();
    while (!ended) {
      if (io.run_one_until(end) == 0 && (Clock::now() >= end || io.stopped())) break;
    }
    return static_cast<bool>(ended);
  }

  std::string place;
  asio::io_context io{1};
  Stream stream{io};
  beast::flat_buffer in;
  bool is_reading = false;
  std::optional<Code> read;
};

base::Result<std::unique_ptr<WebSocketClient>> WebSocketClient::connect(const std::string& service, std::uint16_t port,
                                                                        double patience_s) {
  const std::string place = "localhost:" + std::to_string(port);
  const std::string wanted = "the " + service + ", started";
  auto connection = std::make_unique<Connection>(place);
  const std::array<Tcp::endpoint, 2> ends{Tcp::endpoint(loopback4(), port), Tcp::endpoint(loopback6(), port)};
  std::optional<Code> done;
  auto& tcp = beast::get_lowest_layer(connection->stream);
  tcp.expires_after(durationOf(patience_s));
  tcp.async_connect(ends, [&done](Code code, const Tcp::endpoint&) { done = code; });
  connection->waitFor(done, 2 * patience_s);
  if (!done || *done) return refused(place, "no program that listens there", wanted);

  tcp.expires_never();
  prepare(connection->stream);
  auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::client);
  timeout.handshake_timeout = durationOf(patience_s);
  timeout.idle_timeout = websocket::stream_base::none();
  connection->stream.set_option(timeout);
  done.reset();
  connection->stream.async_handshake(place, "/", [&done](Code code) { done = code; });
  connection->waitFor(done, 2 * patience_s);
  if (!done || *done) return refused(place, "a program that does not answer as a WebSocket service does", wanted);
  return std::unique_ptr<WebSocketClient>(new WebSocketClient(std::move(connection)));
}

WebSocketClient::WebSocketClient(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}

WebSocketClient::~WebSocketClient() {
  Connection& c = *connection_;
  if (!c.stream.is_open()) return;
  // The other side ends what is being read.
  std::optional<Code> closed;
  c.stream.async_close(websocket::close_code::normal, [&closed](Code code) { closed = code; });
  c.waitFor(closed, kClosePatienceS);
  Code ignored;
  beast::get_lowest_layer(c.stream).socket().close(ignored);
  // The handlers that are left refer to this call.
  c.io.restart();
  c.io.run_for(durationOf(kClosePatienceS));
}

base::Result<std::optional<std::string_view>> WebSocketClient::receive(double patience_s) {
  Connection& c = *connection_;
  if (!c.is_reading) {
    c.in.consume(c.in.size());
    c.read.reset();
    c.is_reading = true;
    c.stream.async_read(c.in, [&c](Code code, std::size_t) { c.read = code; });
  }
  if (!c.waitFor(c.read, patience_s)) return std::optional<std::string_view>();
  c.is_reading = false;
  if (*c.read == websocket::error::message_too_big || *c.read == websocket::error::buffer_overflow)
    return refused(c.place, "a message that is too large", "at most " + std::to_string(kMostMessageBytes) + " bytes");
  if (*c.read) return refused(c.place, "the connection has ended", "a service that stays there");
  const auto bytes = c.in.cdata();
  return std::optional(std::string_view(static_cast<const char*>(bytes.data()), bytes.size()));
}

bool WebSocketClient::hasMore() const {
  Code code;
  return beast::get_lowest_layer(connection_->stream).socket().available(code) > 0 && !code;
}

base::Result<void> WebSocketClient::send(std::string_view text) {
  Connection& c = *connection_;
  std::optional<Code> sent;
  c.stream.async_write(asio::buffer(text.data(), text.size()), [&sent](Code code, std::size_t) { sent = code; });
  c.waitFor(sent, kSendPatienceS);
  if (sent && !*sent) return {};
  if (!sent) {
    // The text and the flag end with this call, so the connection has to end first.
    Code ignored;
    beast::get_lowest_layer(c.stream).socket().close(ignored);
    c.waitFor(sent, kClosePatienceS);
  }
  return refused(c.place, "the connection has ended", "a service that takes commands");
}

// The server.

struct WebSocketServer::Core {
  struct Session {
    Session(Core& owner, Tcp::socket socket, std::uint64_t number)
        : core(owner), id(number), stream(std::move(socket)), timer(owner.io) {}

    Core& core;
    std::uint64_t id;
    bool is_greeted = false;
    Stream stream;
    asio::steady_timer timer;
    beast::flat_buffer in;
    std::string out;
  };
  using Shared = std::shared_ptr<Session>;

  explicit Core(WebSocketHandler& served) : handler(served) {}

  bool listen(const Tcp::endpoint& end) {
    Code code;
    Tcp::acceptor& acceptor = acceptors.emplace_back(io);
    acceptor.open(end.protocol(), code);
    if (!code && end.address().is_v6()) acceptor.set_option(asio::ip::v6_only(true), code);
    if (!code) acceptor.set_option(asio::socket_base::reuse_address(true), code);
    if (!code) acceptor.bind(end, code);
    if (!code) acceptor.listen(asio::socket_base::max_listen_connections, code);
    if (code) acceptors.pop_back();
    return !code;
  }

  void accept(Tcp::acceptor& acceptor) {
    acceptor.async_accept([this, &acceptor](Code code, Tcp::socket socket) {
      if (!acceptor.is_open()) return;
      if (!code) admit(std::move(socket));
      accept(acceptor);
    });
  }

  void admit(Tcp::socket socket) {
    const auto session = std::make_shared<Session>(*this, std::move(socket), ++clients);
    const bool is_full = sessions.size() >= kMostClients;
    sessions[session->id] = session;
    prepare(session->stream);
    session->stream.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    session->stream.async_accept([this, session, is_full](Code code) {
      if (code) return end(session);
      if (is_full) return turnAway(session);
      session->is_greeted = true;
      const auto greeting = handler.greet(session->id);
      if (!greeting) return read(session);
      write(session, *greeting);
    });
  }

  void turnAway(const Shared& session) {
    const websocket::close_reason reason(websocket::close_code::try_again_later,
                                         "Eight clients are connected. Close one of them and try again.");
    session->stream.async_close(reason, [this, session](Code) { end(session); });
  }

  void read(const Shared& session) {
    session->in.consume(session->in.size());
    session->stream.async_read(session->in, [this, session](Code code, std::size_t) {
      if (code) return end(session);
      const auto bytes = session->in.cdata();
      auto reply = handler.reply(session->id, {static_cast<const char*>(bytes.data()), bytes.size()});
      if (reply.dies) return cut();
      if (!reply.text) return read(session);
      if (reply.delay_s <= 0) return write(session, std::move(*reply.text));
      session->timer.expires_after(durationOf(reply.delay_s));
      session->timer.async_wait([this, session, text = std::move(*reply.text)](Code cancelled) mutable {
        if (!cancelled) write(session, std::move(text));
      });
    });
  }

  void write(const Shared& session, std::string text) {
    session->out = std::move(text);
    session->stream.async_write(asio::buffer(session->out), [this, session](Code code, std::size_t) {
      if (code) return end(session);
      read(session);
    });
  }

  void end(const Shared& session) {
    if (sessions.erase(session->id) != 0 && session->is_greeted) handler.left(session->id);
  }

  void cut() {
    Code ignored;
    for (Tcp::acceptor& acceptor : acceptors) acceptor.close(ignored);
    const auto open = sessions;
    for (const auto& [id, session] : open) {
      session->timer.cancel();
      beast::get_lowest_layer(session->stream).socket().close(ignored);
      end(session);
    }
  }

  WebSocketHandler& handler;
  asio::io_context io{1};
  std::deque<Tcp::acceptor> acceptors;
  std::map<std::uint64_t, Shared> sessions;
  std::uint64_t clients = 0;
  std::uint16_t port = 0;
  std::thread thread;
};

base::Result<std::unique_ptr<WebSocketServer>> WebSocketServer::start(std::uint16_t port, WebSocketHandler& handler) {
  auto core = std::make_unique<Core>(handler);
  if (!core->listen({loopback4(), port}))
    return refused("port " + std::to_string(port), "it cannot be listened at, most likely because a program does so",
                   "a free port: --port 0 finds one");
  Code ignored;
  core->port = core->acceptors.front().local_endpoint(ignored).port();
  // Programs that say `localhost` may get ::1 first. Not every computer has it.
  core->listen({loopback6(), core->port});
  for (Tcp::acceptor& acceptor : core->acceptors) core->accept(acceptor);
  core->thread = startDeviceThread([core = core.get()] { core->io.run(); });
  return std::unique_ptr<WebSocketServer>(new WebSocketServer(std::move(core)));
}

WebSocketServer::WebSocketServer(std::unique_ptr<Core> core) : core_(std::move(core)) {}

WebSocketServer::~WebSocketServer() {
  asio::post(core_->io, [core = core_.get()] {
    core->cut();
    core->io.stop();
  });
  core_->thread.join();
}

std::uint16_t WebSocketServer::port() const noexcept { return core_->port; }

}  // namespace tactus::haptics
