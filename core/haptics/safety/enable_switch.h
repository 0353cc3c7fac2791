// Whether the hand holds the device: a held button, pedal or key, or a latch.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/safety/limit_settings.h"

namespace tactus::haptics {

/// The input of one tick. `down` is empty if the contact is unknown (no sample). An unknown contact switches nothing
/// and restarts the debounce.
struct SwitchInput {
  std::int64_t now_ns = 0;
  bool armed = false;
  std::optional<bool> down;  ///< the contact
  double position_mm = 0;    ///< along the insertion axis
};

/// A press counts after the debounce time and inside the start zone. A release counts at once.
/// The contact must have been up once since the start, since arming, and since a change of the switch kind. So a stuck
/// button, or a hand that already holds the button, enables nothing. A press outside the start zone has no effect; the
/// user must press again.
/// Plain state. Thread: servo. Real-time safe: yes.
class EnableSwitch {
 public:
  void update(const SwitchInput& input, const EnableSettings& settings) noexcept;

  bool on() const noexcept { return on_; }
  /// Ends the current press: the user must release and press again. Call before `update` of the same tick.
  void spend() noexcept { rest(); }
  /// Whether the contact was up at least once since the last call with `armed` true: the hand has let go.
  bool letGo() const noexcept { return let_go_; }

 private:
  void rest() noexcept;
  void held(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept;
  void latched(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept;

  EnableKind kind_ = EnableKind::kButton;
  std::uint32_t button_mask_ = 1;
  bool armed_ = false;
  bool on_ = false;
  bool ready_ = false;           ///< the contact was up since arming, so a press may begin
  bool let_go_ = false;          ///< the contact was up since disarming
  bool down_ = false;            ///< the contact at the last tick
  bool spent_ = false;           ///< this press has had its effect or was rejected
  std::int64_t changed_ns_ = 0;  ///< time of the contact's last change
};

}  // namespace tactus::haptics
