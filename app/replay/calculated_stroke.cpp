#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "app/replay/recorded_strokes.h"
#include "core/base/check.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/render/insertion.h"

namespace tactus::replay {
namespace {

constexpr std::int64_t kTickNs = 1'000'000;  // 1 kHz, as the servo
constexpr double kRateHz = 1000;
constexpr double kApartS = 0.1;    // with an open hand, before and after
constexpr double kHoldingS = 0.2;  // with a closed hand at rest, before and after

/// The channels of a recording in the order of docs/study-file.md, without the conditions.
constexpr std::pair<const char*, const char*> kChannels[] = {
    {"time", "s"},     {"position", "mm"},   {"speed", "mm/s"},     {"depth", "mm"}, {"slip_speed", "mm/s"},
    {"stretch", "mm"}, {"model_force", "N"}, {"source_force", "N"}, {"force", "N"},  {"button", "1"},
    {"stroke", "1"},   {"placement", "1"},   {"limited", "1"}};

}  // namespace

base::Result<study::Recording> calculatedRecording(const contracts::Stroke& stroke, const editing::ReadyModel& model) {
  const fuzzy::ForceModel& of = model.model;
  TACTUS_CHECK(stroke.inputs.size() == of.inputs.size());
  haptics::Conditions conditions;
  study::Recording out;
  out.sample_rate_hz = kRateHz;
  for (const auto& [name, unit] : kChannels) out.channels.push_back({name, unit, {}});
  std::vector<double> held;
  for (std::size_t i = 0; i < of.inputs.size(); ++i) {
    if (fuzzy::roleOf(of.inputs[i]) != fuzzy::Role::kCondition) continue;
    conditions[of.inputs[i].id] = stroke.inputs[i];
    held.push_back(stroke.inputs[i]);
    out.channels.push_back({of.inputs[i].id, of.inputs[i].unit, {}});
  }
  haptics::SceneSettings settings;
  settings.largest_cost_s = std::numeric_limits<double>::infinity();
  TACTUS_TRY(const auto scene, haptics::ServoScene::make(of, model.compiled, conditions, settings));
  const double offset_mm = scene->renderer().depth_offset_mm;

  const double length_s = contracts::momentOf(stroke, 1).time_s;
  const double begin_s = kApartS + kHoldingS;
  const double end_s = begin_s + length_s;
  const auto ticks = static_cast<std::size_t>(std::ceil((end_s + kHoldingS + kApartS) * kRateHz)) + 1;
  render::Insertion insertion;
  // The same depth comes out of the channel again, to the last bit.
  const double start_mm = stroke.from_mm - offset_mm;
  insertion.place((start_mm + offset_mm) - offset_mm);
  for (std::size_t i = 0; i < ticks; ++i) {
    const double time_s = static_cast<double>(static_cast<std::int64_t>(i) * kTickNs) * 1e-9;
    const auto moment = contracts::momentOf(stroke, std::clamp((time_s - begin_s) / length_s, 0.0, 1.0));
    render::InsertionTick tick;
    tick.active = true;
    tick.enabled = time_s >= kApartS && time_s < end_s + kHoldingS;
    tick.position_mm = moment.depth_mm - stroke.from_mm;
    tick.scene = scene.get();
    tick.fade_s = scene->fadeS();
    tick.dt_s = i == 0 ? 1 / kRateHz : static_cast<double>(kTickNs) * 1e-9;
    insertion.tick(tick);
    const render::RendererState& state = insertion.state();
    auto channel = out.channels.begin();
    const auto put = [&](double value) { (channel++)->values.push_back(value); };
    put(time_s);
    put(tick.position_mm);
    put(moment.speed_mm_s);
    put(state.depth_mm + offset_mm);
    put(state.slip_speed_mm_s.value);
    put(state.stretch_mm);
    put(tick.enabled ? state.dynamic_n : 0);
    put(state.force_n);
    put(state.force_n);
    put(tick.enabled ? 1 : 0);
    put(state.stroke.number);
    put(1);
    put(0);
    for (const double value : held) put(value);
  }
  return out;
}

}  // namespace tactus::replay
