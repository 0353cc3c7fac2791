#include "app/replay/stroke_replay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editing/edit_impact.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/render/insertion_renderer.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::replay {
namespace {

using base::Result;
using haptics::ServoScene;
using render::ForcePoint;
using render::ModelForce;
using render::RendererState;
using Scene = std::shared_ptr<const ServoScene>;

/// The inputs that the renderer moves, and a range of them.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double min = low;  ///< of the universe
  double max = high;

  bool holds(double value) const {
    const double taken = std::clamp(value, min, max);
    return taken >= low && taken <= high;
  }
};

/// Where the forces of two models can differ for a stroke.
struct Region {
  bool empty = false;
  Range depth;
  Range speed;

  bool holds(const ForcePoint& at) const { return !empty && depth.holds(at.depth_mm) && speed.holds(at.speed_mm_s); }
};

bool sameInputs(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other) {
  return std::equal(one.inputs.begin(), one.inputs.end(), other.inputs.begin(), other.inputs.end(),
                    [](const fuzzy::Variable& a, const fuzzy::Variable& b) { return a.id == b.id; });
}

/// The region of `changed` in which the conditions of a stroke hold.
Region regionOf(const fuzzy::ForceModel& model, const std::vector<analysis::InputRange>& changed,
                const Conditions& conditions) {
  Region out;
  out.empty = changed.empty();
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const fuzzy::Variable& input = model.inputs[i];
    const Range range{changed[i].low, changed[i].high, input.min, input.max};
    const fuzzy::Role role = fuzzy::roleOf(input);
    if (role == fuzzy::Role::kWay) {
      out.depth = range;
    } else if (role == fuzzy::Role::kRate) {
      out.speed = range;
    } else {
      out.empty = out.empty || !range.holds(conditions.at(input.id));
    }
  }
  return out;
}

/// The value of each input that the renderer does not move: of the stroke, else of `otherwise`.
Conditions conditionsOf(const RecordedStroke& stroke, const fuzzy::ForceModel& model, const Conditions& otherwise) {
  Conditions out;
  for (const fuzzy::Variable& input : model.inputs) {
    if (fuzzy::roleOf(input) != fuzzy::Role::kCondition) continue;
    for (const Conditions* from : {&stroke.conditions, &otherwise}) {
      const auto found = from->find(input.id);
      if (found == from->end()) continue;
      out[input.id] = found->second;
      break;
    }
  }
  return out;
}

Result<Scene> sceneOf(const editing::ReadyModel& model, const Conditions& conditions) {
  haptics::SceneSettings settings;
  settings.largest_cost_s = std::numeric_limits<double>::infinity();
  return ServoScene::make(model.model, model.compiled, conditions, settings);
}

render::RendererSettings settingsOf(const ServoScene& scene) {
  render::RendererSettings out;
  out.friction = scene.renderer();
  out.depth_end_mm = scene.depthEndMm();
  return out;
}

bool sameSettings(const render::RendererSettings& one, const render::RendererSettings& other) {
  return one.friction == other.friction && one.depth_end_mm == other.depth_end_mm;
}

/// The renderer asks at the press, whatever it was told before. `done`: how many events of the model are.
render::RendererInput inputAt(const RecordedStroke& stroke, std::size_t tick, std::size_t done) {
  render::RendererInput input;
  input.position_mm = stroke.position_mm[tick];
  input.enabled = true;
  input.conditions = stroke.at_press.conditions + 1 + done;
  return input;
}

/// The force of the model where the tip has been as deep as `reach` says.
ModelForce forceAt(const ServoScene& scene, const render::StrokeReach& reach, const ForcePoint& at) {
  ModelForce out = scene.force(at);
  out.force_n *= scene.events().left(reach.deepest_mm, at.depth_mm);
  return out;
}

std::optional<double> holeOf(const RendererState& state) {
  const bool in_hole = state.held && state.phase != render::Phase::kReleased && state.asked;
  return in_hole ? std::optional(state.asked->depth_mm) : std::nullopt;
}

double noticeableAt(double force_n) { return elicitation::justNoticeableDifference(std::abs(force_n)); }

/// The stroke through the model after, beside the model before.
class AfterRun {
 public:
  AfterRun(const RecordedStroke& stroke, const StrokeRun& before, const Scene& scene_before, const Scene& scene,
           std::optional<Region> region)
      : stroke_(stroke),
        before_(before),
        settings_before_(settingsOf(*scene_before)),
        settings_(settingsOf(*scene)),
        scene_(scene),
        region_(region) {
    if (!sameSettings(settings_before_, settings_) || scene_before->events() != scene->events()) region_.reset();
  }

