#include "core/render/friction.h"

#include <algorithm>
#include <cmath>

#include "core/render/insertion_renderer.h"
#include "core/render/low_pass.h"

namespace tactus::render {

namespace {

bool sliding(Phase phase) noexcept { return phase == Phase::kSlidingIn || phase == Phase::kSlidingOut; }

/// +1 for in, -1 for out.
double sign(Phase direction) noexcept { return direction == Phase::kSlidingOut ? -1 : 1; }

class Friction {
 public:
  Friction(RendererState& state, const RendererSettings& settings, double dt_s) noexcept
      : state_(state),
        parameters_(settings.friction),
        cap_n_(settings.force_cap_n),
        deepest_mm_(settings.depth_end_mm - settings.friction.depth_offset_mm),
        dt_s_(dt_s) {}

  void move(double moved_mm) noexcept {
    takeStiffness();
    const double stretch_before_mm = state_.stretch_mm;
    state_.stretch_mm += moved_mm;
    if (state_.phase == Phase::kStuck) {
      state_.stiction = 1 - (1 - state_.stiction) * decay(dt_s_, parameters_.ageing_s);
      breakAway(stretch_before_mm);
    }
    if (sliding(state_.phase)) {
      const double target_n = limit(state_.phase, 0);
      state_.clip_n = target_n + (state_.clip_n - target_n) * decay(dt_s_, parameters_.relaxation_s);
      slip();
      // A long way back within one tick: stuck again, and at once away in the other direction.
      if (state_.phase == Phase::kStuck) breakAway(stretch_before_mm);
      if (sliding(state_.phase)) slip();
      if (sliding(state_.phase)) stickWhenSlow();
    }
    const bool stuck = state_.phase == Phase::kStuck;
    const double share = stuck ? 1 : 0;
    state_.damping_share =
        share + (state_.damping_share - share) * decay(dt_s_, stuck ? kDampingFadeInS : kDampingFadeOutS);
    if (std::abs(state_.stretch_mm) < kSmallest) state_.stretch_mm = 0;
    if (state_.damping_share < kSmallest) state_.damping_share = 0;
  }

 private:
  /// The friction in one direction, with `share` of the break-away surplus.
  double limit(Phase direction, double share) const noexcept {
    const double ratio = direction == Phase::kSlidingOut ? parameters_.withdrawal_ratio : 1;
    return std::min(cap_n_, (1 + share * parameters_.breakaway_ratio) * ratio * state_.dynamic_n);
  }

  /// How hard the spring pushes in a direction.
  double spring(Phase direction, double stretch_mm) const noexcept {
    return sign(direction) * parameters_.stiffness_n_mm * stretch_mm;
  }

  /// Whether the tube cannot go further in that direction: at its end inwards, out of the body outwards.
  bool blocked(Phase direction) const noexcept {
    return direction == Phase::kSlidingIn ? state_.depth_mm >= deepest_mm_ : state_.depth_mm <= 0;
  }

  /// Only a smaller stretch keeps the energy: a softer spring keeps its stretch, a stiffer one its force.
  void takeStiffness() noexcept {
    if (state_.stiffness_n_mm > 0 && parameters_.stiffness_n_mm > state_.stiffness_n_mm)
      state_.stretch_mm *= state_.stiffness_n_mm / parameters_.stiffness_n_mm;
    state_.stiffness_n_mm = parameters_.stiffness_n_mm;
  }

  void stick() noexcept {
    state_.phase = Phase::kStuck;
    state_.stiction = 0;
    state_.slow_s = 0;
  }

  void breakAway(double stretch_before_mm) noexcept {
    for (const Phase direction : {Phase::kSlidingIn, Phase::kSlidingOut}) {
      // Where friction fell below the spring's force without motion, the clip starts at that force: no step.
      const double before_n = std::min(cap_n_, spring(direction, stretch_before_mm));
      if (blocked(direction)) {
        hold(direction, before_n);
        continue;
      }
      const double most_n = limit(direction, state_.stiction);
      if (!(spring(direction, state_.stretch_mm) > most_n)) continue;
      state_.phase = direction;
      state_.slow_s = 0;
      state_.clip_n = std::max(most_n, before_n);
      return;
    }
  }

  /// A tube that cannot go further gives way uncounted: at its end at the friction there, at the entry without any.
  void hold(Phase direction, double before_n) noexcept {
    const bool out = direction == Phase::kSlidingOut;
    const double rest_n = out ? 0 : limit(direction, state_.stiction);
    const double surplus_n = std::max(0.0, before_n - rest_n);
    const double most_n = rest_n + surplus_n * decay(dt_s_, out ? kTubeOutS : parameters_.relaxation_s);
    if (spring(direction, state_.stretch_mm) > most_n)
      state_.stretch_mm = sign(direction) * most_n / parameters_.stiffness_n_mm;
  }

  void slip() noexcept {
    const Phase direction = state_.phase;
    const double pull_n = spring(direction, state_.stretch_mm);
    if (pull_n > state_.clip_n) {
      const double clipped_mm = sign(direction) * state_.clip_n / parameters_.stiffness_n_mm;
      const double depth_mm = state_.depth_mm + (state_.stretch_mm - clipped_mm);
      state_.stretch_mm = clipped_mm;
      state_.depth_mm = direction == Phase::kSlidingIn ? std::min(depth_mm, std::max(state_.depth_mm, deepest_mm_))
                                                       : std::max(depth_mm, std::min(state_.depth_mm, 0.0));
      if (blocked(direction)) stick();
      return;
    }
    // Friction the other way ends a slide too, however long the way back to sticking is.
    const Phase back = direction == Phase::kSlidingIn ? Phase::kSlidingOut : Phase::kSlidingIn;
    const double back_n = blocked(back) ? 0 : limit(back, 0);
    if (pull_n < std::max(state_.clip_n - parameters_.stiffness_n_mm * parameters_.restick_mm, -back_n)) stick();
  }

  void stickWhenSlow() noexcept {
    const bool slow = std::abs(state_.slip_speed_mm_s.value) < parameters_.stick_speed_mm_s;
    state_.slow_s = slow ? state_.slow_s + dt_s_ : 0;
    if (slow && state_.slow_s >= parameters_.stick_time_s) stick();
  }

  RendererState& state_;
  const fuzzy::RendererParameters& parameters_;
  double cap_n_;
  double deepest_mm_;
  double dt_s_;
};

}  // namespace

void rub(RendererState& state, double moved_mm, const RendererSettings& settings, double dt_s) noexcept {
  Friction(state, settings, dt_s).move(moved_mm);
}

double printedStaticFriction(double stiffness_n_mm, double displacement_mm, double damping_n_s_mm,
                             double speed_mm_s) noexcept {
  return stiffness_n_mm * displacement_mm - damping_n_s_mm * speed_mm_s;
}

}  // namespace tactus::render
