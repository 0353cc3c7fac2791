// Recordings as the workbench stores them, of a hand that the test moves: each stroke a minimum-jerk push.
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/editing/edit.h"
#include "app/replay/recorded_strokes.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/model_io/model_file.h"
#include "core/render/insertion.h"

namespace tactus::replay {

struct Push {
  double way_mm = 60;
  double duration_s = 0.8;
  std::map<std::string, double> conditions = {{"lubrication", 1}, {"neck_flexion", 60}};
};

/// The place of a minimum-jerk movement from 0 to 1 at the share `t` of its time.
inline double minimumJerk(double t) { return t * t * t * (10 + t * (-15 + 6 * t)); }

/// `pushes` one after another: 0.3 s of rest, a press, the push, a release, the way back. `model` renders. The tube is
/// at `start_mm` at first. `late_s`: time by which one tick of each stroke comes late.
inline StoredRecording felt(const fuzzy::ForceModel& model, const std::vector<Push>& pushes, double start_mm = 0,
                            double late_s = 0) {
  StoredRecording out;
  out.id = study::RecordId{{1, 2, 3}};
  out.number = 1;
  out.person = "velvet-otter";
  out.model_name = model.name;
  out.model_text = *model_io::modelText(model, "felt.tactus.json");
  out.samples.channels = {{"time", "s", {}},         {"position", "mm", {}}, {"depth", "mm", {}},
                          {"source_force", "N", {}}, {"button", "1", {}},    {"placement", "1", {}}};
  for (const auto& [id, value] : pushes.front().conditions) out.samples.channels.push_back({id, "", {}});
  const auto ready = *editing::ready(model);
  render::Insertion insertion;
  insertion.place(start_mm);
  std::int64_t now_ns = 0;
  std::int64_t last_ns = -1'000'000;
  const auto tick = [&](double position_mm, bool held, const haptics::ServoScene& scene, const Push& push) {
    render::InsertionTick input;
    input.active = true;
    input.enabled = held;
    input.position_mm = position_mm;
    input.scene = &scene;
    input.fade_s = scene.fadeS();
    input.dt_s = static_cast<double>(now_ns - last_ns) * 1e-9;
    insertion.tick(input);
    const double offset_mm = scene.renderer().depth_offset_mm;
    std::vector<double> values = {
        static_cast<double>(now_ns) * 1e-9, position_mm,      insertion.state().depth_mm + offset_mm,
        insertion.state().force_n,          held ? 1.0 : 0.0, 1};
    for (const auto& [id, value] : push.conditions) values.push_back(value);
    for (std::size_t i = 0; i < values.size(); ++i) out.samples.channels[i].values.push_back(values[i]);
    last_ns = now_ns;
    now_ns += 1'000'000;
  };
  for (const Push& push : pushes) {
    haptics::SceneSettings settings;
    settings.largest_cost_s = std::numeric_limits<double>::infinity();
    const auto scene = *haptics::ServoScene::make(ready->model, ready->compiled, push.conditions, settings);
    const int ticks = static_cast<int>(push.duration_s * 1000);
    for (int i = 0; i < 300; ++i) tick(0, false, *scene, push);
    for (int i = 0; i <= ticks; ++i) {
      if (i == ticks / 2) now_ns += static_cast<std::int64_t>(late_s * 1e9);
      tick(push.way_mm * minimumJerk(static_cast<double>(i) / ticks), true, *scene, push);
    }
    for (int i = 0; i <= 200; ++i) tick(push.way_mm * minimumJerk(1 - i / 200.0), false, *scene, push);
  }
  return out;
}

}  // namespace tactus::replay
