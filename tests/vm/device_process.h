// The virtual device as the host program sees it: another process, told what to do line by line. tests/vm/README.md
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <sys/types.h>
#include <vector>

namespace tactus::vm {

/// A change of the force as the device felt it.
struct FeltForce {
  std::int64_t time_ns = 0;  ///< monotonic, the same clock for both processes
  double x = 0;              ///< share of the device's largest force, positive toward larger counts
  double y = 0;
};

class DeviceProcess {
 public:
  /// Starts `program` with the name of a descriptor; the device is plugged in when this returns.
  DeviceProcess(const std::string& program, const std::string& descriptor);
  ~DeviceProcess();
  DeviceProcess(const DeviceProcess&) = delete;
  DeviceProcess& operator=(const DeviceProcess&) = delete;

  /// Returns the lines of the answer when the device has done it.
  std::vector<std::string> tell(const std::string& command);
  /// The force now.
  FeltForce force();
  /// Changes of the force since the last call, or since `forget`. A long list keeps the device, and thereby the one
  /// processor of the guest, busy for a while.
  std::vector<FeltForce> felt();
  /// The number the device answers with, e.g. to `outputs`.
  double number(const std::string& command);

 private:
  pid_t child_ = -1;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
};

}  // namespace tactus::vm
