// A slider of the speed lab moved in the real window, without a display: how long until all plots are painted, and
// where the time goes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/bench/workbench_drag.h"

namespace tactus::bench {

/// When a setting moves.
enum class Rhythm {
  kAlone,      ///< everything is computed
  kIntervals,  ///< the intervals of the last setting are being computed
  kDrag,       ///< with every frame
};

/// What the moves of one setting took, one number for each, ms. In a drag only `strip_ms`, which may be fewer.
struct LabTimes {
  std::string setting;
  Rhythm rhythm = Rhythm::kAlone;
  std::vector<double> result_ms;  ///< until the clusters and terms are back in the thread of the window
  std::vector<double> worker_ms;  ///< of this, on a processor, all other threads together
  std::vector<double> shown_ms;   ///< until the last plot is painted
  std::vector<double> window_ms;  ///< of this, on a processor, the thread of the window
  std::vector<double> strip_ms;   ///< until the last plot is painted, as the strip of the window says
  int results = 0;                ///< in a drag: results that came while it went on
  std::map<std::string, std::vector<double>> part_ms;  ///< work and painting by plot, on a processor
};

/// Moves alpha, m and trimming of the speed lab `moves` times each, in each rhythm, in a window of 1920 x 1080 px with
/// the demo's four participants, their strokes resampled to `samples` each.
std::vector<LabTimes> moveLabSettings(TimedApplication& application, int samples, int moves);

}  // namespace tactus::bench
