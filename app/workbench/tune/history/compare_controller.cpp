#include "app/workbench/tune/history/compare_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/edit_impact.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "core/analysis/force_difference.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

using editing::Event;
using editing::EventKind;
using editing::StateId;
using Kind = CompareChoice::Kind;

// An expert of weight 0 counts as absent (docs/semantics.md), so this is the force of the one bit for bit.
fuzzy::ForceModel alone(fuzzy::ForceModel model, const std::string& id) {
  for (fuzzy::Expert& expert : model.experts) expert.weight = expert.id == id ? 1 : 0;
  return model;
}

bool isMark(const Event& event) { return event.kind == EventKind::kSnapshot || event.kind == EventKind::kSignOff; }

QString nameOfMark(const Event& mark) {
  return mark.kind == EventKind::kSnapshot ? CompareController::tr("Snapshot “%1”").arg(text(mark.label))
                                           : CompareController::tr("Signed off by %1").arg(text(mark.stamp.author));
}

QString nameOfState(const editing::EditHistory& history, StateId state) {
  return CompareController::tr("%1 · %2").arg(state).arg(text(history.labelOf(state)));
}

// Two models over the same inputs can be compared, shown and felt in one place.
bool sameInputs(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other) {
  return std::equal(one.inputs.begin(), one.inputs.end(), other.inputs.begin(), other.inputs.end(),
                    [](const auto& a, const auto& b) { return a.id == b.id; });
}

// Nothing where it was told to stop.
std::optional<CompareResult> differenceOf(const OpenModel& a, const OpenModel& b, const CurveSetting& curve,
                                          const std::stop_token& stop) {
  const auto whole = analysis::forceDifference(a.model, a.compiled, b.model, b.compiled);
  if (stop.stop_requested()) return std::nullopt;
  // The same number as everywhere else; the even points are for the rest.
  const auto impact = shownImpact(a.model, a.compiled, b.model, b.compiled, curve);
  return CompareResult{impact.largest_n,  impact.at,   impact.before_n,      impact.after_n,
                       impact.noticeable, whole.rms_n, whole.only_one_fires, analysis::modelChanges(a.model, b.model)};
}

}  // namespace

CompareController::CompareController(ModelController& models, EditController& edits,
                                     std::function<CurveSetting()> curve, QObject* parent)
    : QObject(parent), models_(models), edits_(edits), curve_(std::move(curve)) {
  connect(&edits_, &EditController::modelReset, this, &CompareController::reset);
  connect(&edits_, &EditController::historyChanged, this, [this] {
    // What was the state before may be another one.
    if (choice(CompareSide::kA).kind == Kind::kPrevious || choice(CompareSide::kB).kind == Kind::kPrevious) forget();
    emit choicesChanged();
  });
  connect(&models_, &ModelController::edited, this, &CompareController::onEdited);
  if (edits_.isOpen()) reset();
}

std::vector<CompareController::Option> CompareController::options() const {
  std::vector<Option> out;
  if (!edits_.isOpen()) return out;
  const auto add = [&](CompareChoice choice) { out.push_back({choice, nameOf(choice)}); };
  add({Kind::kOpen, 0, {}});
  const editing::EditHistory& history = edits_.history();
  if (history.canUndo()) add({Kind::kPrevious, 0, {}});
  const auto& experts = edits_.model().experts;
  if (experts.size() > 1) {
    for (const fuzzy::Expert& expert : experts) add({Kind::kExpert, 0, expert.id});
  }
  // Names of states are at hand here; nameOf would look through all events for each.
  const auto addState = [&](StateId state, QString name) {
    Option option;
    option.choice.kind = Kind::kState;
    option.choice.state = state;
    option.name = std::move(name);
    out.push_back(std::move(option));
  };
  std::vector<bool> named(history.states().size());
  const auto& events = history.events();
  for (auto event = events.rbegin(); event != events.rend(); ++event) {
    if (!isMark(*event)) continue;
    if (!named[event->state]) addState(event->state, nameOfMark(*event));
    named[event->state] = true;
  }
  for (StateId state = history.states().size(); state-- > 0;) {
    if (!named[state]) addState(state, nameOfState(history, state));
  }
  return out;
}

QString CompareController::nameOf(const CompareChoice& choice) const {
  switch (choice.kind) {
    case Kind::kOpen:
      return edits_.model().experts.size() > 1
                 ? tr("Open model, mean of %n expert(s)", nullptr, static_cast<int>(edits_.model().experts.size()))
                 : tr("Open model");
    case Kind::kPrevious: return tr("Before the last edit");
    case Kind::kExpert:
      for (const fuzzy::Expert& expert : edits_.model().experts) {
        if (expert.id == choice.expert) return tr("%1 alone").arg(labelOf(expert));
      }
      return text(choice.expert);
    case Kind::kState: break;
  }
  const editing::EditHistory& history = edits_.history();
  const auto& events = history.events();
  const auto mark = std::find_if(events.rbegin(), events.rend(),
                                 [&](const Event& event) { return event.state == choice.state && isMark(event); });
  return mark == events.rend() ? nameOfState(history, choice.state) : nameOfMark(*mark);
}

