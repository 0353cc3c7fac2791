// Follows the live link of Tactus (docs/live-link.md): each model that is edited there arrives here while the simulator
// runs, and Tactus shows where the simulator is. Sockets of POSIX or Windows and libtactus, nothing else.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <tactus/tactus.hpp>
#include <thread>

struct LinkAddress {
  int port = 0;        // of the loopback
  std::string socket;  // a socket file, in place of the port; not on Windows
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

  // Where the simulator is; a hundred times a second the newest is sent. Depth as the model counts it. Thread: one,
  // that of the loop. Real-time safe: yes. What is sent may mix two steps: it is for a screen.
  void felt(double time_s, double depth_mm, double speed_mm_s, double force_n) {
    time_s_.store(time_s, std::memory_order_relaxed);
    depth_mm_.store(depth_mm, std::memory_order_relaxed);
    speed_mm_s_.store(speed_mm_s, std::memory_order_relaxed);
    force_n_.store(force_n, std::memory_order_relaxed);
    has_felt_.store(true, std::memory_order_release);
  }

 private:
#ifdef _WIN32
  using Socket = unsigned long long;  // SOCKET of 64-bit Windows
#else
  using Socket = int;
#endif
  static constexpr Socket kNoSocket = static_cast<Socket>(-1);

  void run();
  bool connect();
  bool send(const std::string& line);
  bool sendHello();
  bool sendFelt();
  void readLines();
  void readLine(const std::string& line);

  LinkAddress address_;
  OnModel on_model_;
  std::atomic<bool> ending_{false};
  std::atomic<bool> has_felt_{false};
  std::atomic<double> time_s_{0}, depth_mm_{0}, speed_mm_s_{0}, force_n_{0};
  Socket socket_ = kNoSocket;  // touched by the thread of the link alone
  std::thread thread_;
};
