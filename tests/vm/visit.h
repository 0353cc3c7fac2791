// One virtual device plugged in, and everything the project's HID back end has to do with it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/haptics/device/calibration_file.h"
#include "core/haptics/hid/hid_pid_device.h"

#include "tests/vm/checks.h"
#include "tests/vm/device_process.h"
#include "tests/vm/servo_run.h"
#include "tests/vm/true_handle.h"

namespace tactus::vm {

class Visit {
 public:
  /// `checks` and `truth` must outlive the visit; `program` is that of the device.
  Visit(Checks& checks, const std::string& program, const TrueHandle& truth);

  void everything();

 private:
  bool find();
  bool calibrateByHand();
  void startAndStop();
  void streamDifferentForces();
  void readPositions();

  // visit_faults.cpp
  void overload();
  void silentAtStart();
  void pullAndStall();
  void openSwitch();
  void twoPrograms();
  void somebodyElseResets();
  void unplug();
  void die();

  /// A servo that pulls with kPullN; null where it does not.
  std::unique_ptr<ServoRun> pulling();
  void expectPull();
  void release();
  void expectTrip(const std::vector<haptics::Sample>& samples, haptics::TripCause cause, std::int64_t since_ns,
                  double within_ms);
  void expectNoComplaints();
  void put(double share);
  bool started(base::Result<std::unique_ptr<haptics::HidPidDevice>>& device);

  Checks& checks_;
  const TrueHandle& truth_;
  DeviceProcess hand_;
  haptics::HidDevice listed_;
  haptics::DeviceCalibration calibration_;
};

void passTime(std::int64_t ms);
double msBetween(std::int64_t from_ns, std::int64_t to_ns);
/// What was felt last, or no force.
FeltForce last(const std::vector<FeltForce>& felt);
inline bool none(const FeltForce& felt) { return felt.x == 0 && felt.y == 0; }

}  // namespace tactus::vm
