#include "core/render/insertion.h"

#include <algorithm>
#include <cmath>

namespace tactus::render {
namespace {

/// Less than this is rounding left over from adding up ticks.
constexpr double kNoTimeS = 1e-9;

/// What is left after `dt_s` of something that falls to nothing, evenly, within `left_s`.
double kept(double left_s, double dt_s) noexcept {
  const double after_s = left_s - dt_s;
  return after_s > kNoTimeS ? after_s / left_s : 0;
}

}  // namespace

void Insertion::place(double start_depth_mm) noexcept {
  RendererState next;
  next.depth_mm = start_depth_mm;
  next.fault = state_.fault;
  next.position_mm = state_.position_mm;
  next.speed_mm_s = state_.speed_mm_s;
  // The force of the placement before goes as after a release; what fades already fades no slower.
  next.force_n = next.fading_n = state_.force_n;
  next.fading_rate_n_s =
      std::max(std::abs(state_.force_n) / kReleaseFadeS, state_.fading_n != 0 ? state_.fading_rate_n_s : 0);
  state_ = next;
}

double Insertion::tick(const InsertionTick& tick) noexcept {
  fade(tick.dt_s);
  takeScene(tick.scene, tick.fade_s);
  settings_.force_cap_n = std::max(0.0, tick.force_cap_n);

  RendererInput input;
  input.position_mm = tick.position_mm;
  input.enabled = tick.active && tick.enabled && tick.scene != nullptr;
  input.conditions = conditions_;
  const std::uint64_t asked_before = counters_.asked;
  if (const auto point = forceNeeded(state_, input, settings_)) input.force = answer(*point, tick);
  state_ = step(state_, input, settings_, tick.dt_s);

  if (tick.active) {
    ++counters_.ticks;
    if (counters_.asked == asked_before)
      ++(state_.phase == Phase::kReleased ? counters_.released : counters_.unchanged);
  }
  return state_.force_n;
}

void Insertion::takeScene(const TubeScene* scene, double fade_s) noexcept {
  const bool engaged = state_.phase != Phase::kReleased;
  const std::uint64_t serial = scene != nullptr ? scene->serial() : 0;
  const bool another = serial != scene_;
  scene_ = serial;
  if (another && scene != nullptr) {
    unasked_ = true;
    ++conditions_;
    target_ = scene->renderer();
    target_.stiffness_n_mm = std::min(target_.stiffness_n_mm, largest_stiffness_n_mm_);
    stiffness_limited_ = target_.stiffness_n_mm < scene->renderer().stiffness_n_mm;
    // Where the model is asked is no force: the difference to the answer there fades.
    settings_.friction.depth_offset_mm = target_.depth_offset_mm;
    settings_.depth_end_mm = scene->depthEndMm();
    untaken_ = true;
    fade_left_s_ = std::max(fade_left_s_, fade_s);
    if (fade_left_s_ <= 0) settings_.friction = target_;
  }
  if (engaged) return;
  // Nothing is felt: the next stroke begins with the scene as it is.
  settings_.friction = target_;
  difference_n_ = 0;
  fade_left_s_ = 0;
  untaken_ = false;
}

void Insertion::fade(double dt_s) noexcept {
  if (fade_left_s_ <= 0 || !(dt_s >= kShortestTickS)) return;
  const double share = kept(fade_left_s_, dt_s);
  for (const fuzzy::RendererField& field : fuzzy::kRendererFields) {
    double& rendered = settings_.friction.*field.member;
    const double target = target_.*field.member;
    rendered = share > 0 ? target + (rendered - target) * share : target;
  }
  if (difference_n_ != 0) ++conditions_;
  difference_n_ *= share;
  fade_left_s_ = share > 0 ? fade_left_s_ - dt_s : 0;
}

ModelForce Insertion::answer(const ForcePoint& point, const InsertionTick& tick) noexcept {
  const ModelForce before = answer_;
  if (unasked_ || point != asked_) {
    answer_ = tick.scene->force(point);
    asked_ = point;
    unasked_ = false;
    ++counters_.asked;
  }
  // Where no rule fires the renderer holds its force, and there is nothing to fade until one does.
  if (untaken_ && (answer_.fired || !state_.any_fired)) {
    untaken_ = false;
    fade_left_s_ = std::max(fade_left_s_, tick.fade_s);
    const double in_use_n = before.fired ? std::max(0.0, before.force_n + difference_n_) : state_.model_n;
    difference_n_ = fade_left_s_ > 0 ? in_use_n - answer_.force_n : 0;
  }
  return {answer_.force_n + difference_n_, answer_.fired};
}

}  // namespace tactus::render
