// Runs something on a thread on which the kernel permits no system call: what sleeps, wakes, maps memory or touches a
// file or device in any way shows, whichever library it goes through.
#pragma once

#include <functional>
#include <optional>

namespace tactus::support {

struct SystemCalls {
  int count = 0;
  long first = -1;  ///< its number, as in <sys/syscall.h>
};

/// The system calls that `body` attempted; each of them failed. Nothing where the kernel offers no such filter, on
/// processors other than x86-64, and under sanitizers, which make calls of their own.
std::optional<SystemCalls> systemCallsOf(const std::function<void()>& body);

}  // namespace tactus::support
