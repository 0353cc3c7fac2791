// The button of the device as an answer: a tap, or a press that is held. While the same button holds the tube it
// answers nothing.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

enum class ButtonPress {
  kTap,   ///< let go within kTapS
  kHeld,  ///< down for kHeldS; once
};

/// Plain state. Thread: gui.
class DeviceButton {
 public:
  static constexpr double kTapS = 0.4;     ///< longer presses move something
  static constexpr double kHeldS = 0.8;    ///< confirms (facts on the screens, part 3)
  static constexpr double kSettleS = 0.3;  ///< open for so long before a press counts, as on the screen

  /// Another question: a button that is down belongs to the one before.
  void reset() { *this = {}; }
  /// The next sample. Returns a press that ended or was held long enough with it.
  std::optional<ButtonPress> add(const haptics::Sample& sample);

 private:
  std::optional<std::int64_t> open_since_ns_;
  std::optional<std::int64_t> down_since_ns_;
  bool told_ = false;  ///< of this press
};

}  // namespace tactus::workbench
