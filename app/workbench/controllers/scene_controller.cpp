#include "app/workbench/controllers/scene_controller.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"

namespace tactus::workbench {
namespace {

double clamped(const fuzzy::Variable& variable, double value) { return std::clamp(value, variable.min, variable.max); }

std::optional<std::size_t> indexOf(const fuzzy::ForceModel& model, const std::string& id) {
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == id) return i;
  }
  return std::nullopt;
}

}  // namespace

SceneController::SceneController(const ModelController& models, QObject* parent) : QObject(parent), models_(models) {
  connect(&models_, &ModelController::opened, this, &SceneController::adoptModel);
}

const std::vector<fuzzy::Term>& SceneController::terms(const fuzzy::Variable& variable) const {
  return terms_of_ ? fuzzy::termsFor(model_->model.experts[*terms_of_], variable) : variable.terms;
}

const ForceCurves& SceneController::curves() const {
  TACTUS_CHECK(model_ != nullptr);
  if (!curves_) curves_ = computeCurves(model_->model, model_->compiled, x_input_, values_);
  return *curves_;
}

Reading SceneController::reading() const {
  TACTUS_CHECK(model_ != nullptr);
  std::array<double, fuzzy::kMostInputs> buffer{};
  std::copy(values_.begin(), values_.end(), buffer.begin());
  const std::span<double> inputs(buffer.data(), values_.size());
  inputs[x_input_] = readingX();

  Reading reading;
  reading.x = readingX();
  reading.mean = model_->compiled.evaluate(inputs);
  for (std::size_t i = 0; i < model_->compiled.expertCount(); ++i) {
    reading.experts.push_back(model_->compiled.evaluateExpert(i, inputs));
  }
  return reading;
}

void SceneController::setXInput(std::size_t input) {
  TACTUS_CHECK(input < values_.size());
  if (input == x_input_) return;
  x_input_ = input;
  hover_.reset();
  curves_.reset();
  emit xInputChanged();
  announceCurves();
}

void SceneController::setValue(std::size_t input, double value) {
  if (!storeValue(input, value)) return;
  if (input == x_input_) {
    emit readingChanged();
  } else {
    announceCurves();
  }
}

void SceneController::applyPreset(const FigurePreset& preset) {
  bool curves_stale = false;
  for (const FigurePreset::Setting& setting : preset.settings) {
    const auto input = indexOf(model_->model, setting.input);
    if (input && storeValue(*input, setting.value)) curves_stale |= *input != x_input_;
  }
  if (curves_stale) {
    announceCurves();
  } else {
    emit readingChanged();
  }
}

void SceneController::setHover(double x) {
  const double place = clamped(xVariable(), x);
  if (hover_ == place) return;
  hover_ = place;
  emit readingChanged();
}

void SceneController::clearHover() {
  if (!hover_) return;
  hover_.reset();
  emit readingChanged();
}

void SceneController::setTermsOf(std::optional<std::size_t> expert) {
  TACTUS_CHECK(!expert || *expert < model_->model.experts.size());
  if (expert == terms_of_) return;
  terms_of_ = expert;
  emit termsChanged();
}

void SceneController::adoptModel() {
  const std::shared_ptr<const OpenModel> previous = model_;
  const std::vector<double> previous_values = values_;
  const std::size_t previous_x = x_input_;
  model_ = models_.current();
  const fuzzy::ForceModel& model = model_->model;

  values_.clear();
  for (const fuzzy::Variable& input : model.inputs) values_.push_back(std::midpoint(input.min, input.max));
  x_input_ = indexOf(model, "depth").value_or(model.inputs.size() - 1);
  hover_.reset();
  terms_of_.reset();
  curves_.reset();

  // The last preset compares the experts, which is what the window shows first.
  const std::vector<FigurePreset> presets = figurePresets(model);
  if (!presets.empty()) {
    for (const auto& setting : presets.back().settings) {
      const std::size_t input = *indexOf(model, setting.input);
      values_[input] = clamped(model.inputs[input], setting.value);
    }
  }
  // Whoever opens an edited file again, or a second model of the same kind, keeps the setting.
  if (previous) {
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const auto old = indexOf(previous->model, model.inputs[i].id);
      if (!old) continue;
      values_[i] = clamped(model.inputs[i], previous_values[*old]);
      if (*old == previous_x) x_input_ = i;
    }
  }
  emit modelChanged();
}

bool SceneController::storeValue(std::size_t input, double value) {
  TACTUS_CHECK(input < values_.size());
  const double inside = clamped(model_->model.inputs[input], value);
  if (values_[input] == inside) return false;
  values_[input] = inside;
  if (input != x_input_) curves_.reset();
  emit valueChanged(input);
  return true;
}

void SceneController::announceCurves() {
  emit curvesChanged();
  emit readingChanged();
}

}  // namespace tactus::workbench
