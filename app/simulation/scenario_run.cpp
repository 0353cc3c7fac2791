#include "app/simulation/scenario_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::simulation {
namespace {

constexpr std::string_view kColumns[] = {
    "time_s",        "simulated", "wish_mm", "true_position_mm", "true_speed_mm_s", "position_mm",    "speed_mm_s",
    "button",        "enabled",   "phase",   "stroke",           "depth_mm",        "slip_mm_s",      "stretch_mm",
    "model_force_n", "held",      "source",  "source_force_n",   "force_n",         "device_force_n", "limited",
    "trip",          "orders"};

std::string_view phaseName(render::Phase phase) {
  constexpr std::string_view kNames[] = {"released", "stuck", "sliding_in", "sliding_out"};
  return kNames[static_cast<int>(phase)];
}

std::string_view tripName(haptics::TripCause cause) {
  constexpr std::string_view kNames[] = {"",
                                         "force_not_finite",
                                         "position_not_finite",
                                         "too_fast_inwards",
                                         "too_fast_outwards",
                                         "device_silent",
                                         "write_stuck",
                                         "servo_late",
                                         "device_lost",
                                         "device_fault",
                                         "renderer",
                                         "stopped"};
  return kNames[static_cast<int>(cause)];
}

/// The limits that acted, e.g. `fade_in+slew`.
std::string limitNames(std::uint32_t limited) {
  std::string text;
  for (std::size_t bit = 0; bit < haptics::kLimitNames.size(); ++bit) {
    if ((limited >> bit & 1U) == 0) continue;
    if (!text.empty()) text += '+';
    text += haptics::kLimitNames[bit];
  }
  return text;
}

std::vector<std::string> columnsWith(const std::vector<std::string>& conditions) {
  std::vector<std::string> all(std::begin(kColumns), std::end(kColumns));
  all.insert(all.end(), conditions.begin(), conditions.end());
  return all;
}

std::vector<std::string> idsOf(const haptics::Conditions& conditions) {
  std::vector<std::string> ids;
  for (const auto& [id, value] : conditions) ids.push_back(id);
  return ids;
}

}  // namespace

TraceTable::TraceTable(const haptics::Conditions& conditions)
    : conditions_(idsOf(conditions)), csv_(columnsWith(conditions_)) {}

void TraceTable::add(const TraceTick& tick) {
  const auto& s = tick.sample;
  csv_.cell(static_cast<double>(s.time_ns) / 1e9).cell(1).cell(tick.wish.position_mm).cell(tick.true_position_mm);
  csv_.cell(tick.true_speed_mm_s).cell(s.position_mm).cell(s.speed_mm_s).cell(tick.wish.button ? 1 : 0);
  csv_.cell(s.enabled ? 1 : 0).cell(phaseName(s.phase)).cell(static_cast<long long>(s.stroke)).cell(s.depth_mm);
  csv_.cell(s.slip_speed_mm_s).cell(s.stretch_mm).cell(s.model_force_n).cell(s.held ? 1 : 0).cell(name(s.source));
  csv_.cell(s.source_force_n).cell(s.force_n).cell(tick.device_force_n);
  csv_.cell(limitNames(s.limited)).cell(tripName(s.trip)).cell(static_cast<long long>(s.orders));
  for (const auto& id : conditions_) csv_.cell(tick.conditions->at(id));
  csv_.endRow();
}

namespace {

using haptics::Sample;
using haptics::ServoOrders;
using render::Phase;

constexpr std::int64_t kTickNs = 1'000'000;
/// The program lives; it gives a sign of life this often, as the workbench does.
constexpr std::int64_t kHeartbeatNs = 50 * kTickNs;

/// The orders in force, and how events change them.
class Orders {
 public:
  Orders(const Scenario& scenario, const haptics::DeviceInfo& device, const fuzzy::ForceModel& model,
         const ReadModel& read_model)
      : conditions_(scenario.conditions), model_(&model), read_model_(read_model) {
    orders_.source = haptics::ForceSource::kInsertion;
    orders_.armed = true;
    orders_.placement = 1;
    orders_.start_depth_mm = scenario.start_depth_mm;
    orders_.enable = scenario.enable;
    orders_.limits = haptics::LimitSettings::forDevice(device, scenario.expert_limits);
    orders_.limits.guard_velocity = scenario.guard_velocity;
  }

  base::Result<void> takeScene(double fade_s) {
    haptics::SceneSettings settings;
    settings.fade_s = fade_s;
    settings.largest_cost_s = std::numeric_limits<double>::infinity();  // nothing may depend on this machine's clock
    TACTUS_TRY(auto scene, haptics::ServoScene::make(*model_, conditions_, settings));
    orders_.scene = std::move(scene);
    return {};
  }

  base::Result<void> take(const ScenarioEvent& event) {
    ++number_;
    if (event.source) orders_.source = *event.source;
    if (event.armed) orders_.armed = *event.armed;
    if (event.placement) ++orders_.placement;
    if (event.stimulus_n) {
      ++orders_.stimulus.number;
      orders_.stimulus.force_n = *event.stimulus_n;
    }
    if (event.model.empty() && event.conditions.empty()) return {};
    for (const auto& [id, value] : event.conditions) conditions_[id] = value;
    base::Result<void> taken;
    if (!event.model.empty()) taken = takeModel(event.model);
    if (taken) taken = takeScene(event.fade_s);
    // The sentence says which event it was.
    if (!taken) taken.error().wanted += ", for " + event.place + " of the scenario";
    return taken;
  }

