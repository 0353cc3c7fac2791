#include "app/workbench/understand/map/force_map.h"

#include <QElapsedTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
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

ForceMapController::ForceMapController(const SceneController& scene, QObject* parent) : QObject(parent), scene_(scene) {
  slices_.setInterval(0);
  connect(&slices_, &QTimer::timeout, this, &ForceMapController::work);
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
  compute();
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

void ForceMapController::compute() {
  stop();
  model_ = scene_.shared();
  std::vector<std::optional<double>> fixed;
  point_.clear();
  for (std::size_t i = 0; i < model_->model.inputs.size(); ++i) {
    point_.push_back(scene_.value(i));
    fixed.push_back(i == x_input_ || i == y_input_ ? std::nullopt : std::optional(point_[i]));
  }
  auto order = fuzzy::Scene::specialise(model_->compiled, fixed);
  TACTUS_CHECK(order.has_value());
  order_ = std::move(*order);
  x_part_ = scene_.ranges().of(model_->model.inputs[x_input_]);
  y_part_ = scene_.ranges().of(model_->model.inputs[y_input_]);
  level_ = firstLevel();
  beginLevel();
  work();
}

void ForceMapController::finish() {
  update();
  while (!isFinest()) work();
}

std::size_t ForceMapController::firstLevel() const {
  std::size_t level = 0;
  const auto takes_ms = [this](std::size_t side) { return static_cast<double>(side * side) * place_ns_ / 1e6; };
  while (place_ns_ > 0 && level + 1 < kSides.size() && takes_ms(kSides[level + 1]) < kSliceMs) ++level;
  return level;
}

void ForceMapController::stop() {
  slices_.stop();
  level_ = kSides.size();
}

void ForceMapController::adoptModel() {
  stop();
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

void ForceMapController::work() {
  QElapsedTimer clock;
  clock.start();
  bool finished_one = false;
  std::size_t places = 0;
  while (level_ < kSides.size() && clock.elapsed() < kSliceMs) {
    computeRow();
    places += growing_.side;
    if (row_ < growing_.side) continue;
    finished_one = true;
    map_ = std::move(growing_);
    ++level_;
    if (level_ < kSides.size()) beginLevel();
  }
  place_ns_ = static_cast<double>(clock.nsecsElapsed()) / static_cast<double>(places);
  if (level_ == kSides.size()) {
    slices_.stop();
  } else if (!slices_.isActive()) {
    slices_.start();
  }
  if (finished_one) emit mapChanged();
}

void ForceMapController::beginLevel() {
  growing_ = {};
  growing_.x_input = x_input_;
  growing_.y_input = y_input_;
  growing_.side = kSides[level_];
  growing_.force_n.resize(growing_.side * growing_.side);
  growing_.fired.resize(growing_.side * growing_.side);
  growing_.x_part = x_part_;
  growing_.y_part = y_part_;
  xs_ = evenly(x_part_, growing_.side);
  ys_ = evenly(y_part_, growing_.side);
  row_ = 0;
}

void ForceMapController::computeRow() {
  const std::size_t side = growing_.side;
  const std::span<double> forces = std::span(growing_.force_n).subspan(row_ * side, side);
  const std::span<std::uint8_t> fired = std::span(growing_.fired).subspan(row_ * side, side);
  if (expert_) {
    point_[y_input_] = ys_[row_];
    for (std::size_t i = 0; i < side; ++i) {
      point_[x_input_] = xs_[i];
      const fuzzy::Evaluation here = model_->compiled.evaluateExpert(*expert_, point_);
      forces[i] = here.force_n;
      fired[i] = here.fired ? 1 : 0;
    }
  } else {
    const std::vector<double> same_y(side, ys_[row_]);
    // The varying inputs stand in the order of the model.
    std::array<std::span<const double>, 2> inputs = {xs_, same_y};
    if (y_input_ < x_input_) std::swap(inputs[0], inputs[1]);
    order_->evaluateBatch(inputs, {forces, fired});
  }
  scene_.countEvaluations(side * (expert_ ? 1 : 1 + model_->compiled.expertCount()));
  ++row_;
}

}  // namespace tactus::workbench
