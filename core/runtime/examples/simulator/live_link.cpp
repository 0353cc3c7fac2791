#include "live_link.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

#ifdef _WIN32
#include <winsock2.h>
#else
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#endif

namespace {

constexpr int kLookMs = 10;                                   // between two looks at the socket and at what was felt
constexpr int kAgainMs = 1000;                                // until the next attempt to connect
constexpr std::size_t kLongestLine = std::size_t{64} << 20U;  // a model file has at most 32 MiB

template <class Socket, class Address>
bool connectTo(Socket socket, const Address& address) {
  return ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

// What Windows and POSIX name differently.
#ifdef _WIN32
using Poll = WSAPOLLFD;
constexpr int kSendFlags = 0;
void startSockets() {
  static const int started = [] {
    WSADATA data;
    return ::WSAStartup(MAKEWORD(2, 2), &data);
  }();
  (void)started;
}
int pollOne(Poll& polled) { return ::WSAPoll(&polled, 1, kLookMs); }
void closeSocket(SOCKET socket) { ::closesocket(socket); }
bool wasInterrupted() { return false; }
std::string reason() { return "error " + std::to_string(::WSAGetLastError()); }
#else
using Poll = pollfd;
constexpr int kSendFlags = MSG_NOSIGNAL;
void startSockets() {}
int pollOne(Poll& polled) { return ::poll(&polled, 1, kLookMs); }
void closeSocket(int socket) { ::close(socket); }
bool wasInterrupted() { return errno == EINTR; }
std::string reason() { return std::strerror(errno); }
#endif

}  // namespace

LiveLink::LiveLink(LinkAddress address, OnModel on_model)
    : address_(std::move(address)), on_model_(std::move(on_model)), thread_([this] { run(); }) {}

LiveLink::~LiveLink() {
  ending_ = true;
  thread_.join();
}

void LiveLink::run() {
  while (!ending_) {
    if (connect() && sendHello()) readLines();
    if (socket_ != kNoSocket) closeSocket(socket_);
    socket_ = kNoSocket;
    for (int ms = 0; ms < kAgainMs && !ending_; ms += kLookMs)
      std::this_thread::sleep_for(std::chrono::milliseconds(kLookMs));
  }
}

bool LiveLink::connect() {
  bool connected = false;
  startSockets();
#ifndef _WIN32
  if (!address_.socket.empty()) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    address_.socket.copy(address.sun_path, sizeof address.sun_path - 1);
    socket_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    connected = connectTo(socket_, address);
  } else
#endif
  {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<unsigned short>(address_.port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    connected = connectTo(socket_, address);
  }
  if (!connected) std::fprintf(stderr, "live link: no connection: %s\n", reason().c_str());
  return connected;
}

bool LiveLink::sendHello() {
  const std::string hello = R"({"hello":"tactus-link","version":1,"token":")" + address_.token +
                            R"(","name":"example simulator","want":["model"]})"
                            "\n";
  return send(hello);
}

bool LiveLink::send(const std::string& line) {
  const int size = static_cast<int>(line.size());
  return ::send(socket_, line.data(), static_cast<std::size_t>(size), kSendFlags) == size;
}

// No locale is set in this program, so the decimal sign is a point. An engine that sets one writes the digits by
// std::to_chars.
bool LiveLink::sendFelt() {
  if (!has_felt_.exchange(false, std::memory_order_acquire)) return true;
  char line[256];
  std::snprintf(line, sizeof line,
                "{\"felt\":{\"time_s\":%.9g,\"depth_mm\":%.9g,\"speed_mm_s\":%.9g,\"force_n\":%.9g}}\n",
                time_s_.load(std::memory_order_relaxed), depth_mm_.load(std::memory_order_relaxed),
                speed_mm_s_.load(std::memory_order_relaxed), force_n_.load(std::memory_order_relaxed));
  return send(line);
}

void LiveLink::readLines() {
  std::string bytes;
  char chunk[65536];
  while (!ending_) {
    Poll polled{};
    polled.fd = socket_;
    polled.events = POLLIN;
    const int ready = pollOne(polled);
    if (!sendFelt()) break;
    if (ready <= 0) continue;
    const auto got = ::recv(socket_, chunk, sizeof chunk, 0);
    if (got < 0 && wasInterrupted()) continue;
    if (got <= 0 || bytes.size() > kLongestLine) break;
    const std::size_t scanned = bytes.size();
    bytes.append(chunk, static_cast<std::size_t>(got));
    std::size_t begin = 0;
    for (auto end = bytes.find('\n', scanned); end != std::string::npos; end = bytes.find('\n', begin)) {
      readLine(bytes.substr(begin, end - begin));
      begin = end + 1;
    }
    bytes.erase(0, begin);
  }
  if (!ending_) std::fprintf(stderr, "live link: the connection has ended; trying again\n");
}

// The server promises the order of the members, and that `file` is the last: no JSON reader is needed.
void LiveLink::readLine(const std::string& line) {
  const std::string model = R"({"model":{"serial":)";
  const std::string file = R"("file":)";
  if (line.compare(0, 9, R"({"error":)") == 0) std::fprintf(stderr, "live link: %s\n", line.c_str());
  if (line.compare(0, model.size(), model) != 0) return;
  const auto begin = line.find(file);
  if (begin == std::string::npos || line.size() < begin + file.size() + 2) return;
  try {
    const auto text = std::string_view(line).substr(begin + file.size(), line.size() - begin - file.size() - 2);
    on_model_(tactus::Model::read(text), std::strtoull(line.c_str() + model.size(), nullptr, 10));
  } catch (const tactus::Error& error) {
    std::fprintf(stderr, "live link: the model before is felt on: %s\n", error.what());
  }
}
