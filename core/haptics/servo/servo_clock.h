// What the servo thread needs of the operating system; the only part that differs between systems.
#pragma once

#include <cstdint>
#include <string>

namespace tactus::haptics {

/// The monotonic clock of the servo, ns: that of every time in core/haptics. std::chrono::steady_clock tells the same.
/// Thread: any. Real-time safe: yes.
std::int64_t monotonicNs() noexcept;

/// Sleeps until the clock shows `time_ns`; returns at once where it has passed. Thread: any.
void sleepUntil(std::int64_t time_ns) noexcept;

/// What the system permitted. A servo without any of it works, only less punctually; the screen says so.
struct RealTime {
  int priority = 0;              ///< of the real-time class; 0: an ordinary thread
  bool fine_timer = false;       ///< wakes up without the slack of ordinary threads
  bool memory_locked = false;    ///< no page of the program can be swapped out
  std::string priority_refused;  ///< the system's reason, empty where it was permitted
  std::string lock_refused;
};

struct RealTimeWish {
  int priority = 80;        ///< 0: not asked for. Above the interrupt threads (50), below the kernel's watchdogs (99)
  bool lock_memory = true;  ///< of the whole program, also after the thread has ended
};

/// Makes the calling thread as punctual as is permitted: real-time priority or else the finest timer, memory locked,
/// a stack that is there already, no signal handlers on it. Thread: the servo's, before its first tick.
RealTime becomeRealTime(const RealTimeWish& wish);

}  // namespace tactus::haptics
