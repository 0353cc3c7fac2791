#include "tests/bench/feel_ticks.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "core/haptics/servo/servo.h"
#include "core/render/insertion_renderer.h"

#include "tests/bench/cases.h"
#include "tests/bench/contenders.h"
#include "tests/bench/feel_loop.h"
#include "tests/bench/text_table.h"
#include "tests/bench/tick_stream.h"

namespace tactus::bench {
namespace {

using haptics::ServoOrders;

constexpr int kWarmTicks = 2000;  ///< the hand has pressed, the fade-in is over
constexpr int kTicks = 4000;      ///< that are timed, again and again
constexpr std::size_t kEvictBytes = std::size_t{4} << 20U;

/// A recorded loop in which the hand does one thing all the time.
struct Recorded {
  ServoOrders orders;
  FeelRun run;
};

enum class Doing { kReleased, kStuck, kSliding };
constexpr std::pair<Doing, const char*> kDoings[] = {
    {Doing::kReleased, "released"}, {Doing::kStuck, "stuck"}, {Doing::kSliding, "sliding in"}};

/// The tremor of the hand, and while it slides 90 mm/s, swinging through all three terms of the speed.
haptics::HandPlan planOf(Doing doing) {
  auto tremor = haptics::swing(0.1, 9);
  if (doing == Doing::kReleased) return tremor;
  if (doing == Doing::kStuck) return haptics::pressing(tremor, 0.1);
  const auto uneven = haptics::both(haptics::push(90), haptics::swing(6, 1.5));
  return haptics::pressing(haptics::both(haptics::after(1.5, uneven), tremor), 0.1);
}

std::shared_ptr<const Recorded> record(const fuzzy::ForceModel& model, Doing doing) {
  haptics::VirtualDeviceSettings settings;
  settings.plan = planOf(doing);
  const ServoOrders orders = feelOrders(feelScene(model));
  auto recorded = std::make_shared<Recorded>(
      Recorded{orders, runFeelLoop(std::move(settings), orders, kWarmTicks + kTicks, kWarmTicks)});
  constexpr render::Phase kPhases[] = {render::Phase::kReleased, render::Phase::kStuck, render::Phase::kSlidingIn};
  const render::Phase wanted = kPhases[static_cast<int>(doing)];
  const auto& ticks = recorded->run.ticks;
  TACTUS_CHECK(std::all_of(ticks.begin() + kWarmTicks, ticks.end(),
                           [wanted](const FeelTick& tick) { return tick.sample.phase == wanted; }));
  return recorded;
}

/// The renderer alone: step, and the model where it is needed.
class RendererTicks {
 public:
  explicit RendererTicks(std::shared_ptr<const Recorded> recorded) : recorded_(std::move(recorded)) {
    const haptics::ServoScene& scene = *recorded_->orders.scene;
    settings_.friction = scene.renderer();
    settings_.depth_end_mm = scene.depthEndMm();
    for (; at_ < kWarmTicks; ++at_) step();
    begin_ = state_;
  }
  void restart() {
    state_ = begin_;
    at_ = kWarmTicks;
  }
  double next() {
    step();
    ++at_;
    return state_.force_n;
  }

 private:
  void step() {
    const haptics::Sample& sample = recorded_->run.ticks[at_].sample;
    const haptics::ServoScene& scene = *recorded_->orders.scene;
    state_ = render::stepAsking(state_, {sample.position_mm, sample.enabled, 1, {}}, settings_, kFeelTickS,
                                [&scene](const render::ForcePoint& point) { return scene.force(point); });
  }

  std::shared_ptr<const Recorded> recorded_;
  render::RendererSettings settings_;
  render::RendererState state_, begin_;
  std::size_t at_ = 0;
};

/// ServoCore: safety, sources and limits as well.
class CoreTicks {
 public:
  explicit CoreTicks(std::shared_ptr<const Recorded> recorded)
      : recorded_(std::move(recorded)), core_(recorded_->run.core) {}
  void restart() {
    core_ = recorded_->run.core;
    at_ = kWarmTicks;
  }
  double next() { return core_.tick(told(recorded_->run.ticks[at_++].device, recorded_->orders)).force_n; }

 private:
  std::shared_ptr<const Recorded> recorded_;
  haptics::ServoCore core_;
  std::size_t at_ = kWarmTicks;
};

/// A device that says what was recorded.
class RecordedDevice final : public haptics::HapticDevice {
 public:
  explicit RecordedDevice(const std::vector<FeelTick>& ticks) : ticks_(ticks) {
    info_.max_force_n = 3.3;
    info_.damping_n_s_mm = 0.0002;
  }
  const haptics::DeviceInfo& info() const noexcept override { return info_; }
  base::Result<void> start() override { return {}; }
  void stop() noexcept override {}
  haptics::DeviceState read(std::int64_t /*now_ns*/) noexcept override { return ticks_[at_++].device; }
  void write(const haptics::Vector3& force_n, std::int64_t /*now_ns*/) noexcept override { force_n_ = force_n; }

  double forceN() const noexcept { return force_n_.z; }

 private:
  const std::vector<FeelTick>& ticks_;
  haptics::DeviceInfo info_;
  std::size_t at_ = 0;
  haptics::Vector3 force_n_;
};

/// Servo: orders from the mailbox, the sample into ring and flight recorder, and the statistics as well.
class ServoTicks {
 public:
  explicit ServoTicks(std::shared_ptr<const Recorded> recorded) : recorded_(std::move(recorded)) {}
  void restart() {
    servo_.reset();
    device_ = std::make_unique<RecordedDevice>(recorded_->run.ticks);
    servo_ = std::make_unique<haptics::Servo>(*device_);
    servo_->post(recorded_->orders);
    for (at_ = 0; at_ < kWarmTicks; ++at_) servo_->tick(nowNs());
  }
  double next() {
    servo_->tick(nowNs());
    ++at_;
    return device_->forceN();
  }

