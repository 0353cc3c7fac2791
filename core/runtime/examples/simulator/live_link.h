// Follows the live link of Tactus (docs/live-link.md): each model that is edited there arrives here while the simulator
// runs. POSIX sockets and libtactus, nothing else.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <tactus/tactus.hpp>
#include <thread>

struct LinkAddress {
  int port = 0;        // of the loopback
  std::string socket;  // a socket file, in place of the port
  std::string token;   // from the token file that the server names
};

class LiveLink {
 public:
  // Called for each model that arrives, on the thread of the link: it may take its time, the servo loop does not wait.
  using OnModel = std::function<void(const tactus::Model& model, unsigned long long serial)>;

  // Connects, and again each second whenever the connection is lost. What goes wrong is said on stderr.
  LiveLink(LinkAddress address, OnModel on_model);
  ~LiveLink();
  LiveLink(const LiveLink&) = delete;
  LiveLink& operator=(const LiveLink&) = delete;

 private:
  void run();
  bool connect();
  bool sendHello();
  void readLines();
  void readLine(const std::string& line);

  LinkAddress address_;
  OnModel on_model_;
  std::atomic<bool> ending_{false};
  int socket_ = -1;  // touched by the thread of the link alone
  std::thread thread_;
};
