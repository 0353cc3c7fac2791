// Randomized loops: a tenth of their rounds each day, with seeds from the date, so that the days together see more than
// one list of seeds. All rounds with TACTUS_SOAK=1 (preset soak).
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace tactus::support {

/// Days since 1970, or the value of TACTUS_TEST_SEED. Said once, so that a failure can be repeated.
inline std::uint64_t seedOfToday() {
  static const std::uint64_t seed = [] {
    const char* const wanted = std::getenv("TACTUS_TEST_SEED");
    const auto hours =
        std::chrono::duration_cast<std::chrono::hours>(std::chrono::system_clock::now().time_since_epoch());
    const std::uint64_t day =
        wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : static_cast<std::uint64_t>(hours.count()) / 24;
    std::cout << "Seed of today: " << day << "; TACTUS_TEST_SEED=" << day << " repeats it\n";
    return day;
  }();
  return seed;
}

/// The first seed of today's rounds: those of two days never meet.
inline std::uint64_t firstSeedOfToday() { return seedOfToday() * 1'000'000 + 1; }

/// A tenth of `full`, at least 1; all of it in the soak.
inline int rounds(int full) { return std::getenv("TACTUS_SOAK") != nullptr ? full : std::max(1, full / 10); }

}  // namespace tactus::support
