#include "app/devices/guided_runs.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "core/base/text.h"
#include "core/haptics/haply/haply_device.h"
#include "core/haptics/openhaptics/openhaptics_device.h"
#include "core/haptics/servo/loop_statistics.h"
#include "core/haptics/servo/servo.h"
#include "core/haptics/servo/servo_clock.h"

namespace tactus::devices {
namespace {

using haptics::CalibrationInput;
using haptics::CalibrationProcedure;
using haptics::CalibrationStep;

constexpr std::int64_t kSampleNs = 1'000'000;
constexpr int kDriverTicks = 500;  ///< a driver calibrates in its next frame, or not at all

/// Hands the person's answer over, if there is one.
void takeAnswer(CalibrationProcedure& procedure, CalibrationGuide& guide) {
  if (procedure.wanted() == CalibrationInput::kNothing) return;
  const auto answer = guide.answer();
  if (!answer) return;
  const std::string_view text = base::trimmed(*answer);
  if (text == "stop") return procedure.cancel();
  if (procedure.wanted() == CalibrationInput::kContinue) return procedure.proceed();
  const auto number = base::parseNumber(text);
  if (!number) return guide.refuse("found " + base::quoted(text) + ", wanted a number such as 1.5, or stop");
  if (const auto taken = procedure.enter(*number); !taken) guide.refuse(taken.error().message());
}

tl::unexpected<base::Error> interruption(const haptics::HapticDevice& device) {
  return base::fail(base::ErrorCode::kCancelled, device.info().id, "an interruption, and the device was stopped",
                    "a complete calibration");
}

/// Ticks until the procedure ends. The device has no force when this returns.
base::Result<void> lead(haptics::HapticDevice& device, CalibrationProcedure& procedure, CalibrationGuide& guide,
                        const CalibrationClock& clock) {
  std::string told;
  for (std::int64_t due_ns = clock.now_ns();; due_ns += kSampleNs) {
    clock.sleep_until(due_ns);
    const std::int64_t now_ns = clock.now_ns();
    if (guide.interrupted()) {
      device.write({}, now_ns);
      return interruption(device);
    }
    const haptics::DeviceState state = device.read(now_ns);
    const bool lost = state.fault == haptics::DeviceFault::kLost;
    device.write(lost ? haptics::Vector3{} : procedure.tick(state, now_ns), now_ns);
    if (lost)
      return base::fail(base::ErrorCode::kIo, device.info().id, "the device is gone", "a device that stays plugged in");
    if (procedure.step() == CalibrationStep::kDone || procedure.step() == CalibrationStep::kFailed) break;
    if (procedure.instruction() == told) {
      takeAnswer(procedure, guide);
      continue;
    }
    told = procedure.instruction();
    guide.instruct(told);
  }
  device.write({}, clock.now_ns());
  if (procedure.step() == CalibrationStep::kDone) return {};
  return base::fail(base::ErrorCode::kData, device.info().id, procedure.instruction(), "a calibration that ends well");
}

}  // namespace

CalibrationClock systemClock() noexcept { return {haptics::monotonicNs, haptics::sleepUntil}; }

base::Result<haptics::DeviceCalibration> runCalibration(haptics::HapticDevice& device,
                                                        const haptics::CalibrationPlan& plan,
                                                        const std::string& measured_at, CalibrationGuide& guide,
                                                        const CalibrationClock& clock) {
  if (const auto started = device.start(); !started) return tl::unexpected(started.error());
  CalibrationProcedure procedure(plan);
  const auto led = lead(device, procedure, guide, clock);
  device.stop();
  if (!led) return tl::unexpected(led.error());
  return procedure.result(measured_at);
}

namespace {

/// A device that its driver calibrates.
struct DriverCalibration {
  std::function<bool()> done;
  std::function<void()> request;  ///< tells the driver that the device is in its reference posture
  std::function<std::string()> advice;
  bool reports_late = false;  ///< its first report comes some time after the start
};

std::optional<DriverCalibration> driverOf(haptics::HapticDevice& device, const CalibrationClock& clock) {
  if (auto* const touch = dynamic_cast<haptics::OpenHapticsDevice*>(&device))
    return DriverCalibration{[touch] { return touch->calibrated(); }, [touch] { touch->requestCalibration(); },
                             [touch] { return touch->calibrationAdvice(); }};
  auto* const haply = dynamic_cast<haptics::HaplyDevice*>(&device);
  if (haply == nullptr) return std::nullopt;
  const auto done = [haply, now_ns = clock.now_ns] {
    const haptics::DeviceState state = haply->read(now_ns());
    return state.number > 0 && state.fault != haptics::DeviceFault::kNotCalibrated;
  };
  return DriverCalibration{done, [] {}, [] { return std::string("calibrate it as its maker says, in the Haply Hub"); },
                           true};
}

void waitFor(const DriverCalibration& driver, const CalibrationGuide& guide, const CalibrationClock& clock) {
  for (int waited = 0; waited < kDriverTicks && !driver.done() && !guide.interrupted(); ++waited)
    clock.sleep_until(clock.now_ns() + kSampleNs);
}

}  // namespace

base::Result<void> calibrateByDriver(haptics::HapticDevice& device, CalibrationGuide& guide,
                                     const CalibrationClock& clock) {
  const auto driver = driverOf(device, clock);
  if (!driver)
    return base::fail(base::ErrorCode::kReference, device.info().id, "a device without a calibration",
                      "a HID device, one behind OpenHaptics or one of the Haply service");
  if (auto started = device.start(); !started) return started;
  if (driver->reports_late) waitFor(*driver, guide, clock);
  if (!driver->done()) guide.instruct("To calibrate, " + driver->advice() + ": then press Enter.");
  bool stopped = false;
  while (!driver->done() && !stopped && !guide.interrupted()) {
    clock.sleep_until(clock.now_ns() + kSampleNs);
    const auto answer = guide.answer();
    if (!answer) continue;
    stopped = base::trimmed(*answer) == "stop";
    if (stopped) continue;
    driver->request();
    waitFor(*driver, guide, clock);
    if (!driver->done() && !guide.interrupted()) guide.refuse("The driver did not take it. Try again, or type stop.");
  }
  const bool calibrated = driver->done();
  device.stop();
  if (calibrated) return {};
  if (guide.interrupted()) return interruption(device);
  return base::fail(base::ErrorCode::kCancelled, device.info().id, "no calibration", driver->advice());
}

namespace {

constexpr std::int64_t kTickNs = 1'000'000;
constexpr std::chrono::milliseconds kLook{5};  ///< between two looks at the samples

/// What the guide has been told already.
class Conversation {
 public:
  explicit Conversation(SelfTestGuide& guide) : guide_(guide) {}

