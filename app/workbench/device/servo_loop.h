// The loop that calls the servo: a thread of its own. Tests step it through virtual time instead.
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/base/error.h"
#include "core/haptics/servo/servo.h"

namespace tactus::workbench {

class ServoLoop {
 public:
  virtual ~ServoLoop() = default;
  /// Starts the loop. Returns when the servo is ticking. Thread: gui.
  virtual base::Result<void> start() = 0;
  /// Stops the loop. Returns after the last tick, when the device has the order for zero force. Thread: gui.
  virtual void stop() noexcept = 0;
  /// The clock of the ticks, ns.
  virtual std::int64_t nowNs() const noexcept = 0;
  /// The scheduling priority of the loop, for the screen: `real-time thread`.
  virtual QString priorityText() const = 0;
};

/// Creates the loop of a servo. The servo outlives the loop.
using MakeServoLoop = std::function<std::unique_ptr<ServoLoop>(haptics::Servo&)>;

/// A haptics::ServoThread on the monotonic clock.
std::unique_ptr<ServoLoop> threadedLoop(haptics::Servo& servo);

}  // namespace tactus::workbench
