// Ctrl-C while a device is in use: the program ends it in order.
#pragma once

#include <array>
#include <csignal>

namespace tactus::cli {

/// While it lives, the first SIGINT or SIGTERM only sets a flag, which loops look at; the second ends the program at
/// once. The destructor puts back what was there before. One at a time in a process.
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
