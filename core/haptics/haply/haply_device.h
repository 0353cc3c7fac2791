// A Haply Inverse3 behind the Haply Inverse Service of this computer, as a haptic device; and its double, a simulated
// hand behind the same port.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/device/device_threads.h"
#include "core/haptics/simulated/hand_plan.h"

namespace tactus::haptics {

class WebSocketClient;
struct HaplyMessage;

inline constexpr std::uint16_t kHaplyPort = 10001;

/// The largest force that Tactus asks an Inverse3 for, N. The service does not tell it, and it was not measured: other
/// programs that use the device limit themselves to 10 N. Only limits below it are reached (safety/limit_settings.h).
inline constexpr double kHaplyMaxForceN = 10;

/// The point, in the frame of the service, where the axis position is 0. In its preset `defaults` the origin is at the
/// base and the handle in front of it; this is the point that its documents use as an example.
inline constexpr Vector3 kHaplyMiddleM{0, -0.12, 0.15};

// The devices of the service.

struct HaplyFound {
  /// `id` is `haply:ID` or, for the double, `simulated-haply:ID`: records of a person must show that no force was felt.
  DeviceInfo info;
  double round_trip_s = 0;  ///< from a command to the state that replies to it: 99 % of the replies are faster
  bool calibrated = true;
  Vector3 middle_mm;    ///< the point of the workspace where the axis position is 0
  std::string problem;  ///< the reason why the device cannot be used; empty if it can
  std::string advice;   ///< the remedy
};

/// Asks the service for its devices and measures how fast it replies. No force, and no device moves. Refused: no
/// service answers at the port of the loopback, or it answers something else.
base::Result<std::vector<HaplyFound>> lookAtHaply(std::uint16_t port);

/// Counts of the traffic since `start`.
struct HaplyCounters {
  std::uint64_t states = 0;      ///< usable states of the device
  std::uint64_t refused = 0;     ///< messages that could not be read, that lack the state, or that are an error
  std::uint64_t reconnects = 0;  ///< connections after the first one
};

/// The servo thread touches atomics only. A thread of the device keeps the newest state and sends the newest force: the
/// service sends one state for each message, so a force goes out after each state as soon as the servo has decided it,
/// or after 2 ms.
/// If the service dies, the state is kLost, and every half second the device tries to connect again. The states then
/// go on; the force comes back when the user arms again.
class HaplyDevice final : public HapticDevice {
 public:
  /// `id`: of HaplyFound::info; empty: the first device of the service. Refused: as in `lookAtHaply`, no such device,
  /// or a device with a problem.
  static base::Result<std::unique_ptr<HaplyDevice>> open(std::uint16_t port, const std::string& id);
  ~HaplyDevice() override;

  const DeviceInfo& info() const noexcept override { return found_.info; }
  const HaplyFound& found() const noexcept { return found_; }

  base::Result<void> start() override;
  /// Sends zero force and waits at most 0.1 s for its reply.
  void stop() noexcept override;

  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// Thread: any.
  HaplyCounters counters() const noexcept;

 private:
  struct Command {
    Vector3 force_n;
    std::int64_t time_ns = 0;
    bool valid = false;  ///< false: no command yet
  };
  HaplyDevice(std::uint16_t port, HaplyFound found) : port_(port), found_(std::move(found)) {}

  void run(std::unique_ptr<WebSocketClient> socket);
  void exchange(WebSocketClient& socket);
  void onMessage(std::string_view text);
  void takeReport(const HaplyMessage& message);
  void refuse(DeviceFault fault);
  std::string nextCommand();
  Vector3 forceNow(std::int64_t now_ns);
  void pause(std::int64_t duration_ns) const;

  const std::uint16_t port_;
  const HaplyFound found_;
  NewestValue<DeviceState> states_;  ///< from the thread of the device to the servo
  NewestValue<Command> commands_;    ///< from the servo to the thread of the device
  std::atomic<bool> ends_{false};
  std::atomic<std::uint64_t> state_count_{0};
  std::atomic<std::uint64_t> refused_{0};
  std::atomic<std::uint64_t> reconnects_{0};
  std::thread thread_;
  // Touched by the thread of the device; by the owner before it starts.
  DeviceState state_;
  bool is_listed_ = false;     ///< the last message had the device
  bool is_force_out_ = false;  ///< a force was sent and not yet replied to
};

// The double: the same wire, simulated hands.

/// Times count from the first message of a client.
struct HaplyEmulatorSettings {
  std::uint16_t port = kHaplyPort;       ///< of the loopback; 0: a free one
  int devices = 1;                       ///< [1, 8]: SIM-1, SIM-2, …
  bool grip = true;                      ///< each hand holds a grip with a button
  double rate_hz = 3000;                 ///< > 0: at most so many replies per second and client
  double late_s = 0;                     ///< [0, 10]: a late reply waits so long
  double late_share = 1;                 ///< [0, 1]: share of the replies that are late
  std::optional<double> dead_after_s;    ///< then all connections are cut and nothing listens
  std::optional<double> silent_after_s;  ///< then connections stay, and nothing is replied
  HandPlan plan;                         ///< of each hand along its axis, away from the user; empty: it rests
  bool trace = false;                    ///< keep a line for each force
};

/// What clients commanded.
struct HaplyCommanded {
  std::string id;
  std::uint64_t forces = 0;  ///< commands
  double largest_n = 0;
  double farthest_mm = 0;  ///< of the hand along its axis
  Vector3 last_n;
};
struct HaplyEmulation {
  double seconds = 0;  ///< from the first message to the last one
  std::uint64_t clients = 0;
  std::uint64_t messages = 0;
  std::uint64_t refused = 0;  ///< messages that could not be read, or forces for a device of another client
  std::vector<HaplyCommanded> devices;
};

/// Each device is a mass on one axis, level and away from the user, in a hand (VirtualDevice); forces across the axis
/// have no effect. Time stands still while no client sends; with the first client, and with the first after a time
/// without any, the hands begin anew. The first client that sends a force for a device has it until it leaves; forces
/// of others for it are refused with a sentence. Thread: any.
class HaplyEmulator {
 public:
  /// Refused: settings out of range, a port that is in use.
  static base::Result<std::unique_ptr<HaplyEmulator>> start(HaplyEmulatorSettings settings);
  ~HaplyEmulator();
  HaplyEmulator(const HaplyEmulator&) = delete;
  HaplyEmulator& operator=(const HaplyEmulator&) = delete;

  std::uint16_t port() const noexcept;
  /// Whether `dead_after_s` is over.
  bool isDead() const noexcept;
  HaplyEmulation summary() const;
  /// CSV: time_s, device, position_mm, speed_mm_s, force_x_n, force_y_n, force_z_n (frame of device.h), simulated. The
  /// first 600,000 forces.
  std::string trace() const;

 private:
  class Service;
  explicit HaplyEmulator(std::unique_ptr<Service> service);

  std::unique_ptr<Service> service_;
};

}  // namespace tactus::haptics
