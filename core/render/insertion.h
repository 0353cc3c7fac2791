// The insertion: the renderer with a scene. A change of scene never causes a kick in the hand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "core/render/insertion_renderer.h"
#include "core/render/tube_events.h"
#include "core/render/tube_scene.h"

namespace tactus::render {

/// Counts of evaluated and skipped inferences.
struct SceneCounters {
  std::uint64_t ticks = 0;      ///< with the insertion as source
  std::uint64_t asked = 0;      ///< ticks with an evaluation of the model
  std::uint64_t released = 0;   ///< skipped: the hand did not hold the tube
  std::uint64_t unchanged = 0;  ///< skipped: neither point nor conditions had changed

  bool operator==(const SceneCounters&) const = default;
};

/// One tick of the insertion.
struct InsertionTick {
  bool active = false;               ///< the insertion gives the force; otherwise it releases its force
  bool enabled = false;              ///< the hand holds the tube
  double position_mm = 0;            ///< along the insertion axis
  double force_cap_n = 2.0;          ///< the tube slips at this resistance
  const TubeScene* scene = nullptr;  ///< null: no force. Used during the tick only
  double fade_s = 0.05;              ///< of the scene: the time in which its difference to the last scene fades
  double dt_s = 0.001;               ///< since the last tick
};

/// The tube, in one placement after another. Call `tick` at every tick, active or not, because the insertion follows
/// the hand. After a release the remaining force fades within kReleaseFadeS.
///
/// Change of scene: the new scene takes effect at once. The difference that it makes to F_d fades out linearly over the
/// tick's `fade_s`; the renderer's parameters move from old to new over the same time. Both act inside the friction,
/// whose energy certificate holds for every F_d >= 0 and every parameter. So no change of scene feeds energy to the
/// hand, and none leaves a force behind after a release. A second change during a fade continues the fade and never
/// shortens it.
///
/// Events of the scene: what the tip has passed in the stroke takes its share of the model's answer (TubeEvents). So
/// F_d follows as after any other answer, and the certificate holds. All state is plain, copyable data. Thread: one at
/// a time (the servo). Real-time safe: yes.
class Insertion {
 public:
  /// `largest_stiffness_n_mm`: > 0. A stiffer model is rendered with this stiffness.
  explicit Insertion(double largest_stiffness_n_mm = std::numeric_limits<double>::infinity()) noexcept
      : largest_stiffness_n_mm_(largest_stiffness_n_mm) {}

  /// Starts a new placement: the tube is out, at `start_depth_mm`; strokes count from 1.
  void place(double start_depth_mm) noexcept;
  /// Renders no stiffer spring than `largest_stiffness_n_mm` (> 0) from now on. In a hand, the spring changes as after
  /// a change of scene, over `fade_s`.
  void limitStiffness(double largest_stiffness_n_mm, double fade_s) noexcept;
  /// The next position is not a motion of the hand, because it is measured along another axis.
  void forgetPosition() noexcept { state_.position_mm.reset(); }

  /// The resistance, N.
  double tick(const InsertionTick& tick) noexcept;

  const RendererState& state() const noexcept { return state_; }
  /// The parameters rendered now, also during a fade.
  const fuzzy::RendererParameters& rendered() const noexcept { return settings_.friction; }
  /// Whether the scene's spring is stiffer than the rendered one.
  bool stiffnessLimited() const noexcept { return stiffness_limited_; }
  const SceneCounters& counters() const noexcept { return counters_; }

  // The state as bytes, for a replay from the middle. They hold for `scene`, the one of the next tick, and for a copy
  // of it in another process: every tick after `load` has the bits of the tick after `save`.

  static std::size_t savedBytes() noexcept;
  /// `bytes`: savedBytes() of them.
  void save(const TubeScene& scene, std::span<std::byte> bytes) const noexcept;
  /// Any bytes may come: a state that `save` cannot have written, or that could make a number infinite, changes nothing
  /// and gives false.
  bool load(const TubeScene& scene, std::span<const std::byte> bytes) noexcept;

 private:
  template <typename Self, typename Take>
  static void eachMember(Self& self, Take& take) noexcept;
  void takeScene(const TubeScene* scene, double fade_s) noexcept;
  void fade(double dt_s) noexcept;
  void takeEvents(const TubeScene* scene) noexcept;
  ModelForce answer(const ForcePoint& point, const InsertionTick& tick) noexcept;

  double largest_stiffness_n_mm_;
  RendererState state_;
  RendererSettings settings_;  ///< as rendered
  std::uint64_t scene_ = 0;    ///< serial number of the scene in use, to detect a new one; 0: none
  bool stiffness_limited_ = false;
  double model_stiffness_n_mm_ = fuzzy::RendererParameters{}.stiffness_n_mm;  ///< as the scene has it

  fuzzy::RendererParameters target_;  ///< the values that the rendered parameters move to
  double difference_n_ = 0;           ///< F_d in use minus F_d of the scene
  double fade_left_s_ = 0;
  bool untaken_ = false;  ///< no rule of the new scene has fired yet, so the difference is not known

  std::uint64_t conditions_ = 0;  ///< changes if the renderer has to take a new answer
  bool unasked_ = true;           ///< the new scene has not been evaluated yet
  ForcePoint asked_;
  ModelForce answer_;  ///< of the scene at `asked_`, with its events
  StrokeReach reach_;
  SceneCounters counters_;
};

}  // namespace tactus::render