 private:
  std::int64_t nowNs() const { return recorded_->run.ticks[at_].device.time_ns; }

  std::shared_ptr<const Recorded> recorded_;
  std::unique_ptr<RecordedDevice> device_;
  std::unique_ptr<haptics::Servo> servo_;
  std::size_t at_ = 0;
};

template <typename Ticks>
TickStream streamOf(std::string name, std::shared_ptr<const Recorded> recorded, bool quick_restart = true) {
  const auto ticks = std::make_shared<Ticks>(std::move(recorded));
  return {std::move(name), kTicks, [ticks] { ticks->restart(); }, [ticks] { return ticks->next(); }, quick_restart};
}

std::string experts(int count) { return std::to_string(count) + (count == 1 ? " expert" : " experts"); }

void addStreams(std::vector<TickStream>& streams, const std::string& who, const fuzzy::ForceModel& model,
                bool sliding_only) {
  for (const auto& [doing, name] : kDoings) {
    if (sliding_only && doing != Doing::kSliding) continue;
    const auto recorded = record(model, doing);
    const auto named = [&who, tail = std::string(name)](const char* what) {
      return base::joined(std::vector<std::string>{who, ": ", what, ", ", tail}, "");
    };
    streams.push_back(streamOf<RendererTicks>(named("renderer"), recorded));
    streams.push_back(streamOf<CoreTicks>(named("core tick"), recorded));
    streams.push_back(streamOf<ServoTicks>(named("whole tick"), recorded, false));
  }
}

/// One evaluation after the other, at shuffled points.
TickStream fuzzyliteStream(const Contender& contender) {
  const auto at = std::make_shared<std::size_t>(0);
  return {"fuzzylite 100, one expert", contender.job.count, [at] { *at = 0; },
          [at, run = contender.job.run] {
            double force_n = 0;
            run((*at)++, {&force_n, 1});
            return force_n;
          },
          true};
}

constexpr std::string_view kJudged = "4 experts: whole tick, sliding in";

}  // namespace

FeelPart measureTicks(int rounds) {
  FeelPart part{
      "tick",
      "Time of one tick: renderer with model; core tick (ServoCore: with safety); whole tick (Servo: with orders, "
      "ring, recorder, statistics)",
      {},
      {}};
  std::vector<TickStream> streams;
  const Case clip =
      makeCase("one expert", oneExpert(fuzzy::Implication::kClip), std::vector<std::optional<double>>(4), 0);
  const auto peer = fuzzylite(clip, 100);
  if (peer) streams.push_back(fuzzyliteStream(*peer));
  for (const int count : {1, 4, 32, 256}) addStreams(streams, experts(count), syntheticExperts(count), false);
  for (const int count : {4, 32, 256}) {
    addStreams(streams, experts(count) + " with own terms", syntheticExperts(count, true), true);
  }

  std::vector<Job> jobs;
  std::vector<std::size_t> job_of(streams.size());
  for (std::size_t i = 0; i < streams.size(); ++i) {
    if (!streams[i].quick_restart) continue;
    job_of[i] = jobs.size();
    jobs.push_back(batchesOf(streams[i]));
  }
  const auto batches = timeInterleaved(jobs, {.rounds = std::max(1, rounds / 4)});
  const auto single = timeSingleTicks(streams, {.rounds = rounds});
  const auto cold = timeSingleTicks(streams, {.rounds = rounds, .ticks_per_turn = 5, .evict_bytes = kEvictBytes});

  const auto p99 = [](const SingleTickTimings& timings, std::size_t i) {
    return base::quantile(timings.times_ns[i], 0.99);
  };
  const double unit_ns = base::median(single.times_ns.front());
  const double cold_unit_ns = base::median(cold.times_ns.front());
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const std::string& name = streams[i].name;
    if (streams[i].quick_restart) part.add(name, "median in batches", "ns", batches.timings[job_of[i]].median_ns);
    part.add(name, "median", "ns", base::median(single.times_ns[i]));
    part.add(name, "p99", "ns", p99(single, i));
    part.add(name, "cold median", "ns", base::median(cold.times_ns[i]));
    part.add(name, "cold p99", "ns", p99(cold, i));
    if (!peer) continue;
    part.add(name, "p99 / fuzzylite 100", "1", p99(single, i) / unit_ns);
    part.add(name, "cold p99 / cold fuzzylite 100", "1", p99(cold, i) / cold_unit_ns);
    if (name != kJudged) continue;
    part.notes.push_back("p99 of a tick with four experts / one fuzzylite evaluation at resolution 100 (its median): " +
                         threeDigits(p99(single, i) / unit_ns) + " (required: at most 1)");
    part.notes.push_back("The same with cold caches both: " + threeDigits(p99(cold, i) / cold_unit_ns) +
                         ". p99 by the p99 of fuzzylite: " + threeDigits(p99(single, i) / p99(single, 0)) + ", cold " +
                         threeDigits(p99(cold, i) / p99(cold, 0)));
  }
  if (!peer) part.notes.push_back("fuzzylite is not installed: no ratio");
  part.notes.push_back(
      "Batches: turns of a millisecond, ticks without a pause. Others: single ticks, the reading of the "
      "clock (" +
      threeDigits(single.clock_ns) + " ns, median of the same run) subtracted");
  part.notes.push_back("Cold: 4 MiB are read before each tick, so that code and data come from the last cache; " +
                       std::to_string(cold.times_ns.front().size()) + " ticks each, others " +
                       std::to_string(single.times_ns.front().size()));
  return part;
}

}  // namespace tactus::bench