  void follow(const SelfTest& test) {
    for (; told_ < test.results().size(); ++told_) guide_.tell(test.results()[told_]);
    const std::string sentence = test.instruction();
    const bool question = test.phase() == SelfTest::Phase::kAsk;
    if (sentence == last_ || sentence.empty() || question) return;
    last_ = sentence;
    guide_.instruct(sentence);
  }

 private:
  SelfTestGuide& guide_;
  std::size_t told_ = 0;
  std::string last_;
};

/// Samples to the test, orders to the servo, and what the guide should hear.
void advance(SelfTest& test, haptics::Servo& servo, Conversation& conversation) {
  std::array<haptics::Sample, 256> room;
  for (auto samples = servo.drain(room); !samples.empty(); samples = servo.drain(room)) {
    for (const auto& sample : samples) {
      if (auto orders = test.takeOrders()) test.posted(servo.post(std::move(*orders)));
      test.feed(sample);
    }
  }
  if (const auto record = servo.takeFlightRecord()) test.tripped(record->trip);
  if (auto orders = test.takeOrders()) test.posted(servo.post(std::move(*orders)));
  conversation.follow(test);
}

/// What a person does at the device, played on a virtual one.
class SimulatedPerson {
 public:
  explicit SimulatedPerson(haptics::VirtualDevice& device) : device_(device) {}

