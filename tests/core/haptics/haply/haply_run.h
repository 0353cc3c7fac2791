// What the tests of the Haply device share: waiting for a condition, and a service that says what a test wants.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "core/haptics/haply/haply_device.h"
#include "core/haptics/haply/haply_messages.h"
#include "core/haptics/haply/web_socket.h"
#include "core/haptics/servo/servo_clock.h"

#include "tests/support/comes_true.h"

namespace tactus::haptics {

/// Whether `condition` came true. `step`: once per millisecond.
template <typename Condition, typename Step>
bool comesTrue(Condition condition, Step step) {
  return support::comesTrue(condition, [&] {
    step();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
}

/// The same while a servo would ask for `force_n`.
template <typename Condition>
bool comesTrue(HaplyDevice& device, const Vector3& force_n, Condition condition) {
  return comesTrue([&] { return condition(device.read(monotonicNs())); },
                   [&] { device.write(force_n, monotonicNs()); });
}

/// A service of our own. The test may change what it says at any time.
class ScriptedService final : public WebSocketHandler {
 public:
  explicit ScriptedService(std::string greeting) : greeting_(std::move(greeting)), says_(greeting_) {
    auto started = WebSocketServer::start(0, *this);
    if (!started) std::abort();
    server_ = *std::move(started);
  }
  ~ScriptedService() override { server_.reset(); }

  std::uint16_t port() const { return server_->port(); }
  /// From now on each message is answered by `text`; nothing: by none.
  void say(std::optional<std::string> text) {
    const std::lock_guard lock(mutex_);
    says_ = std::move(text);
  }
  std::string lastRequest() const {
    const std::lock_guard lock(mutex_);
    return last_;
  }

  std::optional<std::string> greet(std::uint64_t) override { return greeting_; }
  WebSocketReply reply(std::uint64_t, std::string_view text) override {
    const std::lock_guard lock(mutex_);
    last_ = std::string(text);
    return {says_, 0.0005, false};
  }
  void left(std::uint64_t) override {}

 private:
  const std::string greeting_;
  mutable std::mutex mutex_;
  std::optional<std::string> says_;
  std::string last_;
  std::unique_ptr<WebSocketServer> server_;
};

/// As the documents of the service show it (3.5), shortened.
inline std::string inventory(const std::string& basis = "XYZ", double scale = 1) {
  return R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{"type":"inverse3","port":"COM12",)"
         R"("gravity_compensation":{"enabled":true,"scaling_factor":1.0},"handedness":"right","preset":"defaults",)"
         R"("basis":{"permutation":")" +
         basis + R"("},"mount":{"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},"scale":{"x":)" +
         std::to_string(scale).substr(0, 1) +
         R"(,"y":1,"z":1}}},"state":{"cursor_position":{"x":0.01,"y":-0.12,"z":0.15},)"
         R"("cursor_velocity":{"x":0.0,"y":0.5,"z":-0.25}},"status":{"calibrated":true,"power_supply":true}}],)"
         R"("wireless_verse_grip":[{"device_id":"61548","state":{"buttons":{"a":false,"b":true,"c":false}}}]})";
}

/// A later message, in which `state` is that of 049D.
inline std::string stateOf049D(const std::string& state) {
  return R"({"inverse3":[{"device_id":"049D","state":)" + state + "}]}";
}

}  // namespace tactus::haptics