  ComparedStroke run() {
    const std::size_t size = stroke_.position_mm.size();
    out_.after_n.reserve(size);
    RendererState before = stroke_.at_press;
    RendererState after = before;
    render::StrokeReach reach_before;
    render::StrokeReach reach;
    bool same = region_.has_value();  // both states have the same bits
    auto answer = before_.answers.begin();
    for (std::size_t i = 0; i < size; ++i) {
      reach.follow(after, scene_->events());
      const bool asked = answer != before_.answers.end() && answer->tick == i;
      const bool stays = same && (!asked || !region_->holds(answer->point));
      if (region_) {
        reach_before.follow(before, scene_->events());
        render::RendererInput input = inputAt(stroke_, i, reach_before.done);
        if (asked) input.force = answer->force;
        before = render::step(before, input, settings_before_, stroke_.dt_s[i]);
      }
      if (asked) ++answer;
      if (stays) {
        after = before;
      } else {
        after = render::stepAsking(after, inputAt(stroke_, i, reach.done), settings_, stroke_.dt_s[i],
                                   [&](const ForcePoint& at) {
                                     ++out_.asked;
                                     return forceAt(*scene_, reach, at);
                                   });
        same = region_ && after == before && reach == reach_before;
      }
      out_.after_n.push_back(after.force_n);
      if (!out_.hole_mm[1]) out_.hole_mm[1] = holeOf(after);
    }
    out_.hole_mm[0] = before_.hole_mm;
    return std::move(out_);
  }

 private:
  const RecordedStroke& stroke_;
  const StrokeRun& before_;
  render::RendererSettings settings_before_;
  render::RendererSettings settings_;
  const Scene& scene_;
  std::optional<Region> region_;  ///< nothing: they can differ everywhere
  ComparedStroke out_;
};

void addNumbers(const RecordedStroke& stroke, const StrokeRun& before, ComparedStroke& compared) {
  if (compared.hole_mm[0] || compared.hole_mm[1]) return;
  std::vector<double> time_s(stroke.dt_s.size(), 0);
  for (std::size_t i = 1; i < time_s.size(); ++i) time_s[i] = time_s[i - 1] + stroke.dt_s[i];
  compared.numbers = numbersOf({time_s, stroke.position_mm, before.depth_mm, {before.force_n, compared.after_n}});
}

StrokeSummary summaryOf(const std::vector<ComparedStroke>& strokes, std::size_t all) {
  StrokeSummary out;
  std::vector<double> noticeable;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const ComparedStroke& one = strokes[i];
    if (one.hole_mm[1] && !one.hole_mm[0]) ++out.holes;
    if (!one.numbers) continue;
    if (!out.worst) out.worst = i;
    if (one.numbers->noticeable >= 1) ++out.felt;
    noticeable.push_back(one.numbers->noticeable);
  }
  out.compared = noticeable.size();
  out.left_out = all - strokes.size();
  if (!noticeable.empty()) {
    std::sort(noticeable.begin(), noticeable.end());
    const std::size_t middle = noticeable.size() / 2;
    out.median_noticeable =
        noticeable.size() % 2 == 1 ? noticeable[middle] : (noticeable[middle - 1] + noticeable[middle]) / 2;
  }
  return out;
}

/// The worst first.
bool isWorse(const ComparedStroke& one, const ComparedStroke& other) {
  const auto rank = [](const ComparedStroke& of) {
    if (of.hole_mm[1] && !of.hole_mm[0]) return std::numeric_limits<double>::infinity();
    return of.numbers ? of.numbers->noticeable : -1;
  };
  return rank(one) > rank(other);
}

}  // namespace

