// Three made-up force-feedback devices (HID PID): their report descriptors, and the device's side of the protocol.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tactus::support {

/// Each is laid out like a kind of firmware that exists; the descriptors are our own.
enum class PidModel : std::uint8_t {
  kBoard,   ///< two axes, control as a bit mask, 16-bit directions, ids 1, 5, 10-13 and features 0x11-0x13
  kSketch,  ///< two axes, control as an array, 8-bit directions, no start delay, ids shared between OUT and FEATURE
  kWheel,   ///< one axis, unsigned magnitude and a direction, all ids shifted, no PID State, slow block load
};
inline constexpr std::array kPidModels = {PidModel::kBoard, PidModel::kSketch, PidModel::kWheel};

const char* name(PidModel model);
std::vector<std::uint8_t> reportDescriptor(PidModel model);

/// What a firmware does with the reports it gets. It finds the values by byte offsets written down per model, not by
/// reading its own descriptor. Needs nothing but the standard library, so that it also runs behind /dev/uhid.
///
/// Every report, in and out, has its id in byte 0. Time is passed in (any monotonic clock, ns). Not thread-safe.
///
///   uhid program:  UHID_OUTPUT -> output(); UHID_SET_REPORT (feature) -> setFeature(), answer 0 or EIO;
///                  UHID_GET_REPORT (feature) -> getFeature(), empty: answer EIO; every ms -> inputReport().
class FakePidDevice {
 public:
  /// A force at the handle from a point in time on.
  struct ForceChange {
    std::int64_t time_ns = 0;
    std::array<double, 2> share{};  ///< x and y, -1..1 of the device's full scale, in the device's own sign
  };

  explicit FakePidDevice(PidModel model);

  PidModel model() const { return model_; }
  /// Number of axes with forces: 1 (x) or 2 (x, y).
  int forceAxes() const;

  /// An OUT report arrived. What a firmware would not understand goes to `complaints`.
  void output(std::span<const std::uint8_t> report, std::int64_t now_ns);
  /// SET_REPORT (feature); false: refused.
  bool setFeature(std::span<const std::uint8_t> report, std::int64_t now_ns);
  /// GET_REPORT (feature), the id included; empty: refused.
  std::vector<std::uint8_t> getFeature(std::uint8_t id);

  /// The input report for a handle at `counts` (x, y). kWheel reports x + 32768 without a sign.
  std::vector<std::uint8_t> inputReport(std::array<int, 2> counts, std::uint32_t buttons) const;
  /// The PID State report; empty: the model has none.
  std::vector<std::uint8_t> stateReport() const;
  /// Forgets the complaints so far.
  void forgive() { complaints_.clear(); }
  /// The emergency switch of the device: held down means no forces.
  void pressSafetySwitch(bool down, std::int64_t now_ns);

  /// The force at the handle now, share of full scale. Effects whose duration is over give none.
  std::array<double, 2> force(std::int64_t now_ns) const;
  /// Writes effects that ended meanwhile into the log. Called by every report too.
  void advance(std::int64_t now_ns);
  /// Every change of the force so far, the ends of effects at the moment they ended.
  const std::vector<ForceChange>& forces() const { return forces_; }

  bool actuatorsOn() const { return actuators_on_; }
  int effectsInUse() const;
  int effectsPlaying(std::int64_t now_ns) const;
  /// What was wrong with the reports, one sentence each.
  const std::vector<std::string>& complaints() const { return complaints_; }

 private:
  struct Effect {
    bool used = false;
    bool playing = false;
    std::int64_t started_ns = 0;
    int duration_ms = 0;
    double gain = 1;
    double magnitude = 0;  ///< -1..1
    std::array<double, 2> direction{};
  };

  void setEffect(std::span<const std::uint8_t> report);
  void setConstantForce(std::span<const std::uint8_t> report);
  void operate(std::span<const std::uint8_t> report, std::int64_t now_ns);
  void control(std::span<const std::uint8_t> report);
  Effect* effectOf(std::uint8_t block);
  bool hasLength(std::span<const std::uint8_t> report, std::size_t length);
  void complain(const std::string& sentence) { complaints_.push_back(sentence); }
  static bool runs(const Effect& effect, std::int64_t now_ns);
  void log(std::int64_t now_ns);

  PidModel model_;
  std::vector<Effect> effects_;
  bool actuators_on_ = false;
  bool safety_switch_ = false;
  double device_gain_ = 0;
  int created_ = -1;  ///< result of the last Create New Effect: block, 0: full, -1: there was none
  int load_polls_ = 0;
  std::size_t operated_ = 0;  ///< block of the effect that the sketch's state report is about; 0: none
  std::vector<ForceChange> forces_;
  std::vector<std::string> complaints_;
};

}  // namespace tactus::support