  void act(SelfTest& test) {
    if (test.phase() != phase_) ticks_ = 0;
    phase_ = test.phase();
    ++ticks_;
    switch (phase_) {
      case SelfTest::Phase::kMotion: return device_.setTarget(ticks_ < 1000 ? 50 : 0);
      case SelfTest::Phase::kButton: return device_.setButton(ticks_ > 1000 && ticks_ < 1300);
      case SelfTest::Phase::kForceOff:
      case SelfTest::Phase::kPulse: return device_.setButton(ticks_ > 300 || phase_ == SelfTest::Phase::kPulse);
      case SelfTest::Phase::kAsk: device_.setButton(false); return test.answer(felt(test));
      default: return;
    }
  }

 private:
  static Felt felt(const SelfTest& test) {
    const double shift_mm = test.shiftMm();
    const double least_mm = SelfTestSettings{}.smallest_shift_mm;
    if (std::abs(shift_mm) < least_mm) return Felt::kNothing;
    return shift_mm < 0 ? Felt::kToward : Felt::kAway;
  }

  haptics::VirtualDevice& device_;
  SelfTest::Phase phase_ = SelfTest::Phase::kSamples;
  int ticks_ = 0;
};

/// Ticks, until the test has ended and its last orders are in force.
SelfTest inRealTime(haptics::Servo& servo, const SelfTestSettings& settings, SelfTestGuide& guide) {
  SelfTest test(settings);
  Conversation conversation(guide);
  test.posted(servo.post(*test.takeOrders()));
  haptics::LoopWatch watch;
  while (!test.finished() && !guide.interrupted()) {
    const std::int64_t now_ns = haptics::monotonicNs();
    servo.heartbeat(now_ns);
    advance(test, servo, conversation);
    if (const haptics::Trip silent = watch.look(servo.ticks(), now_ns)) test.tripped(silent);
    if (test.phase() == SelfTest::Phase::kAsk) {
      const Felt felt = guide.ask(test.instruction());
      if (guide.interrupted()) break;
      test.answer(felt);
    }
    std::this_thread::sleep_for(kLook);
  }
  test.cancel();
  advance(test, servo, conversation);
  return test;
}

}  // namespace

SelfTestSettings settingsFor(const haptics::DeviceInfo& info) {
  SelfTestSettings settings;
  settings.limits = haptics::LimitSettings::forDevice(info);
  settings.smallest_shift_mm = std::max(settings.smallest_shift_mm, 2 * info.count_mm.value_or(0));
  settings.calibration_advice = "calibrate it: tactus devices calibrate " + info.id;
  return settings;
}

base::Result<SelfTest> runSelfTest(haptics::HapticDevice& device, const SelfTestSettings& settings,
                                   SelfTestGuide& guide) {
  if (const auto started = device.start(); !started) return tl::unexpected(started.error());
  haptics::Servo servo(device);
  haptics::ServoThread thread(servo);
  if (const auto started = thread.start(); !started) {
    device.stop();
    return tl::unexpected(started.error());
  }
  SelfTest test = inRealTime(servo, settings, guide);
  thread.stop();
  device.stop();
  if (guide.interrupted())
    return base::fail(base::ErrorCode::kCancelled, device.info().id, "an interruption, and the device was stopped",
                      "a complete self-test");
  return test;
}

base::Result<SelfTest> simulateSelfTest(haptics::VirtualDevice& device, const SelfTestSettings& settings,
                                        SelfTestGuide& guide) {
  if (const auto started = device.start(); !started) return tl::unexpected(started.error());
  haptics::Servo servo(device);
  SelfTest test(settings);
  Conversation conversation(guide);
  SimulatedPerson person(device);
  test.posted(servo.post(*test.takeOrders()));
  for (std::int64_t now_ns = kTickNs; !test.finished(); now_ns += kTickNs) {
    servo.tick(now_ns);
    advance(test, servo, conversation);
    person.act(test);
  }
  conversation.follow(test);
  device.stop();
  return test;
}

base::Result<SelfTest> selfTest(haptics::HapticDevice& device, const SelfTestSettings& settings, SelfTestGuide& guide) {
  auto* const simulated = dynamic_cast<haptics::VirtualDevice*>(&device);
  return simulated != nullptr ? simulateSelfTest(*simulated, settings, guide) : runSelfTest(device, settings, guide);
}

}  // namespace tactus::devices
