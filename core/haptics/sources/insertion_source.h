// The insertion as a source of force: the renderer on a scene, with a hand-over that the hand never feels as a kick.
#pragma once

#include <cstdint>

#include "core/haptics/sources/servo_scene.h"
#include "core/render/insertion_renderer.h"

namespace tactus::haptics {

/// How much inference the scene needed; what was not needed was not computed.
struct SceneCounters {
  std::uint64_t ticks = 0;      ///< with the insertion as source
  std::uint64_t asked = 0;      ///< of these, the model was evaluated
  std::uint64_t released = 0;   ///< skipped: the hand did not hold the tube
  std::uint64_t unchanged = 0;  ///< skipped: neither point nor conditions had changed

  bool operator==(const SceneCounters&) const = default;
};

/// One tick of the insertion.
struct InsertionTick {
  bool active = false;                ///< the insertion is the source; otherwise it lets go
  bool enabled = false;               ///< the hand holds the device
  double position_mm = 0;             ///< along the insertion axis
  double force_cap_n = 2.0;           ///< the tube slips rather than resist more
  const ServoScene* scene = nullptr;  ///< may be null: no force. Read during the tick only
  double dt_s = 0.001;                ///< since the last tick
};

/// The tube of one placement after another. Call it at every tick, active or not: it follows the hand, and a force that
/// it still has when it lets go is gone within render::kReleaseFadeS.
///
/// Hand-over: another scene is in force at once, and the difference that it makes to F_d fades out linearly over the
/// scene's fade; the renderer's parameters go from old to new over the same time. Both act inside the friction, whose
/// energy certificate holds for every F_d >= 0 and every parameter: no hand-over feeds energy to the hand, and none
/// leaves a force behind after a release. A fade that runs is continued by the next hand-over and never shortened.
/// All state is plain, copyable data. Thread: servo. Real-time safe: yes.
class InsertionSource {
 public:
  /// `largest_stiffness_n_mm` > 0: a stiffer model is rendered with this.
  explicit InsertionSource(double largest_stiffness_n_mm) noexcept : largest_stiffness_n_mm_(largest_stiffness_n_mm) {}

  /// Another placement: the tube is out, at `start_depth_mm`; strokes count from 1.
  void place(double start_depth_mm) noexcept;
  /// The next position is no motion of the hand: it is measured along another axis.
  void forgetPosition() noexcept { state_.position_mm.reset(); }

  /// The resistance, N.
  double tick(const InsertionTick& tick) noexcept;

  const render::RendererState& state() const noexcept { return state_; }
  /// What is rendered now, in the middle of a hand-over too.
  const fuzzy::RendererParameters& rendered() const noexcept { return settings_.friction; }
  /// The scene's spring is stiffer than what is rendered.
  bool stiffnessLimited() const noexcept { return stiffness_limited_; }
  const SceneCounters& counters() const noexcept { return counters_; }

 private:
  void takeScene(const ServoScene* scene) noexcept;
  void fade(double dt_s) noexcept;
  render::ModelForce answer(const render::ForcePoint& point, const ServoScene& scene) noexcept;

  double largest_stiffness_n_mm_;
  render::RendererState state_;
  render::RendererSettings settings_;  ///< as rendered
  std::uint64_t scene_ = 0;            ///< serial number of the scene in use, to see whether another one comes; 0: none
  bool stiffness_limited_ = false;

  fuzzy::RendererParameters target_;  ///< where the rendered parameters go
  double difference_n_ = 0;           ///< F_d in use less that of the scene
  double fade_left_s_ = 0;
  bool untaken_ = false;  ///< another scene is in force, and no rule of it has fired yet: there is no difference so far

  std::uint64_t conditions_ = 0;  ///< another number whenever the renderer has to take an answer
  bool unasked_ = true;           ///< the scene has not been asked since it came
  render::ForcePoint asked_;
  render::ModelForce answer_;  ///< of the scene at `asked_`
  SceneCounters counters_;
};

}  // namespace tactus::haptics
