#include "app/workbench/model/scene_controller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/check.h"

namespace tactus::workbench {
namespace {

double clamped(const fuzzy::Variable& variable, double value) { return std::clamp(value, variable.min, variable.max); }

std::optional<std::size_t> expertWithOwnTerms(const fuzzy::ForceModel& model, const std::string& id) {
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    if (model.experts[i].id == id && !model.experts[i].overrides.empty()) return i;
  }
  return std::nullopt;
}

// Whether what is on the axes and in the lists stays: a view then only refreshes what it shows.
bool sameFrame(const fuzzy::ForceModel& a, const fuzzy::ForceModel& b) {
  const auto same_variable = [](const fuzzy::Variable& one, const fuzzy::Variable& other) {
    return one.id == other.id && one.label == other.label && one.unit == other.unit && one.min == other.min &&
           one.max == other.max;
  };
  const auto same_expert = [](const fuzzy::Expert& one, const fuzzy::Expert& other) {
    return one.id == other.id && one.label == other.label && one.weight == other.weight &&
           one.overrides.empty() == other.overrides.empty();
  };
  return a.name == b.name && same_variable(a.output, b.output) &&
         std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(), same_variable) &&
         std::equal(a.experts.begin(), a.experts.end(), b.experts.begin(), b.experts.end(), same_expert);
}

}  // namespace

SceneController::SceneController(const ModelController& models, QObject* parent) : QObject(parent), models_(models) {
  connect(&models_, &ModelController::opened, this, &SceneController::adoptModel);
  connect(&models_, &ModelController::edited, this, &SceneController::adoptEdit);
  connect(&models_, &ModelController::shownChanged, this, &SceneController::adoptEdit);
  // Only the path differs, and no panel reads the path from the scene.
  connect(&models_, &ModelController::saved, this, [this] { model_ = models_.shown(); });
  connect(&ranges_, &ShownRanges::changed, this, [this](const std::string& input) {
    if (!model_ || input != xVariable().id) return;
    // A part is sampled as finely as the whole.
    curves_.reset();
    family_curves_.reset();
    emit curvesChanged();
  });
}

const std::vector<fuzzy::Term>& SceneController::terms(const fuzzy::Variable& variable) const {
  return terms_of_ ? fuzzy::termsFor(model_->model.experts[*terms_of_], variable) : variable.terms;
}

const figures::ForceCurves& SceneController::curves() const {
  TACTUS_CHECK(model_ != nullptr);
  if (!curves_) {
    curves_ = figures::computeCurves(model_->model, model_->compiled, x_input_, values_, ranges_.of(xVariable()));
    countEvaluations(curves_->x.size() * (1 + curves_->experts.size()));
  }
  return *curves_;
}

const FamilyCurves& SceneController::familyCurves() const {
  TACTUS_CHECK(model_ != nullptr && family_.has_value());
  if (!family_curves_) {
    family_curves_ = computeFamily(model_->model, model_->compiled, x_input_, values_, *family_);
    countEvaluations(family_curves_->x.size() * family_curves_->curves.size());
  }
  return *family_curves_;
}

std::vector<double> SceneController::readingPoint() const {
  TACTUS_CHECK(model_ != nullptr);
  std::vector<double> point = values_;
  point[x_input_] = readingX();
  return point;
}

const Reading& SceneController::reading() const {
  if (reading_) return *reading_;
  const std::vector<double> point = readingPoint();
  Reading& reading = reading_.emplace();
  reading.x = readingX();
  reading.mean = model_->compiled.evaluate(point);
  for (std::size_t i = 0; i < model_->compiled.expertCount(); ++i) {
    reading.experts.push_back(model_->compiled.evaluateExpert(i, point));
  }
  countEvaluations(1 + reading.experts.size());
  return reading;
}

const analysis::Explanation& SceneController::explanation() const {
  if (!explanation_) {
    auto explained = analysis::explain(model_->model, model_->compiled, readingPoint());
    TACTUS_CHECK(explained.has_value());
    explanation_ = std::move(*explained);
    countEvaluations(1 + explanation_->experts.size());
  }
  return *explanation_;
}

