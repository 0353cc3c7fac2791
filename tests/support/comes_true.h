// Waiting for what another thread does.
#pragma once

#include <chrono>
#include <thread>

namespace tactus::support {

/// Whether `condition` came true before a deadline that only a broken program misses. `step` is called in between.
template <typename Condition, typename Step>
bool comesTrue(Condition condition, Step step) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    step();
  }
  return true;
}

template <typename Condition>
bool comesTrue(Condition condition) {
  return comesTrue(condition, std::this_thread::yield);
}

}  // namespace tactus::support
