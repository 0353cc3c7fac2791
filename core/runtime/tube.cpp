// The tube of the C interface: the insertion as the servo renders it, without a device and its limits.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>

#include "core/base/files/checksums.h"
#include "core/render/renderer_state.h"
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

/// The strongest term of the depth at the tip of the tube; the first of several; -1: none.
int regionAt(const FeltScene& felt, double tube_depth_mm) noexcept {
  const double depth_mm =
      std::clamp(tube_depth_mm + felt.scene.renderer().depth_offset_mm, felt.depth_min_mm, felt.depth_max_mm);
  int strongest = -1;
  double most = 0;
  for (std::size_t t = 0; t < felt.regions.size(); ++t) {
    const double membership = felt.regions[t](depth_mm);
    if (membership <= most) continue;
    most = membership;
    strongest = static_cast<int>(t);
  }
  return strongest;
}

/// Whether the spring is softer than the model's, or the force is held at its cap. A slipping spring is at the cap but
/// for rounding.
bool isLimited(const tactus_tube& tube) noexcept {
  constexpr double kRounding = 1e-9;
  const render::RendererState& state = tube.insertion.state();
  return state.phase != render::Phase::kReleased &&
         (tube.insertion.stiffnessLimited() || std::abs(state.force_n) >= tube.force_cap_n * (1 - kRounding));
}

/// The size of tactus_feel in interface 1, which ended with `stroke`.
constexpr std::size_t kFirstFeelSize =
    (offsetof(tactus_feel, stroke) + sizeof(tactus_feel::stroke) + alignof(tactus_feel) - 1) / alignof(tactus_feel) *
    alignof(tactus_feel);

/// The members behind `size`, as many as the caller knows.
void fill(tactus_feel& feel, const tactus_tube& tube) noexcept {
  const render::RendererState& state = tube.insertion.state();
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
  // Both came with interface 2.
  if (feel.size < offsetof(tactus_feel, region) + sizeof(tactus_feel::region)) return;
  feel.limited = isLimited(tube) ? 1 : 0;
  feel.region = regionAt(*tube.scene, state.depth_mm);
}

// A saved tube: the head, the identity of the scene, what the caller set, the insertion, and a checksum of all that.

// The last character is the version. Written as a number, so that a machine with another order of bytes refuses it.
constexpr std::uint64_t kHead = 0x5441435455424532;  // TACTUBE2
constexpr std::size_t kIdentity = 64;                // hexadecimal digits

using Head = std::array<std::uint64_t, 1 + kIdentity / 8>;

Head headOf(const FeltScene& felt) noexcept {
  Head head{kHead};
  std::memcpy(head.data() + 1, felt.identity.data(), kIdentity);
  return head;
}

template <typename Tube, typename Take>
void takeSettings(Tube& tube, Take& take) noexcept {
  take.number(tube.fade_s, 0, kLongestFadeS);
  take.number(tube.stiffness_max_n_mm, std::numeric_limits<double>::denorm_min(),
              std::numeric_limits<double>::infinity());
  take.number(tube.force_cap_n, std::numeric_limits<double>::denorm_min(), tactus_tube::kMostForceN);
}

constexpr std::size_t kSettings = 3 * sizeof(double);
constexpr std::size_t kChecksum = sizeof(std::uint64_t);

std::size_t savedBytes() noexcept { return sizeof(Head) + kSettings + render::Insertion::savedBytes() + kChecksum; }

std::uint64_t checksumOf(std::span<const std::byte> bytes) noexcept {
  return base::crc32({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool isLimit(double value) noexcept { return std::isfinite(value) && value >= 0; }

void applyStiffness(tactus_tube& tube) noexcept { tube.insertion.limitStiffness(tube.stiffness_max_n_mm, kUsualFadeS); }

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
    *tube = new tactus_tube{render::Insertion(), scene->tube};
    return TACTUS_OK;
  });
}

void tactus_tube_free(tactus_tube* tube) { delete tube; }

void tactus_tube_place(tactus_tube* tube, double depth_mm) {
  if (tube == nullptr || !(std::abs(depth_mm) <= render::kFarthestMm)) return;
  const render::TubeScene& scene = tube->scene->scene;
  tube->insertion.place(std::min(depth_mm, scene.depthEndMm() - scene.renderer().depth_offset_mm));
}

void tactus_tube_scene(tactus_tube* tube, const tactus_scene* scene, double fade_s) {
  if (tube == nullptr || scene == nullptr || !scene->tube) return;
  tube->scene = scene->tube;
  tube->fade_s = std::isnan(fade_s) ? kUsualFadeS : std::clamp(fade_s, 0.0, kLongestFadeS);
}

