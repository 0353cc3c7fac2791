#include "app/workbench/model/ghost_controller.h"

#include <algorithm>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/places.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_impact.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

bool sameInputs(const fuzzy::ForceModel& a, const fuzzy::ForceModel& b) {
  const auto same = [](const fuzzy::Variable& one, const fuzzy::Variable& other) {
    return one.id == other.id && one.unit == other.unit && one.min == other.min && one.max == other.max;
  };
  return std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(), same) &&
         a.output.id == b.output.id && a.output.unit == b.output.unit;
}

bool sameExperts(const fuzzy::ForceModel& a, const fuzzy::ForceModel& b) {
  return std::equal(a.experts.begin(), a.experts.end(), b.experts.begin(), b.experts.end(),
                    [](const auto& one, const auto& other) { return one.id == other.id; });
}

// The curves of `before` in the order of the experts of `now`.
std::vector<std::vector<fuzzy::Evaluation>> inOrderOf(const fuzzy::ForceModel& now, const fuzzy::ForceModel& before,
                                                      std::vector<std::vector<fuzzy::Evaluation>> curves) {
  std::vector<std::vector<fuzzy::Evaluation>> ordered(now.experts.size());
  for (std::size_t i = 0; i < now.experts.size(); ++i) {
    for (std::size_t j = 0; j < before.experts.size(); ++j) {
      if (before.experts[j].id == now.experts[i].id) ordered[i] = std::move(curves[j]);
    }
  }
  return ordered;
}

}  // namespace

GhostController::GhostController(EditController& edits, const SceneController& scene, QObject* parent)
    : QObject(parent), edits_(edits), scene_(scene) {
  connect(&edits_, &EditController::modelReset, this, &GhostController::reset);
  connect(&edits_, &EditController::changed, this, &GhostController::refreshState);
  connect(&edits_, &EditController::historyChanged, this, &GhostController::refreshState);
  connect(&edits_, &EditController::reporting, this, [this] { curves(); });
  if (edits_.isOpen()) refreshState();
}

QString GhostController::label() const { return reference_ ? reference_label_ : tr("Before the last edit"); }

QString GhostController::whatChanged() const {
  if (reference_ || !before_) return {};
  const editing::EditHistory& history = edits_.history();
  return text(edits_.inGesture() ? history.gestureLabel() : history.labelOf(history.current()));
}

base::Result<void> GhostController::setReference(std::shared_ptr<const OpenModel> model, const QString& label) {
  TACTUS_CHECK(model != nullptr && edits_.isOpen());
  if (!sameInputs(model->model, edits_.model())) {
    return base::fail(base::ErrorCode::kMismatch, label.toStdString(), "other inputs or another output",
                      "those of the open model");
  }
  reference_ = std::move(model);
  reference_label_ = label;
  emit changed();
  return {};
}

void GhostController::clearReference() {
  if (!reference_) return;
  reference_.reset();
  emit changed();
}

void GhostController::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  emit changed();
}

void GhostController::reset() {
  before_.reset();
  state_.reset();
  reference_.reset();
  curves_.reset();
  refreshState();
  emit changed();
}

std::optional<editing::StateId> GhostController::stateBefore() const {
  const editing::EditHistory& history = edits_.history();
  if (edits_.inGesture() && !history.gestureLabel().empty()) return history.current();
  return history.states()[history.current()].parent;
}

void GhostController::refreshState() {
  const auto state = stateBefore();
  if (state == state_) return;
  state_ = state;
  before_.reset();
  if (state) {
    // A state that is not in memory has no ghost.
    if (auto ready = edits_.history().readyOf(*state)) before_ = std::make_shared<const OpenModel>(std::move(*ready));
  }
  if (!reference_) emit changed();
}

const GhostCurves* GhostController::curves() const {
  if (!before() || !scene_.model() || !sameInputs(before()->model, scene_.model()->model)) return nullptr;
  compute();
  return &*curves_;
}

void GhostController::compute() const {
  std::vector<double> setting;
  for (std::size_t i = 0; i < scene_.model()->model.inputs.size(); ++i) {
    // The place on the axis has no part in a curve.
    setting.push_back(i == scene_.xInput() ? 0 : scene_.value(i));
  }
  const bool same_before = curves_ && curves_before_ == before() && curves_setting_ == setting &&
                           curves_input_ == scene_.xInput() && sameExperts(curves_after_->model, scene_.model()->model);
  if (same_before && curves_after_ == scene_.shared()) return;
  const OpenModel& past = *before();
  const OpenModel& now = *scene_.model();
  if (!same_before) {
    figures::ForceCurves of_past = figures::computeCurves(past.model, past.compiled, scene_.xInput(), setting);
    scene_.countEvaluations(of_past.x.size() * (1 + of_past.experts.size()));
    curves_.emplace();
    curves_->x = std::move(of_past.x);
    curves_->mean = std::move(of_past.mean);
    curves_->experts = inOrderOf(now.model, past.model, std::move(of_past.experts));
    curves_before_ = before();
    curves_setting_ = setting;
    curves_input_ = scene_.xInput();
  }
  curves_->difference = curveBetween(past.model, past.compiled, now.model, now.compiled, {scene_.xInput(), setting});
  scene_.countEvaluations(curves_->difference.points.size() *
                          (2 + past.model.experts.size() + now.model.experts.size()));
  curves_->difference.points.clear();
  curves_after_ = scene_.shared();
  // A version that is compared is no state of the open model.
  const bool is_state = !reference_ && !scene_.showsAnother() && editing::sameBits(now.model, edits_.model());
  if (is_state) edits_.include(curves_->difference, scene_.xInput(), setting);
}

