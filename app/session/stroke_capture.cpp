#include "app/session/stroke_capture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace tactus::session {

using experiments::PositionSample;

void StrokeCapture::add(const PositionSample& sample) {
  if (!std::isfinite(sample.time_s) || !std::isfinite(sample.position_mm)) return;
  if (!samples_.empty() && sample.time_s <= samples_.back().time_s) return;
  if (!samples_.empty() && sample.time_s - samples_.back().time_s > longest_gap_s_) gap();
  samples_.push_back(sample);
  finder_.add(sample);
}

void StrokeCapture::gap() {
  const std::size_t next = first_ + samples_.size();
  if (samples_.empty() || (!gaps_.empty() && gaps_.back() == next)) return;
  gaps_.push_back(next);
  finder_.finish();
}

std::optional<CapturedStroke> StrokeCapture::take() {
  const auto stroke = finder_.take();
  if (!stroke) return std::nullopt;
  const auto at = [this](std::size_t place) { return samples_.begin() + static_cast<std::ptrdiff_t>(place - first_); };
  const auto earlier = [](const PositionSample& sample, double time_s) { return sample.time_s < time_s; };
  // Within the gaps around the stroke.
  const auto gap_behind = std::upper_bound(gaps_.begin(), gaps_.end(), stroke->first);
  const auto from = gap_behind == gaps_.begin() ? samples_.begin() : at(std::max(*std::prev(gap_behind), first_));
  const auto until = gap_behind == gaps_.end() ? samples_.end() : at(*gap_behind);
  const auto begin = std::lower_bound(from, at(stroke->first), stroke->start_s - kAroundS, earlier);
  const auto end = std::lower_bound(at(stroke->last), until, stroke->end_s + kAroundS, earlier);

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
  while (!gaps_.empty() && gaps_.front() <= first_) gaps_.pop_front();
  return out;
}

}  // namespace tactus::session