tactus_status tactus_tube_limits(tactus_tube* tube, const tactus_limits* limits) {
  if (tube == nullptr || limits == nullptr || limits->size < sizeof(tactus_limits) ||
      !isLimit(limits->stiffness_max_n_mm) || !isLimit(limits->force_cap_n))
    return TACTUS_BAD_ARGUMENT;
  tube->stiffness_max_n_mm =
      limits->stiffness_max_n_mm > 0 ? limits->stiffness_max_n_mm : std::numeric_limits<double>::infinity();
  tube->force_cap_n =
      limits->force_cap_n > 0 ? std::min(limits->force_cap_n, tactus_tube::kMostForceN) : tactus_tube::kMostForceN;
  applyStiffness(*tube);
  return TACTUS_OK;
}

tactus_status tactus_tube_step(tactus_tube* tube, double position_mm, int held, double dt_s, tactus_feel* feel) {
  if (tube == nullptr || feel == nullptr || feel->size < kFirstFeelSize) return TACTUS_BAD_ARGUMENT;
  render::InsertionTick tick;
  tick.active = true;
  tick.enabled = held != 0;
  tick.position_mm = position_mm;
  tick.force_cap_n = tube->force_cap_n;
  tick.scene = &tube->scene->scene;
  tick.fade_s = tube->fade_s;
  tick.dt_s = dt_s;
  tube->insertion.tick(tick);
  fill(*feel, *tube);
  const bool position = std::abs(position_mm) <= render::kFarthestMm;
  const bool time = dt_s >= render::kShortestTickS && dt_s <= render::kLongestTickS;
  return position && time ? TACTUS_OK : TACTUS_BAD_ARGUMENT;
}

tactus_status tactus_tube_copy(const tactus_tube* tube, tactus_tube** copy) {
  if (copy == nullptr) return TACTUS_BAD_ARGUMENT;
  *copy = nullptr;
  if (tube == nullptr) return TACTUS_BAD_ARGUMENT;
  Message unsaid(nullptr, 0);
  return guarded(unsaid, [&] {
    *copy = new tactus_tube(*tube);
    return TACTUS_OK;
  });
}

size_t tactus_tube_save(const tactus_tube* tube, void* bytes, size_t size) {
  if (tube == nullptr) return 0;
  const std::size_t needed = savedBytes();
  if (bytes == nullptr || size < needed) return needed;
  const std::span<std::byte> all(static_cast<std::byte*>(bytes), needed);
  const Head head = headOf(*tube->scene);
  std::memcpy(all.data(), head.data(), sizeof head);
  const auto settings = all.subspan(sizeof head, kSettings);
  render::StateWriter writer(settings);
  takeSettings(*tube, writer);
  const auto insertion = all.subspan(sizeof head + kSettings, render::Insertion::savedBytes());
  tube->insertion.save(tube->scene->scene, insertion);
  const std::uint64_t checksum = checksumOf(all.first(needed - kChecksum));
  std::memcpy(all.data() + needed - kChecksum, &checksum, kChecksum);
  return needed;
}

tactus_status tactus_tube_load(tactus_tube* tube, const void* bytes, size_t size) {
  if (tube == nullptr || bytes == nullptr || size != savedBytes()) return TACTUS_BAD_ARGUMENT;
  const std::span<const std::byte> all(static_cast<const std::byte*>(bytes), size);
  const Head head = headOf(*tube->scene);
  const std::uint64_t checksum = checksumOf(all.first(size - kChecksum));
  if (std::memcmp(all.data(), head.data(), sizeof head) != 0 ||
      std::memcmp(all.data() + size - kChecksum, &checksum, kChecksum) != 0)
    return TACTUS_BAD_ARGUMENT;
  struct {
    double fade_s, stiffness_max_n_mm, force_cap_n;
  } settings{};
  render::StateReader reader(all.subspan(sizeof head, kSettings));
  takeSettings(settings, reader);
  if (!reader.fits()) return TACTUS_BAD_ARGUMENT;
  const auto insertion = all.subspan(sizeof head + kSettings, render::Insertion::savedBytes());
  if (!tube->insertion.load(tube->scene->scene, insertion)) return TACTUS_BAD_ARGUMENT;
  tube->fade_s = settings.fade_s;
  tube->force_cap_n = std::min(tube->force_cap_n, settings.force_cap_n);
  const bool stricter = tube->stiffness_max_n_mm < settings.stiffness_max_n_mm;
  if (!stricter) tube->stiffness_max_n_mm = settings.stiffness_max_n_mm;
  if (stricter) applyStiffness(*tube);
  return TACTUS_OK;
}
