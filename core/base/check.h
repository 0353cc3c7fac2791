// The check for our own bugs, active in every build. Never for outside input, which gets an Error.
#pragma once

namespace tactus::base {

/// Stops the program and reports the condition, file and line.
[[noreturn]] void checkFailed(const char* condition, const char* file, int line) noexcept;

}  // namespace tactus::base

#define TACTUS_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::tactus::base::checkFailed(#condition, __FILE__, __LINE__))
