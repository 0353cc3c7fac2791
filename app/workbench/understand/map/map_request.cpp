#include "app/workbench/understand/map/map_request.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/check.h"

namespace tactus::workbench {
namespace {

std::vector<double> evenly(const figures::Interval& part, std::size_t count) {
  std::vector<double> places(count);
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = std::lerp(part.low, part.high, static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return places;
}

}  // namespace

MapRequest::MapRequest(std::shared_ptr<const OpenModel> model, std::vector<double> point, const Axis& x, const Axis& y,
                       std::optional<std::size_t> expert)
    : model_(std::move(model)), point_(std::move(point)), x_(x), y_(y), expert_(expert) {
  TACTUS_CHECK(x_.input != y_.input);
  if (expert_) return;
  std::vector<std::optional<double>> fixed(point_.begin(), point_.end());
  fixed[x_.input].reset();
  fixed[y_.input].reset();
  auto scene = fuzzy::Scene::specialize(model_->compiled, fixed);
  TACTUS_CHECK(scene.has_value());
  scene_ = std::move(*scene);
}

ForceMap MapRequest::begin(std::size_t side) const {
  return {x_.input,
          y_.input,
          x_.part,
          y_.part,
          side,
          std::vector<double>(side * side),
          std::vector<std::uint8_t>(side * side)};
}

std::size_t MapRequest::compute(ForceMap& map, const std::function<bool()>& goes_on) const {
  const std::vector<double> xs = evenly(x_.part, map.side);
  const std::vector<double> ys = evenly(y_.part, map.side);
  std::vector<double> same_y(map.side);
  std::vector<double> point = point_;
  std::size_t row = 0;
  for (; row < map.side && goes_on(); ++row) {
    const std::span<double> forces = std::span(map.force_n).subspan(row * map.side, map.side);
    const std::span<std::uint8_t> fired = std::span(map.fired).subspan(row * map.side, map.side);
    if (expert_) {
      point[y_.input] = ys[row];
      for (std::size_t i = 0; i < map.side; ++i) {
        point[x_.input] = xs[i];
        const fuzzy::Evaluation here = model_->compiled.evaluateExpert(*expert_, point);
        forces[i] = here.force_n;
        fired[i] = here.fired ? 1 : 0;
      }
      continue;
    }
    std::fill(same_y.begin(), same_y.end(), ys[row]);
    // The varying inputs stand in the order of the model.
    std::array<std::span<const double>, 2> inputs = {xs, same_y};
    if (y_.input < x_.input) std::swap(inputs[0], inputs[1]);
    scene_->evaluateBatch(inputs, {forces, fired});
  }
  return row;
}

std::size_t MapRequest::forcesOfAPlace() const { return expert_ ? 1 : 1 + model_->compiled.expertCount(); }

}  // namespace tactus::workbench
