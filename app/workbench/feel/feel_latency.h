// The time from an edit to its force.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// In ticks of the servo.
struct EditLatency {
  std::uint64_t last_ticks = 0;     ///< from the edit to the first tick that used it, including the making of the scene
  std::uint64_t longest_ticks = 0;  ///< of all edits of this run
};

/// Finds the first samples that used the orders of each edit.
class FeelLatency {
 public:
  /// An edit was posted with the orders `number`. Its processing began after `ticks_before` ticks.
  void posted(std::uint64_t number, std::uint64_t ticks_before) { pending_.push_back({number, ticks_before}); }
  void take(const haptics::Sample& sample);
  /// Nothing before the first edit.
  const std::optional<EditLatency>& value() const { return value_; }

 private:
  struct Pending {
    std::uint64_t number = 0;
    std::uint64_t ticks_before = 0;
  };
  std::deque<Pending> pending_;  ///< posted and not yet seen in a sample
  std::optional<EditLatency> value_;
};

}  // namespace tactus::workbench
