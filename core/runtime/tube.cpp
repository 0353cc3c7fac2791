// The tube of the C interface: the insertion as the servo renders it, without a device and its limits.
#include <algorithm>
#include <cmath>
#include <memory>

#include "core/runtime/handles.h"
#include "core/runtime/message.h"

namespace tactus::runtime {
namespace {

constexpr double kUsualFadeS = 0.05;
constexpr double kLongestFadeS = 60;

int phaseOf(render::Phase phase) noexcept {
  switch (phase) {
    case render::Phase::kReleased: return 0;
    case render::Phase::kStuck: return 1;
    default: return 2;
  }
}

/// The members of interface 1, behind `size`.
void fill(tactus_feel& feel, const render::RendererState& state) noexcept {
  const bool engaged = state.phase != render::Phase::kReleased;
  feel.force_n = state.force_n;
  feel.depth_mm = state.depth_mm;
  feel.speed_mm_s = state.speed_mm_s.value;
  feel.slip_speed_mm_s = state.slip_speed_mm_s.value;
  feel.stretch_mm = state.stretch_mm;
  feel.model_force_n = engaged ? state.dynamic_n : 0;
  feel.phase = phaseOf(state.phase);
  feel.held_last = engaged && state.held ? 1 : 0;
  feel.stroke = state.stroke.number;
}

}  // namespace
}  // namespace tactus::runtime

using namespace tactus;  // NOLINT(google-build-using-namespace): the functions below are outside all namespaces
using namespace tactus::runtime;  // NOLINT(google-build-using-namespace)

tactus_status tactus_tube_make(const tactus_scene* scene, tactus_tube** tube, char* message, size_t message_size) {
  Message said(message, message_size);
  if (tube == nullptr) return said.fail(TACTUS_BAD_ARGUMENT, "tube: found a null pointer, wanted a place for the tube");
  *tube = nullptr;
  if (scene == nullptr) return said.fail(TACTUS_BAD_ARGUMENT, "scene: found a null pointer, wanted a scene");
  if (!scene->tube) return said.fail(TACTUS_BAD_ARGUMENT, scene->no_tube);
  return guarded(said, [&] {
    *tube = new tactus_tube{render::Insertion(), scene->tube, 0};
    return TACTUS_OK;
  });
}

void tactus_tube_free(tactus_tube* tube) { delete tube; }

void tactus_tube_place(tactus_tube* tube, double depth_mm) {
  if (tube != nullptr && std::abs(depth_mm) <= render::kFarthestMm) tube->insertion.place(depth_mm);
}

void tactus_tube_scene(tactus_tube* tube, const tactus_scene* scene, double fade_s) {
  if (tube == nullptr || scene == nullptr || !scene->tube) return;
  tube->scene = scene->tube;
  tube->fade_s = std::isnan(fade_s) ? kUsualFadeS : std::clamp(fade_s, 0.0, kLongestFadeS);
}

tactus_status tactus_tube_step(tactus_tube* tube, double position_mm, int held, double dt_s, tactus_feel* feel) {
  if (tube == nullptr || feel == nullptr || feel->size < sizeof(tactus_feel)) return TACTUS_BAD_ARGUMENT;
  render::InsertionTick tick;
  tick.active = true;
  tick.enabled = held != 0;
  tick.position_mm = position_mm;
  tick.scene = tube->scene.get();
  tick.fade_s = tube->fade_s;
  tick.dt_s = dt_s;
  tube->insertion.tick(tick);
  fill(*feel, tube->insertion.state());
  const bool position = std::abs(position_mm) <= render::kFarthestMm;
  const bool time = dt_s >= render::kShortestTickS && dt_s <= render::kLongestTickS;
  return position && time ? TACTUS_OK : TACTUS_BAD_ARGUMENT;
}
