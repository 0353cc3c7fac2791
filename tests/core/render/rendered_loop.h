// The insertion renderer as the servo of a simulated loop, with a watch on what it does.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/render/insertion_renderer.h"

#include "tests/support/simulated_loop.h"

namespace tactus::render {

using ForceAt = std::function<ModelForce(const ForcePoint&)>;

/// F_d = a + b v, not below `floor_n`.
inline ForceAt linearForce(double a_n, double b_n_s_mm, double floor_n = 0) {
  return [=](const ForcePoint& point) -> ModelForce {
    return {std::max(floor_n, a_n + b_n_s_mm * point.speed_mm_s), true};
  };
}

struct RenderedLoop {
  RendererSettings settings;
  ForceAt force_at = linearForce(0.35, 0.0015);
  std::function<bool(double)> enabled = [](double) { return true; };

  RendererState state;
  int transitions = 0;     ///< between stuck and sliding
  int questions = 0;       ///< how often the model was asked
  double certificate = 0;  ///< rendered energy + k dx² / 2 so far, less k z² / 2; mJ
  double lowest_certificate = 0;

  double tick(double time_s, double position_mm, double dt_s) {
    const RendererState before = state;
    const RendererInput input{position_mm, enabled(time_s), 0, {}};
    state = stepAsking(state, input, settings, dt_s, [this](const ForcePoint& point) {
      ++questions;
      return force_at(point);
    });
    const double k = settings.friction.stiffness_n_mm;
    if (before.position_mm && before.phase != Phase::kReleased) {
      const double dx = position_mm - *before.position_mm;
      stored_ += k * before.stretch_mm * dx + k * dx * dx / 2;
    }
    certificate = stored_ - k * state.stretch_mm * state.stretch_mm / 2;
    lowest_certificate = std::min(lowest_certificate, certificate);
    const bool rubbed = before.phase != Phase::kReleased && state.phase != Phase::kReleased;
    transitions += rubbed && before.phase != state.phase ? 1 : 0;
    return state.force_n;
  }

  support::Servo servo() {
    return [this](double time_s, double position_mm, double dt_s) { return tick(time_s, position_mm, dt_s); };
  }

 private:
  double stored_ = 0;
};

}  // namespace tactus::render