QString GhostController::differenceText() const {
  const GhostCurves* ghost = curves();
  if (!ghost) return {};
  const QString curve = curveText();
  const auto impact = this->impact();
  if (!impact) return ghost->difference.largest_at ? tr("max ΔF on this curve at least %1").arg(curve) : curve;
  const QString whole = impactText(*impact, scene_.model()->model.output.unit);
  const bool shown_here = ghost->difference.largest_at && ghost->difference.largest_n >= impact->largest_n;
  const bool same_place = ghost->difference.noticeable_at == ghost->difference.largest_at;
  if (shown_here && same_place && ghost->difference.noticeable >= impact->noticeable) {
    // It is on the screen: the place is all that is to be added.
    const QString place = placeText(scene_.xVariable(), *ghost->difference.largest_at);
    const qsizetype end = whole.indexOf(QStringLiteral(" · "));
    const QString rest = end < 0 ? QString() : whole.mid(end);
    return tr("%1 at %2").arg(end < 0 ? whole : whole.left(end), place) + rest;
  }
  if (ghost->difference.largest_at) return tr("%1 · on this curve at least %2").arg(whole, curve);
  if (const auto there = elsewhere()) return tr("No change here: acts at %1 · %2").arg(there->where, whole);
  return impact->at.empty() ? curve : whole + QStringLiteral(" · ") + curve;
}

QString GhostController::briefText() const {
  const GhostCurves* ghost = curves();
  if (!ghost) return {};
  const std::string& unit = scene_.model()->model.output.unit;
  const auto impact = this->impact();
  if ((impact && impact->opened > 0) || ghost->difference.opened > 0) return tr("leaves a hole");
  if (impact && !impact->at.empty()) return briefChangeText(impact->largest_n, unit, Scope::kAnywhere);
  if (ghost->difference.largest_at) return briefChangeText(ghost->difference.largest_n, unit, Scope::kThisCurve);
  return ghost->difference.closed > 0 ? tr("fills a hole") : tr("no change of this curve");
}

std::optional<editing::EditImpact> GhostController::impact() const {
  if (reference_ || edits_.inGesture() || scene_.showsAnother()) return std::nullopt;
  return edits_.impactOf(edits_.history().current());
}

std::optional<GhostController::Elsewhere> GhostController::elsewhere() const {
  const GhostCurves* ghost = curves();
  if (ghost == nullptr) return std::nullopt;
  const editing::GhostCurve& here = ghost->difference;
  if (here.largest_at || here.closed > 0 || here.opened > 0) return std::nullopt;
  const auto impact = this->impact();
  if (!impact || impact->at.empty()) return std::nullopt;
  const fuzzy::ForceModel& model = scene_.model()->model;
  const auto region = editing::changedRegion(before()->model, model);
  QString where = rangesOutside(model, region, scene_.values(), scene_.xInput());
  if (where.isEmpty()) {
    // Between the regions of two edits, or where another expert's rule is stronger.
    QStringList places;
    for (std::size_t i = 0; i < impact->at.size(); ++i) {
      if (i == scene_.xInput()) continue;
      places << labelOf(model.inputs[i]) + QLatin1Char(' ') + placeText(model.inputs[i], impact->at[i]);
    }
    where = places.join(QStringLiteral(", "));
  }
  return Elsewhere{where, impact->at};
}

// `0.116 N (1.4 JND) at 215 mm`
QString GhostController::curveText() const {
  const fuzzy::Variable& x = scene_.xVariable();
  const editing::GhostCurve& difference = curves()->difference;
  const bool newtons = scene_.model()->model.output.unit == "N";
  QStringList parts;
  if (difference.largest_at) {
    const QString force = forceChangeText(difference.largest_n, scene_.model()->model.output.unit);
    const QString at = placeText(x, *difference.largest_at);
    const QString noticeable = tr("%1 JND").arg(numberText(difference.noticeable, 1));
    if (!newtons) {
      parts << tr("%1 at %2").arg(force, at);
    } else if (difference.noticeable_at == difference.largest_at) {
      parts << tr("%1 (%2) at %3").arg(force, noticeable, at);
    } else {
      parts << tr("%1 at %2, %3 at %4").arg(force, at, noticeable, placeText(x, *difference.noticeable_at));
    }
  }
  if (difference.closed > 0) parts << tr("fills a hole");
  if (difference.opened > 0) parts << tr("leaves a hole");
  return parts.isEmpty() ? tr("no change of this curve") : parts.join(QStringLiteral(" · "));
}

}  // namespace tactus::workbench
