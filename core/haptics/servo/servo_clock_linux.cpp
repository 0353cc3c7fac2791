#include <cerrno>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <system_error>

#include "core/haptics/servo/servo_clock.h"

namespace tactus::haptics {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;
/// More than a tick uses, the model included; each page of it is then in memory.
constexpr std::size_t kStackBytes = 256 * 1024;
constexpr std::size_t kPageBytes = 4096;

std::string reason(int error) { return std::generic_category().message(error); }

[[gnu::noinline]] void touchStack() noexcept {
  volatile std::byte stack[kStackBytes];
  for (std::size_t i = 0; i < kStackBytes; i += kPageBytes) stack[i] = std::byte{0};
  static_cast<void>(stack[0]);
}

/// 0 or the error. Memory that is still to come is locked only where there is no limit to it: past a limit, every
/// allocation of the program would fail.
int lockMemory() noexcept {
  rlimit limit{};
  const bool unlimited = getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
  return mlockall(unlimited ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0 ? 0 : errno;
}

}  // namespace

std::int64_t monotonicNs() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kSecondNs + now.tv_nsec;
}

void sleepUntil(std::int64_t time_ns) noexcept {
  const timespec time{time_ns / kSecondNs, time_ns % kSecondNs};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
  }
}

RealTime becomeRealTime(const RealTimeWish& wish) {
  RealTime out;
  pthread_setname_np(pthread_self(), "tactus-servo");
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);

  out.fine_timer = prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) == 0;
  if (wish.priority > 0) {
    const sched_param priority{wish.priority};
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
    if (error == 0) out.priority = wish.priority;
    if (error != 0) out.priority_refused = reason(error);
  }

  if (wish.lock_memory) {
    const int error = lockMemory();
    out.memory_locked = error == 0;
    if (error != 0) out.lock_refused = reason(error);
  }
  touchStack();
  return out;
}

}  // namespace tactus::haptics