void SceneController::setXInput(std::size_t input) {
  TACTUS_CHECK(input < values_.size());
  if (input == x_input_) return;
  x_input_ = input;
  hover_.reset();
  dropCurves();
  // The input of a family cannot be the axis too.
  const bool family_ends = family_ && family_->input == x_input_;
  if (family_ends) family_.reset();
  emit xInputChanged();
  if (family_ends) emit familyChanged();
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

void SceneController::goTo(const std::vector<double>& point) {
  TACTUS_CHECK(point.size() == values_.size());
  clearHover();
  for (std::size_t i = 0; i < point.size(); ++i) setValue(i, point[i]);
}

void SceneController::applyFigure(const procedure::Figure& figure) {
  // Figures run along the way.
  if (const auto way = fuzzy::wayOf(model_->model.inputs)) setXInput(*way);
  bool curves_stale = false;
  for (const auto& [id, value] : figure.at) {
    const auto input = inputNamed(model_->model, id);
    if (input && storeValue(*input, value)) curves_stale |= *input != x_input_;
  }
  auto family = familyOf(model_->model, inProgramLanguage(figure.name), figure.varied, figure.values);
  if (family && family->input == x_input_) family.reset();
  setFamily(std::move(family));
  emit figureApplied(figure);
  if (curves_stale) {
    announceCurves();
  } else {
    emit readingChanged();
  }
}

void SceneController::clearFamily() { setFamily(std::nullopt); }

void SceneController::setFamily(std::optional<CurveFamily> family) {
  if (family == family_) return;
  family_ = std::move(family);
  family_curves_.reset();
  emit familyChanged();
}

void SceneController::setHover(double x) {
  if (std::isnan(x)) return;
  const double place = clamped(xVariable(), x);
  if (hover_ == place) return;
  hover_ = place;
  dropReading();
  emit readingChanged();
}

void SceneController::clearHover() {
  if (!hover_) return;
  hover_.reset();
  dropReading();
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
  const std::optional<std::size_t> previous_terms = std::exchange(terms_of_, std::nullopt);
  model_ = models_.shown();
  const fuzzy::ForceModel& model = model_->model;
  adoptProcedure();

  values_.clear();
  for (const fuzzy::Variable& input : model.inputs) values_.push_back(std::midpoint(input.min, input.max));
  if (procedure_ != nullptr) {
    for (std::size_t i = 0; i < procedure_->inputs.size(); ++i) {
      if (fuzzy::roleOf(procedure_->inputs[i]) == fuzzy::Role::kWay) continue;
      if (const auto input = inputNamed(model, procedure_->inputs[i].id))
        values_[*input] = clamped(model.inputs[*input], procedure_->input_notes[i].usual);
    }
  }
  x_input_ = fuzzy::wayOf(model.inputs).value_or(model.inputs.size() - 1);
  hover_.reset();
  dropCurves();

  // The setting stays when an edited file is opened again, or a second model of the same kind.
  if (previous) {
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const auto old = inputNamed(previous->model, model.inputs[i].id);
      if (!old) continue;
      values_[i] = clamped(model.inputs[i], previous_values[*old]);
      if (*old == previous_x) x_input_ = i;
    }
    if (previous_terms) terms_of_ = expertWithOwnTerms(model, previous->model.experts[*previous_terms].id);
    if (family_) adoptFamily(previous->model.inputs[family_->input].id);
  }
  emit modelChanged();
}

void SceneController::adoptProcedure() {
  procedure_ = procedureFor(model_->model, study_procedure_);
  showProcedure(procedure_);
}

void SceneController::setStudyProcedure(ProcedurePtr procedure) {
  study_procedure_ = std::move(procedure);
  if (!model_) return;
  const ProcedurePtr before = procedure_;
  adoptProcedure();
  if (procedure_ != before) emit procedureChanged();
}

// The family stays where the model has its input.
void SceneController::adoptFamily(const std::string& varied) {
  family_ = familyOf(model_->model, family_->figure, varied, family_->values);
  if (family_ && family_->input == x_input_) family_.reset();
}

void SceneController::adoptEdit() {
  if (!sameFrame(model_->model, models_.shown()->model)) {
    adoptModel();
    return;
  }
  model_ = models_.shown();
  dropCurves();
  emit modelEdited();
  emit termsChanged();
  announceCurves();
}

bool SceneController::storeValue(std::size_t input, double value) {
  TACTUS_CHECK(input < values_.size());
  if (std::isnan(value)) return false;
  const double inside = clamped(model_->model.inputs[input], value);
  if (values_[input] == inside) return false;
  values_[input] = inside;
  if (input == x_input_) {
    dropReading();
  } else {
    dropCurves();
  }
  emit valueChanged(input);
  return true;
}

// What is read lies on the curves.
void SceneController::dropCurves() {
  curves_.reset();
  family_curves_.reset();
  dropReading();
}

void SceneController::dropReading() {
  reading_.reset();
  explanation_.reset();
}

void SceneController::announceCurves() {
  emit curvesChanged();
  emit readingChanged();
}

}  // namespace tactus::workbench
