#include "tests/bench/feel_edits.h"

#include <algorithm>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "core/haptics/servo/servo.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/bench/cases.h"
#include "tests/bench/feel_loop.h"

namespace tactus::bench {
namespace {

constexpr int kVirtualEdits = 2000;

/// Strokes one after the other, so that edits come while the tube is released, stuck and sliding.
std::unique_ptr<haptics::VirtualDevice> device() {
  haptics::VirtualDeviceSettings settings;
  settings.plan = haptics::strokes({.count = 1000, .length_mm = 30});
  auto made = haptics::VirtualDevice::make(std::move(settings));
  TACTUS_CHECK(made.has_value());
  TACTUS_CHECK((*made)->start().has_value());
  return std::move(*made);
}

/// One vertex of an output term dragged by a little, another place for each edit.
void edit(fuzzy::ForceModel& model, int number) { model.output.terms[0].points[3] = 0.25 + 0.0001 * (number % 500); }

/// The sample of the first tick under the orders `number`, if it is among those that wait.
std::optional<haptics::Sample> firstWith(haptics::Servo& servo, std::uint64_t number, std::span<haptics::Sample> room) {
  std::optional<haptics::Sample> first;
  for (const haptics::Sample& sample : servo.drain(room)) {
    if (sample.orders == number && !first) first = sample;
  }
  return first;
}

void addTicks(FeelPart& part, const std::string& name, const std::vector<double>& ticks) {
  const auto within = [&ticks](double most) {
    return 100.0 * static_cast<double>(std::count_if(ticks.begin(), ticks.end(), [&](double t) { return t <= most; })) /
           static_cast<double>(ticks.size());
  };
  part.add(name, "edits", "1", static_cast<double>(ticks.size()));
  part.add(name, "in 1 tick", "%", within(1));
  part.add(name, "in 2 ticks", "%", within(2));
  part.add(name, "longest", "ticks", *std::max_element(ticks.begin(), ticks.end()));
}

void addTimes(FeelPart& part, const std::string& name, const std::vector<double>& times_ms) {
  part.add(name, "median", "ms", base::median(times_ms));
  part.add(name, "p99", "ms", base::quantile(times_ms, 0.99));
  part.add(name, "largest", "ms", *std::max_element(times_ms.begin(), times_ms.end()));
}

/// Ticks from the last one begun before the post to the first with the new model, both in the count.
void measureVirtual(FeelPart& part) {
  const auto simulated = device();
  haptics::Servo servo(*simulated);
  fuzzy::ForceModel model = syntheticExperts(4);
  std::vector<haptics::Sample> room(64);
  std::vector<double> waited;
  std::uint64_t engaged = 0, asked_at_once = 0;
  base::Random random(1);
  std::int64_t now_ns = 0;
  const auto tick = [&] {
    servo.tick(now_ns);
    now_ns += kFeelTickNs;
  };
  for (int number = 0; number < kVirtualEdits; ++number) {
    for (int idle = random.below(10); idle > 0; --idle) tick();
    firstWith(servo, 0, room);
    edit(model, number);
    const std::uint64_t posted = servo.post(feelOrders(feelScene(model)));
    const std::uint64_t begun = servo.ticks();
    const std::uint64_t asked = servo.sceneCounters().asked;
    std::optional<haptics::Sample> first;
    while (!first) {
      tick();
      first = firstWith(servo, posted, room);
    }
    waited.push_back(static_cast<double>(first->tick - begun));
    if (first->phase == render::Phase::kReleased) continue;
    ++engaged;
    asked_at_once += servo.sceneCounters().asked - asked;
  }
  addTicks(part, "virtual time", waited);
  part.notes.push_back("Virtual time: of " + std::to_string(engaged) +
                       " edits while the hand held the tube, the first tick asked the new model in " +
                       std::to_string(asked_at_once));
}

void measureLive(FeelPart& part, int edits) {
  const auto simulated = device();
  haptics::Servo servo(*simulated);
  haptics::ServoThreadSettings settings;
  settings.real_time.lock_memory = false;
  haptics::ServoThread thread(servo, settings);
  const auto started = thread.start();
  TACTUS_CHECK(started.has_value());
  fuzzy::ForceModel model = syntheticExperts(4);
  haptics::ServoOrders orders = feelOrders(feelScene(model));
  // A busy machine may keep the servo waiting; the benchmark continues and shows it.
  orders.limits.servo_trip_s = 1e6;
  std::vector<haptics::Sample> room(haptics::SampleRing::kDefaultCapacity);
  std::vector<double> waited, making_ms, edit_ms, post_ms;
  base::Random random(2);
  const auto ms = [](std::int64_t from_ns, std::int64_t to_ns) { return static_cast<double>(to_ns - from_ns) * 1e-6; };
  for (int number = 0; number < edits; ++number) {
    haptics::sleepUntil(haptics::monotonicNs() + 2'000'000 + random.below(3'000'000));
    firstWith(servo, 0, room);
    edit(model, number);
    const std::int64_t edited_ns = haptics::monotonicNs();
    orders.scene = feelScene(model);
    const std::int64_t made_ns = haptics::monotonicNs();
    const std::uint64_t posted = servo.post(orders);
    const std::uint64_t begun = servo.ticks();
    std::optional<haptics::Sample> first;
    while (!first) {
      std::this_thread::yield();
      first = firstWith(servo, posted, room);
    }
    // A tick that began while the orders were handed over may have seen them already.
    waited.push_back(first->tick > begun ? static_cast<double>(first->tick - begun) : 0);
    making_ms.push_back(ms(edited_ns, made_ns));
    edit_ms.push_back(ms(edited_ns, first->time_ns));
    post_ms.push_back(ms(made_ns, first->time_ns));
  }
  thread.stop();
  addTicks(part, "live, from post to the first tick", waited);
  addTimes(part, "live, from post to the first tick", post_ms);
  addTimes(part, "live, making the scene", making_ms);
  addTimes(part, "live, from edit to the first tick", edit_ms);
  const haptics::LoopStatistics loop = servo.statistics();
  for (const auto& [name, times] : {std::pair{"live, lateness of ticks", &loop.lateness},
                                    std::pair{"live, length of ticks with the virtual device", &loop.tick_duration}}) {
    part.add(name, "median", "ms", static_cast<double>(times->quantileNs(0.5)) * 1e-6);
    part.add(name, "p99", "ms", static_cast<double>(times->quantileNs(0.99)) * 1e-6);
    part.add(name, "largest", "ms", static_cast<double>(times->largest_ns) * 1e-6);
  }
  const haptics::RealTime& real_time = thread.state().real_time;
  part.notes.push_back(
      "Live: real-time priority " +
      (real_time.priority > 0 ? std::to_string(real_time.priority) : "refused (" + real_time.priority_refused + ")") +
      "; " + std::to_string(loop.missed) + " of " + std::to_string(loop.ticks) +
      " ticks began more than a period too late");
}

}  // namespace

FeelPart measureEdits(int live_edits) {
  FeelPart part{"edit",
                "From an edit of a model of four experts to the first tick that uses it (required: at most 2 ticks)",
                {},
                {}};
  measureVirtual(part);
  if (live_edits > 0) measureLive(part, live_edits);
  return part;
}

}  // namespace tactus::bench
