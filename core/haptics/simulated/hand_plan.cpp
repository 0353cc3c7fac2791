#include "core/haptics/simulated/hand_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tactus::haptics {
namespace {

/// sin(2 pi turns) to 1e-15. The math library's sine differs in its last bit between processors, and a simulation must
/// not: Taylor's series on a quarter of a turn at most, where 21st order leaves 1e-18.
double sineOfTurns(double turns) noexcept {
  double part = turns - std::nearbyint(turns);
  if (std::abs(part) > 0.25) part = std::copysign(0.5, part) - part;
  const double x = 2 * std::numbers::pi * part;
  double sum = 1;
  for (int n = 20; n > 0; n -= 2) sum = 1 - x * x / (n * (n + 1)) * sum;
  return x * sum;
}

}  // namespace

HandPlan stroke(double length_mm, double duration_s) {
  return [=](double time_s) -> HandTarget {
    const double u = std::clamp(time_s / duration_s, 0.0, 1.0);
    return {length_mm * u * u * u * (10 - 15 * u + 6 * u * u), length_mm / duration_s * 30 * u * u * (1 - u) * (1 - u)};
  };
}

HandPlan strokes(const StrokeSeries& series) {
  return [series, forward = stroke(series.length_mm, series.forward_s),
          back = stroke(series.length_mm, series.back_s)](double time_s) -> HandTarget {
    if (time_s >= series.count * series.periodS()) return {};
    const double t = std::fmod(time_s, series.periodS());
    const double released_s = series.settle_s + series.forward_s + series.hold_s;
    if (t < released_s) {
      HandTarget wish = forward(t - series.settle_s);
      wish.button = true;
      return wish;
    }
    const HandTarget way = back(t - released_s);
    return {series.length_mm - way.position_mm, -way.speed_mm_s};
  };
}

HandPlan push(double speed_mm_s) {
  return [=](double time_s) -> HandTarget { return {speed_mm_s * time_s, speed_mm_s}; };
}

HandPlan swing(double amplitude_mm, double frequency_hz) {
  const double omega = 2 * std::numbers::pi * frequency_hz;
  return [=](double time_s) -> HandTarget {
    const double turns = frequency_hz * time_s;
    return {amplitude_mm * sineOfTurns(turns), amplitude_mm * omega * sineOfTurns(turns + 0.25)};
  };
}

HandPlan both(HandPlan one, HandPlan other) {
  return [one = std::move(one), other = std::move(other)](double time_s) -> HandTarget {
    const HandTarget a = one(time_s);
    const HandTarget b = other(time_s);
    return {a.position_mm + b.position_mm, a.speed_mm_s + b.speed_mm_s, a.holds && b.holds, a.button || b.button};
  };
}

HandPlan after(double start_s, HandPlan plan) {
  return [=, plan = std::move(plan)](double time_s) -> HandTarget {
    if (time_s > start_s) return plan(time_s - start_s);
    const HandTarget first = plan(0);
    return {first.position_mm, 0, first.holds};
  };
}

HandPlan pressing(HandPlan plan, double from_s, double to_s) {
  return [=, plan = std::move(plan)](double time_s) {
    HandTarget wish = plan(time_s);
    wish.button = wish.button || (time_s >= from_s && time_s < to_s);
    return wish;
  };
}

HandPlan lettingGo(HandPlan plan, double at_s) {
  return [=, plan = std::move(plan)](double time_s) {
    HandTarget wish = plan(time_s);
    wish.holds = wish.holds && time_s < at_s;
    wish.button = wish.button && time_s < at_s;
    return wish;
  };
}

}  // namespace tactus::haptics
