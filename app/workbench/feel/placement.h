// One placement of the tube in numbers: time, strokes, forces and how deep it came.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

struct PlacementSummary {
  double duration_s = 0;  ///< from the first grip to the last release
  std::uint32_t strokes = 0;
  double peak_force_n = 0;  ///< largest resistance that was felt
  double mean_force_n = 0;  ///< mean resistance while the hand held the tube
  double depth_mm = 0;      ///< deepest place of the tip
  bool simulated = false;   ///< on a simulated device
  bool replay = false;      ///< a recording moved the tube; nobody felt it
};

/// Adds up the samples of one placement.
class PlacementMeter {
 public:
  /// Begins a placement; samples from before the orders `number` belong to the one before.
  void begin(std::uint64_t number);
  void add(const haptics::Sample& sample, double depth_mm);

  std::uint32_t strokes() const { return strokes_; }
  /// What has been felt so far; nothing before the first grip.
  std::optional<PlacementSummary> summary() const;

 private:
  std::uint64_t number_ = 0;
  std::uint32_t strokes_ = 0;
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::uint64_t ticks_ = 0;  ///< with the tube in the hand
  double sum_n_ = 0;
  double peak_n_ = 0;
  double depth_mm_ = 0;
};

}  // namespace tactus::workbench
