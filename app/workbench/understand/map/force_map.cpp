#include "app/workbench/understand/map/force_map.h"

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

constexpr double kNsPerMs = 1e6;

// What else runs on the machine does not count.
double threadCpuNs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

}  // namespace

ForceMapController::ForceMapController(const SceneController& scene, QObject* parent) : QObject(parent), scene_(scene) {
  connect(&scene_, &SceneController::modelChanged, this, &ForceMapController::adoptModel);
  connect(&scene_, &SceneController::modelEdited, this, [this] {
    stale_ = true;
    here_.reset();
  });
  connect(&scene_, &SceneController::valueChanged, this, &ForceMapController::dropPoint);
  connect(&scene_.ranges(), &ShownRanges::changed, this, &ForceMapController::dropPart);
  connect(&scene_, &SceneController::presetApplied, this, &ForceMapController::applyPreset);
  if (scene_.model()) adoptModel();
}

const fuzzy::Evaluation& ForceMapController::forceAtPoint() const {
  if (here_) return *here_;
  const OpenModel& open = *scene_.model();
  std::vector<double> point;
  for (std::size_t i = 0; i < open.model.inputs.size(); ++i) point.push_back(scene_.value(i));
  scene_.countEvaluations(1);
  here_ = expert_ ? open.compiled.evaluateExpert(*expert_, point) : open.compiled.evaluate(point);
  return *here_;
}

QString ForceMapController::pointText() const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const fuzzy::Variable& x = model.inputs[x_input_];
  const fuzzy::Variable& y = model.inputs[y_input_];
  const fuzzy::Evaluation& here = forceAtPoint();
  return QStringLiteral("%1, %2   %3")
      .arg(placeText(x, scene_.value(x_input_)), placeText(y, scene_.value(y_input_)),
           here.fired ? forceText(here.force_n, model.output.unit) : tr("no rule fires"));
}

void ForceMapController::removeViewer() {
  TACTUS_CHECK(viewers_ > 0);
  if (--viewers_ > 0 || isFinest()) return;
  stop();
  stale_ = true;
}

void ForceMapController::setAxes(std::size_t x_input, std::size_t y_input) {
  if (x_input == y_input) {
    // The input that was chosen a second time leaves its old axis to the other one.
    if (x_input == x_input_) {
      x_input = y_input_;
    } else {
      y_input = x_input_;
    }
  }
  if (x_input == x_input_ && y_input == y_input_) return;
  stop();
  x_input_ = x_input;
  y_input_ = y_input;
  x_id_ = scene_.model()->model.inputs[x_input].id;
  y_id_ = scene_.model()->model.inputs[y_input].id;
  map_.reset();
  stale_ = true;
  emit choiceChanged();
}

void ForceMapController::setExpert(std::optional<std::size_t> expert) {
  if (expert == expert_) return;
  stop();
  place_ns_ = 0;
  expert_ = expert;
  expert_id_ = expert ? scene_.model()->model.experts[*expert].id : std::string();
  map_.reset();
  here_.reset();
  stale_ = true;
  emit choiceChanged();
}

void ForceMapController::applyPreset(const FigurePreset& preset) {
  const auto x = inputNamed(scene_.model()->model, preset.map_x);
  const auto y = inputNamed(scene_.model()->model, preset.map_y);
  if (!x || !y) return;
  setExpert(std::nullopt);
  setAxes(*x, *y);
}

void ForceMapController::update() {
  if (!stale_ || !scene_.model() || x_input_ == y_input_) return;
  stale_ = false;
  stop();
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  const auto axis = [&](std::size_t input) { return MapRequest::Axis{input, scene_.ranges().of(inputs[input])}; };
  request_ =
      std::make_shared<const MapRequest>(scene_.shared(), scene_.values(), axis(x_input_), axis(y_input_), expert_);
  level_ = 0;
  const double until_ns = threadCpuNs() + kSliceMs * kNsPerMs;
  const auto in_slice = [until_ns] { return threadCpuNs() < until_ns; };
  bool computed = false;
  if (place_ns_ == 0) computed = computeNow(0, in_slice);
  // Only what will be finished is begun.
  const double rest_ms = (until_ns - threadCpuNs()) / kNsPerMs;
  if (const auto level = finestWithin(rest_ms); level && *level >= level_) {
    computed = computeNow(*level, [] { return true; }) || computed;
  }
  if (!isFinest()) computeBehind();
  if (computed) emit mapChanged();
}

void ForceMapController::dropPoint(std::size_t input) {
  here_.reset();
  if (input != x_input_ && input != y_input_) stale_ = true;
}

void ForceMapController::dropPart(const std::string& input_id) {
  if (!scene_.model()) return;
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  if (input_id == inputs[x_input_].id || input_id == inputs[y_input_].id) stale_ = true;
}

void ForceMapController::finish() {
  update();
  if (isFinest()) return;
  worker_.drop();
  computeNow(kSides.size() - 1, [] { return true; });
  emit mapChanged();
}

std::optional<std::size_t> ForceMapController::finestWithin(double ms) const {
  std::optional<std::size_t> level;
  if (place_ns_ == 0) return level;
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (static_cast<double>(kSides[i] * kSides[i]) * place_ns_ <= ms * kNsPerMs) level = i;
  }
  return level;
}

bool ForceMapController::computeNow(std::size_t level, const std::function<bool()>& goes_on) {
  const double begun_ns = threadCpuNs();
  ForceMap map = request_->begin(kSides[level]);
  if (request_->compute(map, goes_on) < map.side) return false;
  take(std::move(map), level, threadCpuNs() - begun_ns);
  return true;
}

void ForceMapController::computeBehind() {
  const std::size_t level = std::max(level_, finestWithin(kStepMs).value_or(0));
  worker_.run([this, level, request = request_](const std::stop_token& stop) -> Background::Deliver {
    const double begun_ns = threadCpuNs();
    auto map = std::make_shared<ForceMap>(request->begin(kSides[level]));
    if (request->compute(*map, [&stop] { return !stop.stop_requested(); }) < map->side) return {};
    const double cpu_ns = threadCpuNs() - begun_ns;
    return [this, level, cpu_ns, map = std::move(map)] {
      take(std::move(*map), level, cpu_ns);
      if (!isFinest()) computeBehind();
      emit mapChanged();
    };
  });
}

void ForceMapController::take(ForceMap map, std::size_t level, double cpu_ns) {
  const std::size_t places = map.side * map.side;
  place_ns_ = cpu_ns / static_cast<double>(places);
  scene_.countEvaluations(places * request_->forcesOfAPlace());
  map_ = std::move(map);
  level_ = level + 1;
}

void ForceMapController::stop() {
  worker_.drop();
  level_ = kSides.size();
}

void ForceMapController::adoptModel() {
  stop();
  place_ns_ = 0;
  map_.reset();
  here_.reset();
  stale_ = true;
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto x_chosen = inputNamed(model, x_id_);
  const auto y_chosen = inputNamed(model, y_id_);
  if (x_chosen && y_chosen) {
    x_input_ = *x_chosen;
    y_input_ = *y_chosen;
  } else {
    // Depth and speed as in Fig. 9 of the paper. A model with one input has no map.
    x_input_ = inputNamed(model, "depth").value_or(model.inputs.size() - 1);
    y_input_ = inputNamed(model, "speed").value_or(0);
    if (x_input_ == y_input_) y_input_ = x_input_ == 0 ? model.inputs.size() - 1 : 0;
  }
  expert_ = expertNamed(model, expert_id_);
  emit choiceChanged();
}

}  // namespace tactus::workbench
