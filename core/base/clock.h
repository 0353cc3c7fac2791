// Calendar time as text.
#pragma once

#include <chrono>
#include <string>

namespace tactus::base {

/// `time` in UTC as `2026-11-21T08:00:00Z`.
std::string formatUtc(std::chrono::system_clock::time_point time);

}  // namespace tactus::base
