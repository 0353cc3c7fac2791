// Whether the hand holds the device: a button, pedal or key that is held, or a latch.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/safety/limit_settings.h"

namespace tactus::haptics {

/// One tick. A contact that is not known (no sample) is `down` without a value: it switches
/// nothing, and the debounce starts again.
struct SwitchInput {
  std::int64_t now_ns = 0;
  bool armed = false;
  std::optional<bool> down;  ///< the contact
  double position_mm = 0;    ///< along the insertion axis
};

/// A press counts after the debounce time and inside the start zone, a release at once. The contact must have been up
/// once since the start, since arming, and since the kind of switch was changed: a button that sticks, or a hand that
/// already holds it, enables nothing. A press outside the start zone is spent; another press is needed.
/// Plain state. Thread: servo. Real-time safe: yes.
class EnableSwitch {
 public:
  void update(const SwitchInput& input, const EnableSettings& settings) noexcept;

  bool on() const noexcept { return on_; }
  /// Whoever holds it has to let go and press again. Before `update` of the same tick.
  void spend() noexcept { rest(); }
  /// The contact was seen up since the last call with `armed` true: the hand has let go.
  bool letGo() const noexcept { return let_go_; }

 private:
  void rest() noexcept;
  void held(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept;
  void latched(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept;

  EnableKind kind_ = EnableKind::kButton;
  std::uint32_t button_mask_ = 1;
  bool armed_ = false;
  bool on_ = false;
  bool ready_ = false;           ///< the contact was up since arming: a press may begin
  bool let_go_ = false;          ///< the contact was up since disarming
  bool down_ = false;            ///< the contact at the last tick
  bool spent_ = false;           ///< this press has had its effect, or counted for nothing
  std::int64_t changed_ns_ = 0;  ///< when the contact last went up or down
};

}  // namespace tactus::haptics
