#include "app/session/simulated_recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check.h"

namespace tactus::session {
namespace {

constexpr double kQuantumMm = 0.055;  // 450 counts per inch, as a Touch
constexpr double kMissedShare = 0.001;

}  // namespace

RecordingNoise RecordingNoise::of(std::size_t ticks, base::Random& random) {
  RecordingNoise noise;
  const double hz = random.uniform(8, 12);
  const double phase = random.uniform(0, 2 * std::numbers::pi);
  for (std::size_t i = 0; i < ticks; ++i) {
    noise.tremor_mm.push_back(kTremorMm *
                              std::sin(phase + 2 * std::numbers::pi * hz * static_cast<double>(i) / kSimulatedRateHz));
  }
  noise.missed.resize(ticks);
  for (std::size_t i = 1; i + 1 < ticks; ++i) noise.missed[i] = random.uniform() < kMissedShare;
  return noise;
}

Recording record(std::span<const double> speeds_mm_s, const RecordingNoise& noise, double offset) {
  TACTUS_CHECK(noise.missed.size() == speeds_mm_s.size());
  const double fastest = *std::max_element(speeds_mm_s.begin(), speeds_mm_s.end());
  Recording out;
  double depth_mm = offset * kQuantumMm;
  double last_mm_s = 0;
  for (std::size_t i = 0; i < speeds_mm_s.size(); ++i) {
    depth_mm += (last_mm_s + speeds_mm_s[i]) / 2 / kSimulatedRateHz;
    last_mm_s = speeds_mm_s[i];
    if (noise.missed[i]) continue;
    const double tremor_mm = noise.tremor_mm[i] * speeds_mm_s[i] / fastest;
    out.time_s.push_back(static_cast<double>(i) / kSimulatedRateHz);
    out.depth_mm.push_back(std::round((depth_mm + tremor_mm) / kQuantumMm) * kQuantumMm);
  }
  return out;
}

}  // namespace tactus::session
