#include "core/render/tube_scene.h"

#include <array>
#include <atomic>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/check.h"

namespace tactus::render {
namespace {

std::uint64_t nextSerial() noexcept {
  static std::atomic<std::uint64_t> last{0};  // each stands for itself: relaxed
  return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

/// `1` and no unit at all say nothing about lengths and forces.
base::Result<void> checkUnit(const fuzzy::Variable& variable, std::string_view unit) {
  if (variable.unit.empty() || variable.unit == "1" || variable.unit == unit) return {};
  return base::fail(base::ErrorCode::kValue, "unit of " + base::quoted(variable.id), base::quoted(variable.unit),
                    std::string(unit) + ", which is what the insertion works in");
}

}  // namespace

base::Result<void> checkTubeUnits(const fuzzy::Variable* depth, const fuzzy::Variable* speed,
                                  const fuzzy::Variable& output) {
  if (depth != nullptr) {
    if (auto unit = checkUnit(*depth, "mm"); !unit) return unit;
  }
  if (speed != nullptr) {
    if (auto unit = checkUnit(*speed, "mm/s"); !unit) return unit;
  }
  return checkUnit(output, "N");
}

TubeScene::TubeScene(fuzzy::Scene scene, const TubeSettings& settings)
    : scene_(std::move(scene)), settings_(settings), serial_(nextSerial()) {
  const std::size_t moved = (settings_.depth ? 1U : 0U) + (settings_.speed ? 1U : 0U);
  TACTUS_CHECK(scene_.freeInputCount() == moved);
}

ModelForce TubeScene::force(const ForcePoint& point) const noexcept {
  std::array<double, 2> free_inputs{};
  if (settings_.depth) free_inputs[*settings_.depth] = point.depth_mm;
  if (settings_.speed) free_inputs[*settings_.speed] = point.speed_mm_s;
  const fuzzy::Evaluation answer = scene_.evaluate(std::span(free_inputs).first(scene_.freeInputCount()));
  return {answer.force_n, answer.fired};
}

}  // namespace tactus::render
