// Who calls the servo: its own thread. A test steps it through virtual time instead.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "core/haptics/servo/servo.h"

namespace tactus::workbench {

class FeelLoop {
 public:
  virtual ~FeelLoop() = default;
  /// Returns when the servo is ticking. Thread: gui.
  virtual base::Result<void> start() = 0;
  /// Returns when no tick will follow and the device has been told to give no force. Thread: gui.
  virtual void stop() noexcept = 0;
  /// The clock of the ticks, ns.
  virtual std::int64_t nowNs() const noexcept = 0;
  /// How punctual the loop may be, for the screen: `real-time thread`.
  virtual QString priorityText() const = 0;
};

/// Makes the loop of a servo, which outlives it.
using MakeFeelLoop = std::function<std::unique_ptr<FeelLoop>(haptics::Servo&)>;

/// A haptics::ServoThread on the monotonic clock.
std::unique_ptr<FeelLoop> threadedLoop(haptics::Servo& servo);

}  // namespace tactus::workbench