  const ServoOrders& now() const noexcept { return orders_; }
  std::uint64_t number() const noexcept { return number_; }
  const haptics::Conditions& conditions() const noexcept { return conditions_; }

 private:
  base::Result<void> takeModel(const std::string& path) {
    TACTUS_TRY(auto read, read_model_(path));
    other_ = std::move(read);
    model_ = &other_;
    return {};
  }

  ServoOrders orders_;
  std::uint64_t number_ = 0;  ///< of events taken
  haptics::Conditions conditions_;
  const fuzzy::ForceModel* model_;
  fuzzy::ForceModel other_;
  const ReadModel& read_model_;
};

/// Adds up what a run did.
class Watch {
 public:
  RunSummary summary;

  void see(const TraceTick& tick, const haptics::Trip& trip) {
    const Sample& sample = tick.sample;
    ++summary.ticks;
    summary.depth_mm = sample.depth_mm;
    summary.largest_force_n = std::max(summary.largest_force_n, std::abs(sample.force_n));
    summary.largest_step_n = std::max(summary.largest_step_n, std::abs(sample.force_n - last_.force_n));
    summary.held_ticks += sample.held ? 1 : 0;
    if (sample.stroke != last_.stroke) slid_ = false;
    if (sample.phase == Phase::kSlidingIn && !slid_) {
      slid_ = true;
      ++summary.strokes;
    }
    const bool rubbed = last_.phase != Phase::kReleased && sample.phase != Phase::kReleased;
    if (rubbed && last_.phase != sample.phase) ++summary.transitions;
    if (sample.phase == Phase::kSlidingIn) {
      sliding_sum_n_ += sample.force_n;
      ++sliding_;
      summary.mean_sliding_n = sliding_sum_n_ / sliding_;
    }
    if (tick.wish.button && wished_.button) summary.planned_mm += tick.wish.position_mm - wished_.position_mm;
    if (trip && !tripped_) summary.trips.push_back({static_cast<double>(sample.time_ns) / 1e9, trip});
    tripped_ = static_cast<bool>(trip);
    for (std::size_t bit = 0; bit < summary.limits.size(); ++bit) {
      if ((sample.limited >> bit & 1U) == 0) continue;
      summary.limits[bit].times += (last_.limited >> bit & 1U) == 0 ? 1 : 0;
      ++summary.limits[bit].ticks;
    }
    wished_ = tick.wish;
    last_ = sample;
  }

 private:
  Sample last_;
  haptics::HandTarget wished_;
  bool slid_ = false;  ///< in this stroke
  bool tripped_ = false;
  double sliding_sum_n_ = 0;
  int sliding_ = 0;
};

}  // namespace

base::Result<RunSummary> runScenario(const Scenario& scenario, const fuzzy::ForceModel& model,
                                     const ReadModel& read_model, const std::function<void(const TraceTick&)>& each) {
  const auto plan = handPlan(scenario);
  auto settings = scenario.device;
  settings.plan = plan;
  TACTUS_TRY(auto device, haptics::VirtualDevice::make(std::move(settings)));
  if (auto started = (device)->start(); !started) return tl::unexpected(std::move(started.error()));

  Orders orders(scenario, (device)->info(), model, read_model);
  if (auto taken = orders.takeScene(0); !taken) return tl::unexpected(std::move(taken.error()));
  haptics::ServoCore core((device)->info());
  Watch watch;
  bool alive = true;
  std::int64_t heartbeat_ns = kTickNs;  // alive at the start, whatever happens then
  auto event = scenario.events.begin();
  const auto ticks = static_cast<std::int64_t>(std::llround(1000 * scenario.duration_s));
  for (std::int64_t i = 0; i < ticks; ++i) {
    const std::int64_t now_ns = (i + 1) * kTickNs;
    const double time_s = static_cast<double>(i) / 1e3;
    bool stop = false;
    for (; event != scenario.events.end() && event->at_s <= time_s; ++event) {
      if (auto taken = orders.take(*event); !taken) return tl::unexpected(std::move(taken.error()));
      alive = event->program_alive.value_or(alive);
      stop = stop || event->stop;
    }
    if (alive && now_ns - heartbeat_ns >= kHeartbeatNs) heartbeat_ns = now_ns;

    TraceTick tick;
    haptics::ServoTick input{now_ns, (device)->read(now_ns), &orders.now(), orders.number(), false, stop, heartbeat_ns};
    tick.sample = core.tick(input);
    (device)->write(core.deviceForce(tick.sample), now_ns);
    tick.sample.time_ns = now_ns - kTickNs;
    tick.wish = plan(time_s);
    tick.true_position_mm = (device)->truePositionMm();
    tick.true_speed_mm_s = (device)->trueSpeedMmS();
    tick.device_force_n = (device)->trueForceN();
    tick.conditions = &orders.conditions();
    watch.see(tick, core.tripped());
    each(tick);
  }
  watch.summary.start_depth_mm = scenario.start_depth_mm;
  watch.summary.duration_s = static_cast<double>(ticks) / 1e3;
  watch.summary.scene = core.counters();
  return watch.summary;
}

}  // namespace tactus::simulation