StrokeNumbers numbersOf(const StrokeTrace& trace) {
  StrokeNumbers out;
  double squares = 0;
  double sum = 0;
  double felt_s = 0;
  double felt_mm = 0;
  double path_mm = 0;
  for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
    const double before_n = trace.force_n[0][i];
    const double by_n = trace.force_n[1][i] - before_n;
    const double noticeable_n = noticeableAt(before_n);
    for (std::size_t side = 0; side < 2; ++side) {
      out.peak_n[side] = i == 0 ? trace.force_n[side][0] : std::max(out.peak_n[side], trace.force_n[side][i]);
    }
    if (std::abs(by_n) > out.largest_n || i == 0) {
      out.largest_n = std::abs(by_n);
      out.largest_at_mm = trace.depth_mm[i];
      out.largest_tick = i;
    }
    if (std::abs(by_n) / noticeable_n > out.noticeable || i == 0) {
      out.noticeable = std::abs(by_n) / noticeable_n;
      out.noticeable_at_mm = trace.depth_mm[i];
      out.noticeable_by_n = by_n;
    }
    // Half of each interval beside the sample.
    const bool has_last = i > 0;
    const bool has_next = i + 1 < trace.time_s.size();
    const double before_s = has_last ? trace.time_s[i] - trace.time_s[i - 1] : 0;
    const double after_s = has_next ? trace.time_s[i + 1] - trace.time_s[i] : 0;
    const double before_mm = has_last ? trace.path_mm[i] - trace.path_mm[i - 1] : 0;
    const double after_mm = has_next ? trace.path_mm[i + 1] - trace.path_mm[i] : 0;
    const double weight_s = (before_s + after_s) / 2;
    const double weight_mm = (std::abs(before_mm) + std::abs(after_mm)) / 2;
    const double forward_mm = (std::max(0.0, before_mm) + std::max(0.0, after_mm)) / 2;
    squares += by_n * by_n * weight_s;
    sum += by_n * weight_s;
    path_mm += weight_mm;
    for (std::size_t side = 0; side < 2; ++side) out.work_mj[side] += trace.force_n[side][i] * forward_mm;
    if (std::abs(by_n) > noticeable_n) {
      felt_s += weight_s;
      felt_mm += weight_mm;
    }
  }
  const double length_s = trace.time_s.back() - trace.time_s.front();
  out.rms_n = std::sqrt(squares / length_s);
  out.mean_n = sum / length_s;
  out.time_share = felt_s / length_s;
  out.path_share = path_mm > 0 ? felt_mm / path_mm : 0;
  return out;
}

Result<StrokeRun> runStroke(const RecordedStroke& stroke, const editing::ReadyModel& model,
                            const Conditions& otherwise) {
  TACTUS_TRY(const Scene scene, sceneOf(model, conditionsOf(stroke, model.model, otherwise)));
  const render::RendererSettings settings = settingsOf(*scene);
  StrokeRun out;
  RendererState state = stroke.at_press;
  render::StrokeReach reach;
  for (std::size_t i = 0; i < stroke.position_mm.size(); ++i) {
    reach.follow(state, scene->events());
    state =
        render::stepAsking(state, inputAt(stroke, i, reach.done), settings, stroke.dt_s[i], [&](const ForcePoint& at) {
          out.answers.push_back({i, at, forceAt(*scene, reach, at)});
          return out.answers.back().force;
        });
    out.force_n.push_back(state.force_n);
    out.depth_mm.push_back(state.depth_mm + settings.friction.depth_offset_mm);
    if (!out.hole_mm) out.hole_mm = holeOf(state);
  }
  return out;
}

StrokeBaseline baselineOf(std::shared_ptr<const std::vector<RecordedStroke>> strokes, editing::SharedModel before,
                          Conditions otherwise, const std::stop_token& stop) {
  StrokeBaseline out{std::move(strokes), std::move(before), std::move(otherwise), {}, {}};
  out.runs.resize(out.strokes->size());
  for (std::size_t i = 0; i < out.runs.size() && !stop.stop_requested(); ++i) {
    const RecordedStroke& stroke = (*out.strokes)[i];
    if (!isCompared(stroke.use)) continue;
    auto run = runStroke(stroke, *out.model, out.otherwise);
    if (run) {
      out.runs[i] = *std::move(run);
    } else if (!out.refusal) {
      out.refusal = std::move(run).error();
    }
  }
  return out;
}

StrokeComparison compareStrokes(const StrokeBaseline& before, const editing::ReadyModel& after, Skip skip,
                                const std::stop_token& stop) {
  const fuzzy::ForceModel& model_before = before.model->model;
  const bool skips = skip == Skip::kUnchanged && sameInputs(model_before, after.model);
  const auto changed = skips ? editing::changedRegion(model_before, after.model) : std::vector<analysis::InputRange>();
  StrokeComparison out;
  for (std::size_t i = 0; i < before.runs.size() && !stop.stop_requested(); ++i) {
    if (!before.runs[i]) continue;
    const RecordedStroke& stroke = (*before.strokes)[i];
    const Conditions conditions = conditionsOf(stroke, after.model, before.otherwise);
    const auto scene_before = sceneOf(*before.model, conditionsOf(stroke, model_before, before.otherwise));
    const auto scene = sceneOf(after, conditions);
    if (!scene_before || !scene) continue;
    const auto region = skips ? std::optional(regionOf(after.model, changed, conditions)) : std::nullopt;
    ComparedStroke compared = AfterRun(stroke, *before.runs[i], *scene_before, *scene, region).run();
    compared.stroke = i;
    addNumbers(stroke, *before.runs[i], compared);
    out.strokes.push_back(std::move(compared));
  }
  std::stable_sort(out.strokes.begin(), out.strokes.end(), isWorse);
  out.summary = summaryOf(out.strokes, before.strokes->size());
  return out;
}

}  // namespace tactus::replay
