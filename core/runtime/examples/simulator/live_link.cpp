#include "live_link.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace {

constexpr int kLookMs = 100;                                  // how often the end of the program is looked at
constexpr std::size_t kLongestLine = std::size_t{64} << 20U;  // a model file has at most 32 MiB

template <class Address>
bool connectTo(int socket, const Address& address) {
  return ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

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
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    for (int i = 0; i < 10 && !ending_; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(kLookMs));
  }
}

bool LiveLink::connect() {
  bool connected = false;
  if (!address_.socket.empty()) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    address_.socket.copy(address.sun_path, sizeof address.sun_path - 1);
    socket_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    connected = connectTo(socket_, address);
  } else {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<unsigned short>(address_.port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    connected = connectTo(socket_, address);
  }
  if (!connected) std::fprintf(stderr, "live link: no connection: %s\n", std::strerror(errno));
  return connected;
}

bool LiveLink::sendHello() {
  const std::string hello = R"({"hello":"tactus-link","version":1,"token":")" + address_.token +
                            R"(","name":"example simulator","want":["model"]})"
                            "\n";
  return ::send(socket_, hello.data(), hello.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(hello.size());
}

void LiveLink::readLines() {
  std::string bytes;
  char chunk[65536];
  while (!ending_) {
    pollfd polled{socket_, POLLIN, 0};
    if (::poll(&polled, 1, kLookMs) <= 0) continue;
    const ssize_t got = ::recv(socket_, chunk, sizeof chunk, 0);
    if (got < 0 && errno == EINTR) continue;
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
