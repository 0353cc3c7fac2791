// A tube that a test moves by hand, with a model of constant force.
#pragma once

#include <cstdint>

#include "core/render/insertion_renderer.h"

namespace tactus::render {

/// Ticks of 1 ms. Damping is off unless a test sets it, so that forces follow by hand from the spring alone.
struct ScriptedTube {
  RendererSettings settings;
  RendererState state;
  ModelForce model{0.4, true};
  std::uint64_t conditions = 0;
  bool held = true;
  int questions = 0;
  ForcePoint last_question;
  double dt_s = 0.001;

  ScriptedTube() { settings.friction.damping_n_s_mm = 0; }

  void tick(double position_mm) {
    const RendererInput input{position_mm, held, conditions, {}};
    state = stepAsking(state, input, settings, dt_s, [this](const ForcePoint& point) {
      ++questions;
      last_question = point;
      return model;
    });
  }

  /// Evenly from where the hand is (0 before the first tick) to `position_mm`.
  void moveTo(double position_mm, int ticks) {
    const double from_mm = state.position_mm.value_or(0);
    if (!state.position_mm) tick(from_mm);
    for (int i = 1; i <= ticks; ++i) tick(from_mm + (position_mm - from_mm) * i / ticks);
  }
};

}  // namespace tactus::render
