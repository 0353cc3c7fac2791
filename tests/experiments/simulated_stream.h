// Simulated streams of hand positions whose strokes are known: commanded motion, tremor, noise, quantization.
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/speed_from_positions.h"

namespace tactus::experiments {

/// The truth about one stroke: from the first to the last moment at which the commanded forward speed is at least
/// kTrueEdgeMmS.
struct TrueStroke {
  double start_s = 0;
  double end_s = 0;
  double length_mm = 0;  ///< commanded way between the two
};

/// The default of StrokeSettings::edge_speed_mm_s; a third of the slowest mean of Table 1.
inline constexpr double kTrueEdgeMmS = 10;

struct SimulatedStream {
  std::vector<PositionSample> samples;
  std::vector<TrueStroke> strokes;
};

/// What the stream is made of.
struct StreamRecipe {
  double noise_mm = 0.02;        ///< standard deviation of white noise of each sample
  double count_mm = 0.055;       ///< positions are rounded to multiples of this; 0 = not
  double tremor_least_mm = 0.1;  ///< amplitude of the tremor, 8 to 12 Hz, drawn per stream
  double tremor_most_mm = 0.3;
  double wobble = 0.2;       ///< slow changes of the tremor's amplitude, as a share of it
  double slowest_mm_s = 28;  ///< mean speed of a stroke, drawn on a logarithmic scale
  double fastest_mm_s = 280;
  bool uneven = false;  ///< samples at random times, 0.3 to 1.7 ms apart
};

/// Three to five strokes of 40 to 80 mm with returns between them. Strokes have ramps of several shapes (minimum jerk,
/// raised cosine, straight, or no plateau at all); some have a pause of up to 0.12 s or a reversal of up to 1.5 mm
/// inside, and some returns follow at once. The same seed gives the same stream.
SimulatedStream simulatedStream(std::uint64_t seed, const StreamRecipe& recipe = {});

}  // namespace tactus::experiments
