// Points that lie one after another, as the C interface takes them, for a batch that wants one array per input.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/fuzzy/batch.h"
#include "core/fuzzy/force_model.h"

namespace tactus::runtime {

inline constexpr std::size_t kTilePoints = 1024;  ///< more would cost stack and no longer gains time

/// Evaluates `points` points of `width` inputs each, a tile at a time. `evaluate(columns, result)` is a batch of
/// core/fuzzy. `fired` may be null. Real-time safe: yes, if `evaluate` is; at most 80 KiB of stack.
template <typename Evaluate>
void inTiles(const double* inputs, std::size_t points, std::size_t width, double* force_n, unsigned char* fired,
             Evaluate&& evaluate) noexcept {
  std::array<double, fuzzy::kMostInputs * kTilePoints> values;
  std::array<std::uint8_t, kTilePoints> unread;
  std::array<std::span<const double>, fuzzy::kMostInputs> columns;
  for (std::size_t first = 0; first < points; first += kTilePoints) {
    const std::size_t count = std::min(kTilePoints, points - first);
    for (std::size_t input = 0; input < width; ++input) {
      double* const column = values.data() + input * kTilePoints;
      const double* from = inputs + first * width + input;
      for (std::size_t p = 0; p < count; ++p, from += width) column[p] = *from;
      columns[input] = {column, count};
    }
    std::uint8_t* const told = fired != nullptr ? fired + first : unread.data();
    evaluate(std::span(columns).first(width), fuzzy::BatchResult{{force_n + first, count}, {told, count}});
  }
}

/// What a batch gives for no model or no points to read.
inline void noForces(std::size_t points, double* force_n, unsigned char* fired) noexcept {
  if (force_n != nullptr) std::fill_n(force_n, points, 0.0);
  if (fired != nullptr) std::fill_n(fired, points, static_cast<unsigned char>(0));
}

/// One force for the C interface.
inline double handOut(fuzzy::Evaluation force, int* fired) noexcept {
  if (fired != nullptr) *fired = force.fired ? 1 : 0;
  return force.force_n;
}

}  // namespace tactus::runtime
