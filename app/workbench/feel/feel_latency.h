// How long an edit takes until it is in the force.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// In ticks of the servo.
struct EditLatency {
  std::uint64_t last_ticks = 0;     ///< from the edit to the first tick that used it, making the scene included
  std::uint64_t longest_ticks = 0;  ///< of all edits since the start
};

/// Waits in the samples for the orders that brought the edits.
class FeelLatency {
 public:
  /// An edit went out with the orders `number`; its work began when `ticks_before` ticks had begun.
  void posted(std::uint64_t number, std::uint64_t ticks_before) { pending_.push_back({number, ticks_before}); }
  void take(const haptics::Sample& sample);
  /// Nothing before the first edit.
  const std::optional<EditLatency>& value() const { return value_; }

 private:
  struct Pending {
    std::uint64_t number = 0;
    std::uint64_t ticks_before = 0;
  };
  std::deque<Pending> pending_;  ///< posted, and not yet seen in a sample
  std::optional<EditLatency> value_;
};

}  // namespace tactus::workbench
