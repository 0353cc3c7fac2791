// One placement of the tube in numbers: time, strokes, forces and depth.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

struct PlacementSummary {
  double duration_s = 0;  ///< from the first grip to the last release
  std::uint32_t strokes = 0;
  double peak_force_n = 0;  ///< largest resistance at the hand
  double mean_force_n = 0;  ///< mean resistance while the hand held the tube
  double depth_mm = 0;      ///< greatest depth of the tip
  bool simulated = false;   ///< on a simulated device
  bool replay = false;      ///< a recording moved the tube; no person felt it
};

/// Adds up the samples of one placement.
class PlacementMeter {
 public:
  /// Begins a placement. Samples with orders before `number` belong to the previous one.
  void begin(std::uint64_t number);
  void add(const haptics::Sample& sample, double depth_mm);

  std::uint32_t strokes() const { return strokes_; }
  /// The numbers so far; nothing before the first grip.
  std::optional<PlacementSummary> summary() const;

 private:
  std::uint64_t number_ = 0;
  std::uint32_t strokes_ = 0;
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::uint64_t ticks_ = 0;  ///< while the hand held the tube
  double sum_n_ = 0;
  double peak_n_ = 0;
  double depth_mm_ = 0;
};

}  // namespace tactus::workbench
