#include "app/workbench/tune/tell/tell_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/patient.h"
#include "core/base/text.h"
#include "core/contracts/contract_check.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kMoments = 121;  // of the stroke: those that its number is taken from

/// What counts of a model: for one expert alone that expert, as the command line compares it.
base::Result<editing::SharedModel> counting(const OpenModel& open) {
  const auto expert = expertNamed(open.model, open.only_expert);
  if (!expert) return open.shared;
  fuzzy::ForceModel alone = open.model;
  fuzzy::Expert one = alone.experts[*expert];
  one.weight = 1;
  alone.experts = {std::move(one)};
  return editing::ready(std::move(alone));
}

std::vector<ToldMoment> momentsOf(const fuzzy::CompiledModel& a, const fuzzy::CompiledModel& b,
                                  const contracts::StrokeInputs& inputs, const contracts::Stroke& stroke) {
  std::vector<ToldMoment> out;
  std::vector<double> point = stroke.inputs;
  for (std::size_t i = 0; i < kMoments; ++i) {
    ToldMoment one;
    one.at = contracts::momentOf(stroke, static_cast<double>(i) / (kMoments - 1));
    point[inputs.depth] = one.at.depth_mm;
    if (inputs.speed) point[*inputs.speed] = one.at.speed_mm_s;
    one.a = a.evaluate(point);
    one.b = b.evaluate(point);
    one.felt = one.a.fired && one.b.fired &&
               std::abs(one.b.force_n - one.a.force_n) >= contracts::justNoticeableDifference(one.a.force_n);
    out.push_back(one);
  }
  return out;
}

QString withSign(double force_n, const std::string& unit) {
  return (force_n < 0 ? QStringLiteral("−") : QStringLiteral("+")) + forceText(std::abs(force_n), unit);
}

}  // namespace

TellController::TellController(CompareController& compare, EditController& edits, QObject* parent)
    : QObject(parent),
      compare_(compare),
      edits_(edits),
      search_([this] { return question_ ? std::optional(question_) : std::nullopt; }, &TellController::answerOf) {
  const auto become_old = [this](bool old) {
    if (!question_ || old_ || !old) return;
    old_ = true;
    emit changed();
  };
  connect(&compare_, &CompareController::choicesChanged, this, [this, become_old] {
    become_old(compare_.choice(CompareSide::kA) != sides_[0] || compare_.choice(CompareSide::kB) != sides_[1]);
  });
  connect(&edits_, &EditController::changed, this, [this, become_old] {
    // A state of the history stays what it is.
    become_old(std::any_of(std::begin(sides_), std::end(sides_),
                           [](const CompareChoice& one) { return one.kind != CompareChoice::Kind::kState; }));
  });
  connect(&edits_, &EditController::modelReset, this, [this] {
    question_.reset();
    old_ = false;
    search_.forget();
    emit changed();
  });
  connect(&search_, &Computation::valueChanged, this, &TellController::changed);
  connect(&search_, &Computation::changed, this, &TellController::changed);
}

bool TellController::begin() {
  if (!edits_.isOpen()) return false;
  edits_.commit();
  const auto a = compare_.modelOf(CompareSide::kA);
  const auto b = compare_.modelOf(CompareSide::kB);
  if (!a || !b) {
    emit refused(text((a ? b.error() : a.error()).message()));
    return false;
  }
  sides_[0] = compare_.choice(CompareSide::kA);
  sides_[1] = compare_.choice(CompareSide::kB);
  question_ =
      std::make_shared<const Question>(Question{*a, *b, compare_.nameOf(sides_[0]), compare_.nameOf(sides_[1])});
  old_ = false;
  search_.forget();
  emit changed();
  return true;
}

TellController::Search::Answer TellController::answerOf(const std::shared_ptr<const Question>& question,
                                                        const RunOf<Told>& run) {
  const auto a = counting(*question->a);
  const auto b = counting(*question->b);
  if (!a || !b) return tl::unexpected(text((a ? b.error() : a.error()).message()));
  const auto inputs = contracts::strokeInputs((*a)->model);
  if (!inputs) return tl::unexpected(text(inputs.error().message()));
  contracts::TellEffort effort;
  effort.progress = run.progress;
  const auto found = contracts::tell((*a)->model, (*a)->compiled, (*b)->model, (*b)->compiled, {}, effort, run.stop);
  if (run.stop.stop_requested()) return nullptr;
  if (!found) return tl::unexpected(text(found.error().message()));
  return std::make_shared<const Told>(
      Told{*found, *inputs, momentsOf((*a)->compiled, (*b)->compiled, *inputs, found->stroke)});
}

QString TellController::verdict() const {
  if (told() == nullptr) return {};
  const double rms = told()->found.feel.rms_jnd;
  const QString number = text(base::formatFixed(rms, 2));
  return rms >= 1
             ? tr("Felt: %1 JND in the mean square over its time").arg(number)
             : tr("None felt: the best stroke found differs by %1 JND in the mean square over its time").arg(number);
}

QString TellController::bound() const {
  if (told() == nullptr) return {};
  const auto& bound = told()->found.bound_jnd;
  return bound ? tr("At no place more than %1 JND, proved.").arg(text(base::roundedNumber(*bound)))
               : tr("No bound for all places: the space of the inputs is divided too finely, or was not bounded.");
}

QStringList TellController::details() const {
  if (told() == nullptr) return {};
  const contracts::TellingStroke& found = told()->found;
  const fuzzy::ForceModel& model = question_->a->model;
  QStringList out;
  if (found.feel.rms_jnd > 0) {
    out << tr("Insertion from %1 to %2 mm, %3 mm/s at its fastest")
               .arg(text(base::formatFixed(found.stroke.from_mm, 1)), text(base::formatFixed(found.stroke.to_mm, 1)),
                    text(base::formatFixed(found.stroke.peak_mm_s, 0)));
    QStringList conditions;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const fuzzy::Variable& input = model.inputs[i];
      if (i == told()->inputs.depth || i == told()->inputs.speed) continue;
      const auto term = strongestTerm(input, found.stroke.inputs[i]);
      const QString value =
          (text(base::roundedNumber(found.stroke.inputs[i])) + QLatin1Char(' ') + unitText(input.unit)).trimmed();
      conditions << (term ? tr("%1 %2 (%3)").arg(labelOf(input), value, labelOf(input.terms[*term]))
                          : tr("%1 %2").arg(labelOf(input), value));
    }
    if (!conditions.isEmpty()) out << conditions.join(QStringLiteral(", "));
    out << tr("Largest difference %1, %2 JND, at %3 mm")
               .arg(withSign(found.feel.largest_n, model.output.unit),
                    text(base::formatFixed(found.feel.largest_jnd, 2)), text(base::formatFixed(found.feel.at_mm, 1)));
  }
  if (found.feel.silent > 0)
    out << tr("At %n of 121 moments one of the two has no force; they are left out.", nullptr,
              static_cast<int>(found.feel.silent));
  return out;
}

}  // namespace tactus::workbench
