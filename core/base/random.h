// Seeded random numbers, identical on every machine with the same math library.
#pragma once

#include <cstdint>
#include <random>

namespace tactus::base {

/// std::mt19937_64 with our own distributions, because the standard fixes the output of the engine but not of its
/// distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t next() { return engine_(); }
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(engine_() >> 11U) * 0x1.0p-53; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform integer in [0, count), count > 0.
  int below(int count) { return static_cast<int>(uniform() * count); }
  /// Standard normal (Box and Muller 1958).
  double normal();

 private:
  std::mt19937_64 engine_;
};

}  // namespace tactus::base
