// A tube that a test pushes through scenes, one tick of 1 ms after the other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/render/insertion.h"

#include "tests/core/haptics/scenes.h"

namespace tactus::render {

/// Largest step of a force in a tick (facts of the closed loop: docs/renderer.md).
inline constexpr double kCalmStepN = 0.03;
inline constexpr double kRounding = 1e-12;  ///< of a few hundred additions of numbers near 1
inline constexpr int kFadeTicks = 50;

inline fuzzy::RendererParameters undamped(double stiffness_n_mm = 0.25) {
  fuzzy::RendererParameters renderer;
  renderer.damping_n_s_mm = 0;
  renderer.stiffness_n_mm = stiffness_n_mm;
  return renderer;
}

struct PushedTube {
  Insertion source{1e3};  ///< no device limits the spring
  InsertionTick tick;
  double force_n = 0;
  double largest_step_n = 0;

  explicit PushedTube(haptics::ScenePointer first) {
    take(std::move(first));
    tick.active = tick.enabled = true;
  }

  void take(haptics::ScenePointer next) {
    scenes_.push_back(std::move(next));  // as the mailbox does, the old one stays until the servo has seen the new one
    tick.scene = scenes_.back().get();
    tick.fade_s = scenes_.back()->fadeS();
    if (scenes_.size() > 2) scenes_.erase(scenes_.begin());
  }

  void step() {
    const double before_n = force_n;
    force_n = source.tick(tick);
    largest_step_n = std::max(largest_step_n, std::abs(force_n - before_n));
  }

  void moveBy(double way_mm, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick.position_mm += way_mm / ticks;
      step();
    }
  }
  void rest(int ticks) { moveBy(0, ticks); }
  std::uint64_t asked() const { return source.counters().asked; }
  double dynamicN() const { return source.state().dynamic_n; }

 private:
  std::vector<haptics::ScenePointer> scenes_;
};

}  // namespace tactus::render
