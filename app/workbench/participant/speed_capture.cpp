#include "app/workbench/participant/speed_capture.h"

namespace tactus::workbench {

void SpeedCapture::open(const experiments::StrokeSettings& settings) {
  capture_.emplace(settings);
  last_tick_.reset();
}

std::optional<session::CapturedStroke> SpeedCapture::add(std::span<const haptics::Sample> samples) {
  if (!capture_) return std::nullopt;
  for (const haptics::Sample& sample : samples) {
    if (!last_tick_) first_ns_ = sample.time_ns;
    if (last_tick_ && sample.tick != *last_tick_ + 1) capture_->gap();
    last_tick_ = sample.tick;
    capture_->add({static_cast<double>(sample.time_ns - first_ns_) * 1e-9, sample.position_mm});
    if (auto stroke = capture_->take()) {
      close();
      return stroke;
    }
  }
  return std::nullopt;
}

SpeedState::Note noteOf(experiments::StrokeVerdict verdict) {
  using experiments::StrokeVerdict;
  using Note = SpeedState::Note;
  switch (verdict) {
    case StrokeVerdict::kAccepted:
      return Note::kRecorded;
    case StrokeVerdict::kTooShort:
      return Note::kTooShort;
    case StrokeVerdict::kBackwards:
      return Note::kBackwards;
    case StrokeVerdict::kOutOfRange:
      return Note::kOutOfRange;
    case StrokeVerdict::kTooBrief:
    case StrokeVerdict::kInterrupted:
    case StrokeVerdict::kRejected:
      break;
  }
  return Note::kNotRecorded;
}

}  // namespace tactus::workbench
