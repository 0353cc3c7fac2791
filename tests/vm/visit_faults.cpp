// What goes wrong: too much at once, silence, an open switch, a pulled plug, a dead program.
#include <algorithm>
#include <array>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/haptics/servo/servo_clock.h"

#include "tests/vm/visit.h"

namespace tactus::vm {
namespace {

using haptics::Sample;
using haptics::TripCause;

constexpr double kPullN = 0.5;
constexpr double kRiseS = 0.5;  // button, fade-in and ramp

}  // namespace

// The newest force and the newest position win.
void Visit::overload() {
  auto device = openDevice(listed_, calibration_);
  if (!started(device)) return;
  const auto towards_x = [&](double share) { return haptics::Vector3{share * calibration_.full_scale_n, 0, 0}; };
  hand_.tell("hears 0");
  std::int64_t due_ns = haptics::monotonicNs();
  for (int tick = 0; tick < 300; ++tick) {
    haptics::sleepUntil(due_ns += 1'000'000);
    (*device)->write(towards_x(-0.5 + 0.001 * tick), due_ns);
  }
  const std::int64_t resumed_ns = haptics::monotonicNs();
  hand_.tell("forget");
  hand_.tell("hears 1");
  for (int tick = 0; tick < 50; ++tick) {
    haptics::sleepUntil(due_ns += 1'000'000);
    (*device)->write(towards_x(0.3), due_ns);
  }
  const FeltForce felt = last(hand_.felt());
  checks_.near(felt.x, 0.3, 0.001, "the newest force after a time without reading");
  // The effect ran out meanwhile; it begins again with the next start, every 40 ms.
  checks_.atMost(msBetween(resumed_ns, felt.time_ns), 42, "time until the newest force, ms");
  checks_.number("newest force after 300 ms unread", msBetween(resumed_ns, felt.time_ns), "ms");

  hand_.tell("at 0 0");
  hand_.tell("flood 2000");
  passTime(5);
  const auto state = (*device)->read(haptics::monotonicNs());
  checks_.near(state.position_mm.x / calibration_.mm_per_count, 2000, 0.01, "counts after 2000 reports at once");
}

void Visit::silentAtStart() {
  hand_.tell("hears 0");
  hand_.tell("speaks 0");
  auto device = openDevice(listed_, calibration_);
  const std::int64_t begin_ns = haptics::monotonicNs();
  if (checks_.expect(device.has_value(), "a silent device does not open")) {
    checks_.expect(!(*device)->start().has_value(), "a device that answers nothing starts");
    // The kernel gives a question 5 s, and there is no second one.
    checks_.atMost(msBetween(begin_ns, haptics::monotonicNs()) * 1e-3, 6, "seconds until a silent device is given up");
  }
  hand_.tell("hears 1");
  hand_.tell("speaks 1");
  passTime(20);
}

void Visit::pullAndStall() {
  auto run = pulling();
  if (!run) return;
  const auto before = run->statistics();
  checks_.atMost(static_cast<double>(before.missed), 0, "missed ticks");
  checks_.number("servo lateness p99", static_cast<double>(before.lateness.quantileNs(0.99)) * 1e-3, "us");
  checks_.number("tick p99", static_cast<double>(before.tick_duration.quantileNs(0.99)) * 1e-3, "us");
  checks_.number("age of a sample p99", static_cast<double>(before.read_age.quantileNs(0.99)) * 1e-3, "us");

  const std::int64_t stalled_ns = haptics::monotonicNs();
  hand_.tell("hears 0");
  hand_.tell("speaks 0");
  const std::vector<Sample> samples = run->pass(0.4);
  checks_.near(static_cast<double>(samples.size()), 400, 2, "ticks in 400 ms without a device");
  checks_.atMost(static_cast<double>(run->statistics().missed), 0, "ticks missed in a stall");
  const auto zero = std::ranges::find_if(
      samples, [&](const Sample& sample) { return sample.time_ns > stalled_ns && sample.force_n == 0; });
  if (checks_.expect(zero != samples.end(), "the servo asks for a force from a device that stalls"))
    checks_.atMost(msBetween(stalled_ns, zero->time_ns), 25, "ms until the servo asks for no force");
  expectTrip(samples, TripCause::kDeviceSilent, stalled_ns, 105);

  hand_.tell("forget");
  const std::int64_t resumed_ns = haptics::monotonicNs();
  hand_.tell("hears 1");
  hand_.tell("speaks 1");
  run->pass(0.3);
  const FeltForce felt = last(hand_.felt());
  checks_.expect(none(felt), "the device feels a force after a stall");
  checks_.atMost(msBetween(resumed_ns, std::max(felt.time_ns, resumed_ns)), 15, "ms until no force after a stall");
  release();
}

// A second program of ours is refused by name, as long as the first one lives.
void Visit::twoPrograms() {
  const pid_t program = fork();
  if (program == 0) {
    const auto device = openDevice(listed_, calibration_);
    if (!device || !(*device)->start()) _exit(1);
    for (;;) pause();
  }
  passTime(300);
  const std::string who = "vm_host (process " + std::to_string(program) + ")";
  const auto refused = openDevice(listed_, calibration_);
  if (checks_.expect(!refused.has_value(), "a second program opens the device"))
    checks_.expect(refused.error().found == "a device in use by " + who, refused.error().message());
  const auto devices = haptics::listHidDevices();
  if (checks_.expect(devices.size() == 1, "a device in use is not listed"))
    checks_.expect(devices.front().used_by == who, "in use by: " + devices.front().used_by);
  checks_.near(hand_.number("effects"), truth_.force_axes, 0, "effects of the first program alone");
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  auto device = openDevice(listed_, calibration_);
  started(device);
}

// A program that looks at no lock resets the device while the servo pulls: our effects are gone.
void Visit::somebodyElseResets() {
  auto run = pulling();
  if (!run) return;
  expectNoComplaints();
  const int node = open(listed_.path.c_str(), O_RDWR | O_CLOEXEC);
  const bool board = std::string(truth_.model) == "board";
  const std::array<std::uint8_t, 2> reset = {12, static_cast<std::uint8_t>(board ? 8 : 4)};
  const std::array<std::uint8_t, 2> enable = {12, 1};
  const std::int64_t reset_ns = haptics::monotonicNs();
  const bool written = write(node, reset.data(), reset.size()) == 2 && write(node, enable.data(), enable.size()) == 2;
  close(node);
  checks_.expect(written, "the other program cannot write");
  // A start may have been on its way for 20 ms; the device tells at its next report, the reader looks every 5 ms.
  expectTrip(run->pass(0.1), TripCause::kDeviceFault, reset_ns, 30);
  checks_.expect(none(hand_.force()), "a force comes back after the reset of another program");
  run.reset();
  hand_.tell("forgive");
  release();
}

void Visit::unplug() {
  auto run = pulling();
  if (!run) return;
  expectNoComplaints();
  const std::int64_t unplugged_ns = haptics::monotonicNs();
  hand_.tell("unplug");
  const std::vector<Sample> samples = run->pass(0.2);
  checks_.near(static_cast<double>(samples.size()), 200, 5, "ticks in 200 ms without a device");
  expectTrip(samples, TripCause::kDeviceLost, unplugged_ns, 5);
  run.reset();
  checks_.expect(haptics::listHidDevices().empty(), "an unplugged device is listed");
  hand_.tell("buttons 0");

  hand_.tell("plug");
  if (!find()) return;
  const auto again = pulling();
  if (again) release();
}

// kill -9 of the program while it pulls.
void Visit::die() {
  hand_.tell("buttons 0");
  const pid_t program = fork();
  if (program == 0) {
    auto run = ServoRun::begin(listed_, calibration_);
    if (!run) _exit(1);
    (*run)->pull(kPullN);
    for (;;) (*run)->pass(1);
  }
  passTime(150);
  hand_.tell("buttons 1");
  passTime(500);
  expectPull();
  hand_.tell("forget");
  kill(program, SIGKILL);
  const std::int64_t killed_ns = haptics::monotonicNs();
  waitpid(program, nullptr, 0);
  passTime(300);
  const FeltForce felt = last(hand_.felt());
  checks_.expect(none(felt) && felt.time_ns >= killed_ns, "the device feels a force of a dead program");
  checks_.atMost(msBetween(killed_ns, felt.time_ns), 100, "ms until no force after kill -9");
  checks_.number("no force after kill -9", msBetween(killed_ns, felt.time_ns), "ms");
  hand_.tell("buttons 0");
}

// A servo that pulls with kPullN; null where it does not.
std::unique_ptr<ServoRun> Visit::pulling() {
  put(0.25);
  passTime(5);
  auto run = ServoRun::begin(listed_, calibration_);
  if (!checks_.expect(run.has_value(), run ? "" : run.error().message())) return nullptr;
  (*run)->pull(kPullN);
  (*run)->pass(0.1);
  hand_.tell("buttons 1");
  const std::vector<Sample> samples = (*run)->pass(kRiseS);
  expectPull();
  checks_.near(samples.back().position_mm, 0.25 * truth_.travelMm(), 1.5 * truth_.mm_per_count, "mm in a sample");
  checks_.expect(samples.back().trip == TripCause::kNone,
                 "the servo tripped: " + std::string(haptics::describe(samples.back().trip)));
  return *std::move(run);
}

void Visit::release() {
  hand_.tell("buttons 0");
  passTime(50);
  checks_.expect(none(hand_.force()), "there is a force after the button is up");
}

void Visit::expectTrip(const std::vector<Sample>& samples, TripCause cause, std::int64_t since_ns, double within_ms) {
  const auto trip = std::ranges::find_if(samples, [](const Sample& sample) { return sample.trip != TripCause::kNone; });
  const std::string name(haptics::describe(cause));
  if (!checks_.expect(trip != samples.end(), "no trip: " + name)) return;
  checks_.expect(trip->trip == cause, "wrong trip: " + std::string(haptics::describe(trip->trip)));
  checks_.expect(trip->force_n == 0, "a force at the trip");
  checks_.atMost(msBetween(since_ns, trip->time_ns), within_ms, "ms until the trip: " + name);
  checks_.number("trip, " + name + ", after", msBetween(since_ns, trip->time_ns), "ms");
}

void Visit::openSwitch() {
  auto run = pulling();
  if (!run) return;
  const std::int64_t opened_ns = haptics::monotonicNs();
  hand_.tell("switch 1");
  expectTrip(run->pass(0.05), TripCause::kDeviceFault, opened_ns, 5);
  hand_.tell("switch 0");
  run->pass(0.05);
  checks_.expect(none(hand_.force()), "a force comes back with the switch");
  release();
}

void Visit::expectPull() {
  checks_.near(truth_.newtons(hand_.force()), -kPullN, 0.01 * kPullN, "N along the insertion axis");
}

}  // namespace tactus::vm
