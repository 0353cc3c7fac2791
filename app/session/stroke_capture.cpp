#include "app/session/stroke_capture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactus::session {

using experiments::PositionSample;

void StrokeCapture::add(const PositionSample& sample) {
  if (!std::isfinite(sample.time_s) || !std::isfinite(sample.position_mm)) return;
  if (!samples_.empty() && sample.time_s <= samples_.back().time_s) return;
  samples_.push_back(sample);
  finder_.add(sample);
}

std::optional<CapturedStroke> StrokeCapture::take() {
  const auto stroke = finder_.take();
  if (!stroke) return std::nullopt;
  const auto at = [this](std::size_t place) { return samples_.begin() + static_cast<std::ptrdiff_t>(place - first_); };
  const auto earlier = [](const PositionSample& sample, double time_s) { return sample.time_s < time_s; };
  const auto begin = std::lower_bound(samples_.begin(), at(stroke->first), stroke->start_s - kAroundS, earlier);
  const auto end = std::lower_bound(at(stroke->last), samples_.end(), stroke->end_s + kAroundS, earlier);

  CapturedStroke out;
  out.stroke = *stroke;
  out.recording_first = first_ + static_cast<std::size_t>(begin - samples_.begin());
  study::Channel time{"time", "s", {}};
  study::Channel depth{"depth", "mm", {}};
  for (auto sample = begin; sample != end; ++sample) {
    time.values.push_back(sample->time_s - begin->time_s);
    depth.values.push_back(sample->position_mm);
  }
  const double length_s = time.values.empty() ? 0 : time.values.back();
  if (length_s > 0) out.recording.sample_rate_hz = static_cast<double>(time.values.size() - 1) / length_s;
  out.recording.channels = {std::move(time), std::move(depth)};
  samples_.erase(samples_.begin(), begin);
  first_ = out.recording_first;
  return out;
}

}  // namespace tactus::session
