// The functions, numbers and records of the OpenHaptics HD library (libHD) that Tactus uses: own declarations, no SDK.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tactus::haptics {

using HdHandle = std::uint32_t;
using HdCallback = std::uint32_t (*)(void* user);
using HdSchedule = unsigned long;  ///< a C long: 8 bytes on 64-bit Linux

/// The return value of hdGetError. If a record is declared too short, the library writes beyond it on the stack, on
/// platforms where the calling convention passes a hidden pointer.
struct HdErrorRecord {
  std::uint32_t code = 0;
  std::int32_t internal_code = 0;
  std::uint32_t device = 0;
};
static_assert(sizeof(HdErrorRecord) == 12 && alignof(HdErrorRecord) == 4);
static_assert(offsetof(HdErrorRecord, code) == 0 && offsetof(HdErrorRecord, internal_code) == 4 &&
              offsetof(HdErrorRecord, device) == 8);

namespace hd {

inline constexpr HdHandle kInvalidHandle = 0xFFFFFFFF;

enum Error : std::uint32_t {
  kSuccess = 0,
  kInvalidEnum = 0x0100,
  kInvalidValue = 0x0101,
  kInvalidOperation = 0x0102,
  kInvalidInputType = 0x0103,
  kBadHandle = 0x0104,
  kWarmMotors = 0x0200,
  kExceededMaxForce = 0x0201,
  kExceededMaxForceImpulse = 0x0202,
  kExceededMaxVelocity = 0x0203,
  kForceError = 0x0204,
  kDeviceFault = 0x0300,
  kDeviceAlreadyInitiated = 0x0301,
  kCommError = 0x0302,
  kCommConfigError = 0x0303,
  kTimerError = 0x0304,
  kIllegalBegin = 0x0400,
  kIllegalEnd = 0x0401,
  kFrameError = 0x0402,
  kInvalidPriority = 0x0500,
  kSchedulerFull = 0x0501,
  kInvalidLicence = 0x0600,
};

enum Name : std::uint32_t {
  kCurrentButtons = 0x2000,             ///< int, bit 0 is button 1
  kCurrentPosition = 0x2050,            ///< 3 double, mm
  kCurrentVelocity = 0x2051,            ///< 3 double, mm/s, filtered by the driver
  kVersion = 0x2500,                    ///< string
  kDeviceModelType = 0x2501,            ///< string
  kDeviceSerialNumber = 0x2504,         ///< string
  kOutputDof = 0x2554,                  ///< int
  kCalibrationStyle = 0x2555,           ///< int, a mask of CalibrationStyle
  kNominalMaxStiffness = 0x2602,        ///< double, N/mm
  kNominalMaxForce = 0x2603,            ///< double, N
  kNominalMaxContinuousForce = 0x2604,  ///< double, N
  kCurrentForce = 0x2700,               ///< 3 double, N
  kForceOutput = 0x4000,                ///< capability
  kMaxForceClamping = 0x4001,           ///< capability
  kForceRamping = 0x4002,               ///< capability
};

enum CalibrationState : std::uint32_t { kCalibrated = 0x5000, kNeedsUpdate = 0x5001, kNeedsManualInput = 0x5002 };
enum CalibrationStyle : std::uint32_t { kEncoderReset = 1, kAutomatic = 2, kInkwell = 4 };

inline constexpr std::uint32_t kCallbackDone = 0;
inline constexpr std::uint32_t kCallbackContinue = 1;
inline constexpr std::uint16_t kHighestPriority = 0xFFFF;

}  // namespace hd

/// The entry points, named as in the library without `hd`.
struct HdApi {
  HdHandle (*init_device)(const char* name) = nullptr;  ///< null: the default device
  void (*disable_device)(HdHandle) = nullptr;
  void (*make_current_device)(HdHandle) = nullptr;
  void (*begin_frame)(HdHandle) = nullptr;
  void (*end_frame)(HdHandle) = nullptr;
  HdErrorRecord (*get_error)() = nullptr;  ///< pops the newest error from a stack
  const char* (*get_error_string)(std::uint32_t code) = nullptr;
  void (*enable)(std::uint32_t capability) = nullptr;
  void (*disable)(std::uint32_t capability) = nullptr;
  unsigned char (*is_enabled)(std::uint32_t capability) = nullptr;
  const char* (*get_string)(std::uint32_t) = nullptr;
  void (*get_integerv)(std::uint32_t, int*) = nullptr;
  void (*get_doublev)(std::uint32_t, double*) = nullptr;
  void (*set_doublev)(std::uint32_t, const double*) = nullptr;
  std::uint32_t (*check_calibration)() = nullptr;
  void (*update_calibration)(std::uint32_t style) = nullptr;
  void (*start_scheduler)() = nullptr;
  void (*stop_scheduler)() = nullptr;
  void (*set_scheduler_rate)(unsigned long hz) = nullptr;
  HdSchedule (*schedule_asynchronous)(HdCallback, void* user, std::uint16_t priority) = nullptr;
  void (*unschedule)(HdSchedule) = nullptr;
};

}  // namespace tactus::haptics
