// The always-on check for our own bugs. Never for outside input: that is an Error.
#pragma once

namespace tactus::base {

/// Stops the program with the condition, file and line.
[[noreturn]] void checkFailed(const char* condition, const char* file, int line) noexcept;

}  // namespace tactus::base

#define TACTUS_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::tactus::base::checkFailed(#condition, __FILE__, __LINE__))
