#include "app/workbench/understand/curves/reference_controller.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "core/base/check.h"

namespace tactus::workbench {

ReferenceController::ReferenceController(const SceneController& scene, QObject* parent)
    : QObject(parent), scene_(scene) {
  connect(&scene_, &SceneController::modelChanged, this, &ReferenceController::adoptModel);
  connect(&scene_, &SceneController::xInputChanged, this, [this] {
    drop();
    emit changed();
  });
  connect(&scene_, &SceneController::curvesChanged, this, &ReferenceController::drop);
}

std::vector<ReferenceCurve> ReferenceController::shown() const {
  std::vector<ReferenceCurve> out;
  if (!scene_.model()) return out;
  std::copy_if(references_.begin(), references_.end(), std::back_inserter(out),
               [this](const ReferenceCurve& curve) { return curve.input == scene_.xVariable().id; });
  return out;
}

void ReferenceController::open(const QString& path) {
  TACTUS_CHECK(scene_.model() != nullptr);
  auto curves = readReferences(path, scene_.model()->model);
  if (!curves) {
    emit refused(text(curves.error().message()));
    return;
  }
  std::vector<ReferenceCurve> next = references_;
  for (ReferenceCurve& curve : *curves) {
    const auto known = std::find_if(next.begin(), next.end(), [&](const auto& old) { return old.name == curve.name; });
    if (known != next.end()) {
      curve.color = known->color;
      *known = std::move(curve);
      continue;
    }
    // The first color that is free.
    while (std::any_of(next.begin(), next.end(), [&](const auto& old) { return old.color == curve.color; })) {
      ++curve.color;
    }
    next.push_back(std::move(curve));
  }
  if (next.size() > kMostReferences) {
    emit refused(
        tr("%1: found %n reference curve(s) together with those that are shown, wanted at most %2; remove some first.",
           nullptr, static_cast<int>(next.size()))
            .arg(path)
            .arg(kMostReferences));
    return;
  }
  references_ = std::move(next);
  drop();
  emit changed();
}

void ReferenceController::remove(const QString& name) {
  if (std::erase_if(references_, [&](const ReferenceCurve& curve) { return curve.name == name; }) == 0) return;
  drop();
  emit changed();
}

void ReferenceController::setExpert(std::optional<std::size_t> expert) {
  TACTUS_CHECK(!expert || *expert < scene_.model()->model.experts.size());
  if (expert == expert_) return;
  expert_ = expert;
  expert_id_ = expert ? scene_.model()->model.experts[*expert].id : std::string();
  drop();
  emit changed();
}

void ReferenceController::adoptModel() {
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  std::erase_if(references_, [&inputs](const ReferenceCurve& curve) {
    return std::none_of(inputs.begin(), inputs.end(), [&](const auto& input) { return input.id == curve.input; });
  });
  expert_ = expertNamed(scene_.model()->model, expert_id_);
  drop();
  emit changed();
}

void ReferenceController::drop() { differences_.reset(); }

const std::vector<std::optional<ReferenceDifference>>& ReferenceController::differences() const {
  if (!differences_) {
    differences_.emplace();
    for (const ReferenceCurve& reference : shown()) differences_->push_back(differenceOf(reference));
  }
  return *differences_;
}

std::optional<ReferenceDifference> ReferenceController::differenceOf(const ReferenceCurve& reference) const {
  const figures::ForceCurves& curves = scene_.curves();
  const std::vector<fuzzy::Evaluation>& known = expert_ ? curves.experts[*expert_] : curves.mean;
  const fuzzy::CompiledModel& compiled = scene_.model()->compiled;
  std::vector<double> point = scene_.readingPoint();
  std::vector<double> places;
  std::vector<double> forces;
  const auto add = [&](double x, const fuzzy::Evaluation& here) {
    places.push_back(x);
    forces.push_back(here.fired ? here.force_n : std::numeric_limits<double>::quiet_NaN());
  };
  // The places of both: the model's own are there, at the others it is asked.
  std::size_t next = 0;
  std::uint64_t asked = 0;
  for (const double x : reference.x) {
    for (; next < curves.x.size() && curves.x[next] < x; ++next) add(curves.x[next], known[next]);
    if (x < scene_.xVariable().min || x > scene_.xVariable().max) continue;
    if (next < curves.x.size() && curves.x[next] == x) continue;
    point[scene_.xInput()] = x;
    add(x, expert_ ? compiled.evaluateExpert(*expert_, point) : compiled.evaluate(point));
    ++asked;
  }
  for (; next < curves.x.size(); ++next) add(curves.x[next], known[next]);
  scene_.countEvaluations(asked);
  return compare(reference, {places, forces});
}

QString ReferenceController::differenceText(const std::optional<ReferenceDifference>& difference) const {
  if (!difference) return tr("no range in common");
  const fuzzy::Variable& x = scene_.xVariable();
  const std::string& unit = scene_.model()->model.output.unit;
  return tr("RMS %1 · largest %2 at %3 · over %4")
      .arg(forceText(difference->rms_n, unit), forceText(difference->largest_n, unit),
           placeText(x, difference->largest_at), rangeText(x, difference->from, difference->to));
}

}  // namespace tactus::workbench
