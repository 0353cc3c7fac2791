// The operating system functions of the servo thread. Only this part differs between systems.
#pragma once

#include <cstdint>
#include <string>

namespace tactus::haptics {

/// The monotonic clock of the servo, ns. All times in core/haptics use it. It shows the same time as
/// std::chrono::steady_clock. Thread: any. Real-time safe: yes.
std::int64_t monotonicNs() noexcept;

/// Sleeps until `time_ns`. Returns at once if the time has passed. Thread: any.
void sleepUntil(std::int64_t time_ns) noexcept;

/// The permissions that the system granted. A servo without any of them works, but less punctually; the screen says so.
struct RealTime {
  int priority = 0;              ///< of the real-time class; 0: an ordinary thread
  bool fine_timer = false;       ///< the thread wakes up without the timer slack of ordinary threads
  bool memory_locked = false;    ///< no page of the program can be swapped out
  std::string priority_refused;  ///< the system's reason; empty if the priority was granted
  std::string lock_refused;
};

struct RealTimeWish {
  int priority = 80;        ///< 0: not requested. Above the interrupt threads (50), below the kernel's watchdogs (99)
  bool lock_memory = true;  ///< for the whole program, also after the thread has ended
};

/// Makes the calling thread as punctual as the system permits: real-time priority or else the finest timer, locked
/// memory, a preallocated stack, no signal handlers. Thread: the servo's, before its first tick.
RealTime becomeRealTime(const RealTimeWish& wish);

}  // namespace tactus::haptics
