#include "app/simulation/hand_motion.h"

#include <algorithm>
#include <utility>

namespace tactus::simulation {
namespace {

using haptics::HandPlan;
using haptics::HandWish;
using Kind = MotionStep::Kind;

/// A step with what came before it.
struct Leg {
  double start_s = 0;
  double start_mm = 0;
  bool holds = true;
  bool button = false;
  HandPlan way;  ///< from start_mm on; empty: the hand rests

  HandWish at(double time_s) const {
    HandWish wish = way ? way(time_s - start_s) : HandWish{};
    wish.position_mm += start_mm;
    wish.holds = holds;
    wish.button = button;
    return wish;
  }
};

HandPlan wayOf(const MotionStep& step, double start_mm) {
  switch (step.kind) {
    case Kind::kStroke:
      return haptics::stroke(step.length_mm, step.duration_s);
    case Kind::kGoTo:
      return haptics::stroke(step.position_mm - start_mm, step.duration_s);
    case Kind::kPush:
      return haptics::push(step.speed_mm_s);
    case Kind::kSwing:
      return haptics::swing(step.amplitude_mm, step.frequency_hz);
    default:
      return {};
  }
}

}  // namespace

std::vector<MotionStep> spelledOut(const haptics::StrokeSeries& series) {
  std::vector<MotionStep> steps;
  for (int i = 0; i < series.count; ++i) {
    steps.push_back({.kind = Kind::kPress});
    steps.push_back({.kind = Kind::kRest, .duration_s = series.settle_s});
    steps.push_back({.kind = Kind::kStroke, .duration_s = series.forward_s, .length_mm = series.length_mm});
    steps.push_back({.kind = Kind::kRest, .duration_s = series.hold_s});
    steps.push_back({.kind = Kind::kRelease});
    steps.push_back({.kind = Kind::kStroke, .duration_s = series.back_s, .length_mm = -series.length_mm});
    steps.push_back({.kind = Kind::kRest, .duration_s = series.pause_s});
  }
  return steps;
}

double durationS(const std::vector<MotionStep>& steps) noexcept {
  double sum_s = 0;
  for (const auto& step : steps) sum_s += step.duration_s;
  return sum_s;
}

HandPlan planOf(const std::vector<MotionStep>& steps) {
  std::vector<Leg> legs(1);
  for (const auto& step : steps) {
    Leg& leg = legs.back();
    leg.way = wayOf(step, leg.start_mm);
    Leg next{.start_s = leg.start_s + step.duration_s,
             .start_mm = leg.at(leg.start_s + step.duration_s).position_mm,
             .holds = step.kind == Kind::kHold || (leg.holds && step.kind != Kind::kLetGo),
             .button = step.kind == Kind::kPress || (leg.button && step.kind != Kind::kRelease),
             .way = {}};
    legs.push_back(std::move(next));
  }
  return [legs = std::move(legs)](double time_s) {
    const auto after = std::upper_bound(legs.begin() + 1, legs.end(), time_s,
                                        [](double time, const Leg& leg) { return time < leg.start_s; });
    return std::prev(after)->at(time_s);
  };
}

}  // namespace tactus::simulation