void CompareController::choose(CompareSide side, CompareChoice choice) {
  const bool known =
      choice.kind != Kind::kState || (edits_.isOpen() && choice.state < edits_.history().states().size());
  if (!known || sides_[index(side)] == choice) return;
  sides_[index(side)] = std::move(choice);
  forget();
  emit choicesChanged();
  if (shown_ == side) show(side);
}

bool CompareController::showsAnother() const { return shown_ && choice(*shown_).kind != Kind::kOpen; }

base::Result<std::shared_ptr<const OpenModel>> CompareController::modelOf(CompareSide side) {
  return make(choice(side));
}

base::Result<std::shared_ptr<const OpenModel>> CompareController::make(const CompareChoice& choice) {
  TACTUS_CHECK(edits_.isOpen());
  const std::shared_ptr<const OpenModel> open = models_.current();
  if (choice.kind == Kind::kOpen) return open;
  base::Result<editing::SharedModel> model;
  const editing::EditHistory& history = edits_.history();
  StateId state = history.current();
  if (choice.kind == Kind::kExpert) {
    model = editing::ready(alone(open->model, choice.expert));
  } else {
    state = choice.kind == Kind::kState ? choice.state : history.states()[state].parent.value_or(0);
    model = edits_.readyOf(state);
  }
  if (!model) return tl::unexpected(model.error());
  if (!sameInputs((*model)->model, open->model)) {
    return base::fail(base::ErrorCode::kMismatch, nameOf(choice).toStdString(), "other inputs",
                      "the inputs of the open model");
  }
  OpenModel out(std::move(*model));
  out.path = open->path;
  out.in_study = open->in_study;
  out.simulated = open->simulated || saysSimulated(out.model);
  out.version = history.versionOf(state);
  if (choice.kind == Kind::kExpert) out.only_expert = choice.expert;
  return std::make_shared<const OpenModel>(std::move(out));
}

void CompareController::compute() {
  if (result_ || worker_.isBusy() || !edits_.isOpen() || edits_.inGesture()) return;
  const auto a = modelOf(CompareSide::kA);
  const auto b = modelOf(CompareSide::kB);
  if (!a || !b) {
    const base::Error& error = a ? b.error() : a.error();
    // An old state of a study that is still being read is asked for again when it is there.
    if (error.code != base::ErrorCode::kIo) emit refused(text(error.message()));
    return;
  }
  worker_.run([this, a = *a, b = *b,
               curve = curve_ ? curve_() : CurveSetting()](const std::stop_token& stop) -> Background::Deliver {
    const auto result = differenceOf(*a, *b, curve, stop);
    if (!result) return {};
    return [this, result = *result] {
      result_ = result;
      include(*result_);
      emit resultChanged();
    };
  });
}

// The last edit has one largest change, wherever it was seen.
void CompareController::include(CompareResult& result) {
  const Kind a = choice(CompareSide::kA).kind;
  const Kind b = choice(CompareSide::kB).kind;
  if ((a != Kind::kOpen || b != Kind::kPrevious) && (a != Kind::kPrevious || b != Kind::kOpen)) return;
  const auto impact = edits_.impactOf(edits_.history().current());
  if (!impact || impact->largest_n <= result.largest_n) return;
  result.largest_n = impact->largest_n;
  result.at = impact->at;
  result.a_n = a == Kind::kOpen ? impact->after_n : impact->before_n;
  result.b_n = a == Kind::kOpen ? impact->before_n : impact->after_n;
}

void CompareController::show(CompareSide side) {
  if (!edits_.isOpen()) return;
  edits_.commit();
  const auto model = modelOf(side);
  if (!model) {
    emit refused(text(model.error().message()));
    return;
  }
  shown_ = side;
  models_.showInstead(*model);
  emit shownChanged();
}

void CompareController::toggle() {
  if (!edits_.isOpen()) return;
  if (!shown_) {
    const auto a = modelOf(CompareSide::kA);
    const auto b = modelOf(CompareSide::kB);
    if (a && b && editing::sameBits((*a)->model, (*b)->model)) {
      emit refused(tr("There is nothing to compare: A and B are the same model. Choose two in the panel History."));
      return;
    }
  }
  show(shown_ == CompareSide::kB ? CompareSide::kA : CompareSide::kB);
}

void CompareController::end() {
  if (!shown_) return;
  shown_.reset();
  models_.showInstead(nullptr);
  emit shownChanged();
}

void CompareController::reset() {
  sides_[0] = {};
  sides_[1] = {Kind::kPrevious, 0, {}};
  if (std::exchange(shown_, std::nullopt)) emit shownChanged();
  models_.showInstead(nullptr);
  forget();
  emit choicesChanged();
}

void CompareController::onEdited() {
  // An edit is always one of the open model, and what is edited has to be what is felt.
  if (showsAnother()) {
    const QString name = nameOf(choice(*shown_));
    shown_.reset();
    emit shownChanged();
    emit said(
        tr("You edited the open model, so the comparison has ended. The device renders the open model again, not “%1”.")
            .arg(name));
  }
  forget();
}

void CompareController::forget() {
  worker_.drop();
  const bool was_known = std::exchange(result_, std::nullopt).has_value();
  // The end of a gesture too, which may leave everything as it was: only then can it be computed again.
  if (was_known || !edits_.inGesture()) emit resultChanged();
}

}  // namespace tactus::workbench
