#include "core/render/insertion.h"

#include <algorithm>
#include <cmath>

#include "core/render/renderer_state.h"

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

void Insertion::limitStiffness(double largest_stiffness_n_mm, double fade_s) noexcept {
  largest_stiffness_n_mm_ = largest_stiffness_n_mm;
  target_.stiffness_n_mm = std::min(model_stiffness_n_mm_, largest_stiffness_n_mm_);
  stiffness_limited_ = target_.stiffness_n_mm < model_stiffness_n_mm_;
  if (settings_.friction.stiffness_n_mm != target_.stiffness_n_mm) fade_left_s_ = std::max(fade_left_s_, fade_s);
}

double Insertion::tick(const InsertionTick& tick) noexcept {
  fade(tick.dt_s);
  takeScene(tick.scene, tick.fade_s);
  takeEvents(tick.scene);
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
    model_stiffness_n_mm_ = target_.stiffness_n_mm;
    target_.stiffness_n_mm = std::min(model_stiffness_n_mm_, largest_stiffness_n_mm_);
    stiffness_limited_ = target_.stiffness_n_mm < model_stiffness_n_mm_;
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

void Insertion::takeEvents(const TubeScene* scene) noexcept {
  if (scene == nullptr || !reach_.follow(state_, scene->events())) return;
  unasked_ = true;
  ++conditions_;
}

ModelForce Insertion::answer(const ForcePoint& point, const InsertionTick& tick) noexcept {
  const ModelForce before = answer_;
  if (unasked_ || point != asked_) {
    answer_ = tick.scene->force(point);
    answer_.force_n *= tick.scene->events().left(reach_.deepest_mm, point.depth_mm);
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

namespace {

// The ranges of what a state holds. A model's output reaches at most 1e150; positions, ticks and strokes within their
// limits keep all other numbers far below these. The sums and products of a tick stay finite with each of them.
constexpr double kAnyN = 1e152;
constexpr double kAnyMm = 1e9;
constexpr double kAnySpeedMmS = 1e16;
constexpr double kAnyS = 1e15;
constexpr double kStiffest = fuzzy::kRendererFields[0].max;  // N/mm
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Filter, typename Take>
void takeFilter(Filter& filter, Take& take) noexcept {
  take.number(filter.first, -kAnySpeedMmS, kAnySpeedMmS);
  take.number(filter.value, -kAnySpeedMmS, kAnySpeedMmS);
}

template <typename Point, typename Take>
void takePoint(Point& point, Take& take) noexcept {
  take.number(point.depth_mm, -kAnyMm, kAnyMm);
  take.number(point.speed_mm_s, 0, kAnySpeedMmS);
}

template <typename Parameters, typename Take>
void takeParameters(Parameters& parameters, Take& take) noexcept {
  for (const fuzzy::RendererField& field : fuzzy::kRendererFields) {
    const double min = field.min_excluded ? std::nextafter(field.min, field.max) : field.min;
    take.number(parameters.*field.member, min, field.max);
  }
}

template <typename State, typename Take>
void takeState(State& state, Take& take) noexcept {
  take.whole(state.phase, static_cast<std::uint64_t>(Phase::kSlidingOut));
  take.whole(state.fault, static_cast<std::uint64_t>(Fault::kTime));
  take.number(state.time_s, 0, kAnyS);
  take.number(state.depth_mm, -kAnyMm, kAnyMm);
  take.number(state.force_n, -kAnyN, kAnyN);
  take.whole(state.stroke.number);
  take.number(state.stroke.start_s, 0, kAnyS);
  take.number(state.stroke.end_s, 0, kAnyS);
  take.number(state.stroke.start_depth_mm, -kAnyMm, kAnyMm);
  take.number(state.stroke.end_depth_mm, -kAnyMm, kAnyMm);
  takeOptional(state.position_mm, take,
               [&](auto& position_mm) { take.number(position_mm, -kFarthestMm, kFarthestMm); });
  take.number(state.stretch_mm, -kAnyMm, kAnyMm);
  take.number(state.stiffness_n_mm, 0, kStiffest);
  take.number(state.clip_n, 0, kAnyN);
  take.number(state.stiction, 0, 1);
  take.number(state.slow_s, 0, kAnyS);
  take.number(state.damping_share, 0, 1);
  takeFilter(state.speed_mm_s, take);
  takeFilter(state.slip_speed_mm_s, take);
  take.number(state.fading_n, -kAnyN, kAnyN);
  take.number(state.fading_rate_n_s, 0, kAnyN);
  take.number(state.dynamic_n, 0, kAnyN);
  take.number(state.model_n, 0, kAnyN);
  take.whole(state.any_fired, 1);
  take.whole(state.held, 1);
  takeOptional(state.asked, take, [&](auto& point) { takePoint(point, take); });
  take.whole(state.conditions);
}

}  // namespace

/// All but the number of the scene, which is another one in each process.
template <typename Self, typename Take>
void Insertion::eachMember(Self& self, Take& take) noexcept {
  take.number(self.largest_stiffness_n_mm_, std::numeric_limits<double>::denorm_min(), kInfinity);
  takeState(self.state_, take);
  takeParameters(self.settings_.friction, take);
  take.number(self.settings_.force_cap_n, 0, kInfinity);
  take.number(self.settings_.depth_end_mm, -kInfinity, kInfinity);
  take.whole(self.stiffness_limited_, 1);
  take.number(self.model_stiffness_n_mm_, std::numeric_limits<double>::denorm_min(), kStiffest);
  takeParameters(self.target_, take);
  take.number(self.difference_n_, -kAnyN, kAnyN);
  take.number(self.fade_left_s_, 0, kAnyS);
  take.whole(self.untaken_, 1);
  take.whole(self.conditions_);
  take.whole(self.unasked_, 1);
  takePoint(self.asked_, take);
  take.number(self.answer_.force_n, -kAnyN, kAnyN);
  take.whole(self.answer_.fired, 1);
  take.number(self.reach_.deepest_mm, -kAnyMm, kAnyMm);
  take.whole(self.reach_.done, fuzzy::kMostEvents);
  take.whole(self.counters_.ticks);
  take.whole(self.counters_.asked);
  take.whole(self.counters_.released);
  take.whole(self.counters_.unchanged);
}

std::size_t Insertion::savedBytes() noexcept {
  StateWriter count;
  const Insertion any;
  eachMember(any, count);
  count.whole(false, 1);
  return count.size();
}

void Insertion::save(const TubeScene& scene, std::span<std::byte> bytes) const noexcept {
  StateWriter writer(bytes);
  eachMember(*this, writer);
  writer.whole(scene_ == scene.serial(), 1);
}

bool Insertion::load(const TubeScene& scene, std::span<const std::byte> bytes) noexcept {
  StateReader reader(bytes);
  Insertion read;
  eachMember(read, reader);
  bool taken = false;
  reader.whole(taken, 1);
  if (!reader.fits() || !reader.rest().empty()) return false;
  read.scene_ = taken ? scene.serial() : 0;
  *this = read;
  return true;
}

}  // namespace tactus::render
