// Handles Ctrl-C while a device is in use, so that the program ends in order.
#pragma once

#include <array>
#include <csignal>

namespace tactus::cli {

/// During its lifetime the first SIGINT or SIGTERM only sets a flag, which loops check; the second ends the program at
/// once. The destructor restores the previous handlers. One object at a time in a process.
class InterruptSignals {
 public:
  InterruptSignals();
  ~InterruptSignals();
  InterruptSignals(const InterruptSignals&) = delete;
  InterruptSignals& operator=(const InterruptSignals&) = delete;

  /// Thread: any.
  bool raised() const noexcept;

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM};
  std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace tactus::cli
