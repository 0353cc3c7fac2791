#include "tests/vm/visit.h"

#include "core/haptics/servo/servo_clock.h"

#include "tests/vm/force_stream.h"
#include "tests/vm/guided_calibration.h"

namespace tactus::vm {
namespace {

constexpr int kStreamed = 1000;

}  // namespace

void passTime(std::int64_t ms) { haptics::sleepUntil(haptics::monotonicNs() + ms * 1'000'000); }

double msBetween(std::int64_t from_ns, std::int64_t to_ns) { return static_cast<double>(to_ns - from_ns) * 1e-6; }

FeltForce last(const std::vector<FeltForce>& felt) { return felt.empty() ? FeltForce{} : felt.back(); }

Visit::Visit(Checks& checks, const std::string& program, const TrueHandle& truth)
    : checks_(checks), truth_(truth), hand_(program, truth.model) {}

void Visit::everything() {
  if (!find() || !calibrateByHand()) return;
  startAndStop();
  streamDifferentForces();
  readPositions();
  overload();
  silentAtStart();
  pullAndStall();
  if (truth_.has_switch) openSwitch();
  twoPrograms();
  if (truth_.has_switch) somebodyElseResets();
  unplug();
  die();
  expectNoComplaints();
}

void Visit::expectNoComplaints() {
  for (const std::string& complaint : hand_.tell("complaints")) checks_.expect(false, "the device: " + complaint);
}

bool Visit::find() {
  for (int i = 0; i < 100; ++i, passTime(10)) {
    const auto devices = haptics::listHidDevices();
    if (devices.empty()) continue;
    checks_.expect(devices.size() == 1, std::to_string(devices.size()) + " devices are listed instead of one");
    listed_ = devices.front();
    checks_.expect(listed_.problem.empty(), listed_.problem);
    checks_.expect(listed_.identity.serial == "vm-1", "serial number " + listed_.identity.serial);
    return checks_.expect(listed_.kind == haptics::HidDeviceKind::kPid, "it is not taken for a PID device");
  }
  return checks_.expect(false, "it is not found");
}

bool Visit::calibrateByHand() {
  auto device = openDevice(listed_, {});
  if (!started(device)) return false;
  auto measured = calibrate(**device, hand_, truth_);
  if (!checks_.expect(measured.has_value(), measured ? "" : "calibration: " + measured.error().message())) return false;
  calibration_ = *measured;
  // A pull is read at a tenth of full scale, where a step of the wheel's and the sketch's magnitude is 0.1 %.
  checks_.near(calibration_.full_scale_n, truth_.full_scale_n, 0.005 * truth_.full_scale_n, "full scale in N");
  checks_.near(calibration_.mm_per_count, truth_.mm_per_count, 1e-3 * truth_.mm_per_count, "mm per count");
  const haptics::Vector3 inwards = inDeviceFrame(truth_.inwards());
  // The handle's place is known to a count of thousands.
  checks_.near(dot(calibration_.inwards, inwards), 1, 1e-6, "the cosine between the insertion axis and the true one");
  const double friction_n = truth_.friction_share * truth_.full_scale_n;
  // The push rises by 2 % in a second and is seen some 20 ms after the handle moves.
  checks_.near(calibration_.friction_in_n.value_or(-1), friction_n, 0.002 * truth_.full_scale_n, "friction inwards");
  checks_.near(calibration_.friction_out_n.value_or(-1), friction_n, 0.002 * truth_.full_scale_n, "friction outwards");
  hand_.tell("yields 0 0");
  return true;
}

void Visit::startAndStop() {
  auto device = openDevice(listed_, calibration_);
  if (!started(device)) return;
  passTime(20);
  checks_.near((*device)->info().force_axes, truth_.force_axes, 0, "axes of force");
  checks_.near(hand_.number("actuators"), 1, 0, "actuators after the start");
  checks_.near(hand_.number("effects"), truth_.force_axes, 0, "effects after the start");
  checks_.expect(none(hand_.force()), "there is a force before the first one is written");
  (*device)->stop();
  checks_.near(hand_.number("actuators"), 0, 0, "actuators after the stop");
  checks_.near(hand_.number("effects"), 0, 0, "effects after the stop");
}

void Visit::streamDifferentForces() {
  auto device = openDevice(listed_, calibration_);
  if (!started(device)) return;
  const ForceStream stream = streamForces(**device, hand_, kStreamed);
  checks_.atMost(stream.lost, 0.01 * stream.written, "forces lost at 1 kHz");
  checks_.atMost(stream.largest_error, 1e-4, "largest error of a force, share of full scale");  // one step of 10000
  checks_.atMost(quantile(stream.latency_us, 0.99), 1000, "99 % of the latencies in us");
  checks_.number("forces felt at 1 kHz", stream.written - stream.lost, "of " + std::to_string(kStreamed));
  checks_.number("force latency p50", quantile(stream.latency_us, 0.5), "us");
  checks_.number("force latency p99", quantile(stream.latency_us, 0.99), "us");
  checks_.number("force latency largest", quantile(stream.latency_us, 1), "us");
}

void Visit::readPositions() {
  auto device = openDevice(listed_, calibration_);
  if (!started(device)) return;
  const haptics::AxisMapping axis = haptics::axisOf(calibration_);
  for (const double share : {0.0, 0.25, 1.0, -0.1}) {
    put(share);
    passTime(3);
    const auto state = (*device)->read(haptics::monotonicNs());
    // The truth lies between two counts.
    checks_.near(axis.positionMm(state.position_mm), share * truth_.travelMm(), 1.5 * truth_.mm_per_count,
                 "position in mm");
    checks_.atMost(msBetween(state.time_ns, haptics::monotonicNs()), 2, "age of the sample in ms");
  }
  hand_.tell("buttons 5");
  passTime(3);
  checks_.near((*device)->read(haptics::monotonicNs()).buttons, 5, 0, "buttons");
  hand_.tell("buttons 0");
}

void Visit::put(double share) {
  hand_.tell("at " + std::to_string(truth_.at(share)[0]) + " " + std::to_string(truth_.at(share)[1]));
}

bool Visit::started(base::Result<std::unique_ptr<haptics::HidPidDevice>>& device) {
  if (!checks_.expect(device.has_value(), device ? "" : device.error().message())) return false;
  const auto started = (*device)->start();
  return checks_.expect(started.has_value(), started ? "" : started.error().message());
}

}  // namespace tactus::vm
