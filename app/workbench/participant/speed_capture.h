// The insertions of the speed part, cut out of the samples of the device.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "app/session/stroke_capture.h"
#include "app/workbench/participant/participant_state.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// Looks only while it is open: from the moment at which the screen takes input to the first stroke. What the hand did
/// before is never an insertion.
class SpeedCapture {
 public:
  /// Another insertion is asked for.
  void open(const experiments::StrokeSettings& settings);
  void close() { capture_.reset(); }
  bool isOpen() const { return capture_.has_value(); }

  /// All samples, oldest first. Returns the stroke that ends in them, and closes; ignores them while closed.
  std::optional<session::CapturedStroke> add(std::span<const haptics::Sample> samples);

 private:
  std::optional<session::StrokeCapture> capture_;
  std::optional<std::uint64_t> last_tick_;
  std::int64_t first_ns_ = 0;
};

/// What to say about a stroke with this verdict. Nothing of a speed: a stroke that was too brief was `not recorded`.
SpeedState::Note noteOf(experiments::StrokeVerdict verdict);

}  // namespace tactus::workbench
