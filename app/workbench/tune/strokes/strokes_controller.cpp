#include "app/workbench/tune/strokes/strokes_controller.h"

#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {

using replay::ComparedStroke;
using replay::RecordedStroke;
using replay::StrokeUse;

namespace {

/// The word of the model for a speed that was asked for.
QString levelLabel(const fuzzy::ForceModel& model, const std::string& level) {
  const auto speed = fuzzy::rateOf(model.inputs);
  const fuzzy::Term* const term = speed ? fuzzy::findTerm(model.inputs[*speed].terms, level) : nullptr;
  return term != nullptr ? labelOf(*term) : text(level);
}

}  // namespace

StrokesController::StrokesController(GhostController& ghost, EditController& edits, SceneController& scene,
                                     StudyConnection& study, QObject* parent)
    : QObject(parent),
      ghost_(ghost),
      edits_(edits),
      scene_(scene),
      study_(study),
      strokes_([this] { return stored_ ? std::optional(stored_) : std::nullopt; },
               [](const std::shared_ptr<const replay::StoredStrokes>& stored, const auto&) {
                 return std::make_shared<const std::vector<RecordedStroke>>(replay::recordedStrokes(*stored));
               }),
      baseline_(
          [this]() -> std::optional<BaselineInputs> {
            wanted_before_ = before();
            if (strokes_.value() == nullptr || wanted_before_ == nullptr) return std::nullopt;
            return BaselineInputs{strokes_.value(), wanted_before_, conditions()};
          },
          [](const BaselineInputs& inputs, const auto& run) {
            auto out = std::make_shared<const replay::StrokeBaseline>(
                replay::baselineOf(inputs.strokes, inputs.before, inputs.conditions, run.stop));
            return run.stop.stop_requested() ? nullptr : out;
          }),
      compared_(
          [this]() -> std::optional<ComparedInputs> {
            if (baseline_.value() == nullptr || !scene_.model()) return std::nullopt;
            return ComparedInputs{baseline_.value(), scene_.shared()->shared, label()};
          },
          [](const ComparedInputs& inputs, const auto& run) {
            auto out = std::make_shared<const Shown>(
                Shown{inputs.baseline,
                      replay::compareStrokes(*inputs.baseline, *inputs.after, replay::Skip::kUnchanged, run.stop)});
            return run.stop.stop_requested() ? nullptr : out;
          }) {
  baseline_.needs(strokes_);
  compared_.needs(baseline_);
  connect(&edits_, &EditController::modelReset, this, &StrokesController::findSignOff);
  connect(&edits_, &EditController::historyChanged, this, &StrokesController::findSignOff);
  connect(&ghost_, &GhostController::changed, this, &StrokesController::onModels);
  connect(&scene_, &SceneController::modelChanged, this, &StrokesController::onModels);
  connect(&scene_, &SceneController::modelEdited, this, &StrokesController::onModels);
  connect(&scene_, &SceneController::valueChanged, this, &StrokesController::onValue);
  connect(&study_, &StudyConnection::opened, this, &StrokesController::onStudy);
  connect(&study_, &StudyConnection::closed, this, &StrokesController::onStudy);
  connect(&study_, &StudyConnection::contentsChanged, this, [this] {
    unread_ = true;
    read();
  });
  connect(&strokes_, &Computation::valueChanged, &baseline_, &Computation::refresh);
  connect(&baseline_, &Computation::valueChanged, &compared_, &Computation::refresh);
  connect(&compared_, &Computation::valueChanged, this, &StrokesController::onCompared);
  connect(&compared_, &Computation::changed, this, &StrokesController::changed);
}

void StrokesController::setSeen(bool seen) {
  if (seen == seen_) return;
  seen_ = seen;
  compared_.hold(*this, seen);
  read();
}

void StrokesController::onStudy() {
  stored_.reset();
  failure_.clear();
  shown_.reset();
  chosen_.reset();
  unread_ = true;
  strokes_.forget();
  baseline_.forget();
  compared_.forget();
  read();
  emit changed();
}

void StrokesController::read() {
  if (!seen_ || !unread_ || !study_.isOpen()) return;
  unread_ = false;
  const std::size_t number = ++reading_;
  study_.read(*this, [this, number](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto stored = replay::storedStrokes(file);
    auto found = stored ? std::make_shared<const replay::StoredStrokes>(*std::move(stored)) : nullptr;
    const QString failure = stored ? QString() : text(stored.error().message());
    return [this, number, found, failure] {
      if (number == reading_) onRead(found, failure);
    };
  });
}

void StrokesController::onRead(std::shared_ptr<const replay::StoredStrokes> stored, const QString& failure) {
  stored_ = std::move(stored);
  failure_ = failure;
  strokes_.refresh();
  emit changed();
}

void StrokesController::findSignOff() {
  const auto& events = edits_.history().events();
  const auto last = std::find_if(events.rbegin(), events.rend(),
                                 [](const editing::Event& one) { return one.kind == editing::EventKind::kSignOff; });
  if (last == events.rend()) {
    if (!std::exchange(signed_off_, std::nullopt)) return;
  } else {
    if (signed_off_ && signed_off_->event == last->id && signed_off_->model) return;
    const auto model = edits_.readyOf(last->state);
    const QDateTime when = QDateTime::fromMSecsSinceEpoch(last->stamp.utc_ms);
    signed_off_ =
        SignedOff{last->id,
                  tr("the sign-off of %1, %2")
                      .arg(harmless(text(last->stamp.author)), QLocale().toString(when, QLocale::ShortFormat)),
                  model ? *model : nullptr};
  }
  onModels();
}

void StrokesController::setAgainst(Against against) {
  if (std::exchange(against_, against) != against) onModels();
}

QString StrokesController::label() const {
  return against() == Against::kSignOff ? signed_off_->label : ghost_.label();
}

// The model before may change a moment after the present one, so what was asked for counts, not what is there.
void StrokesController::onModels() {
  if (before() != wanted_before_) {
    baseline_.refresh();  // the comparison follows
  } else if (!baseline_.isBusy()) {
    compared_.refresh();
  }
  emit changed();
}

// Strokes of the speed experiment have no conditions of their own.
void StrokesController::onValue(std::size_t input) {
  if (!isMovedByHand(scene_.model()->model.inputs[input]) && wantsConditions()) baseline_.refresh();
}

void StrokesController::onCompared() {
  const auto strokes = shown_ ? shown_->baseline->strokes : nullptr;
  shown_ = compared_.value();
  if (compared_.of()) label_ = compared_.of()->label;
  if (shown_ == nullptr || shown_->baseline->strokes != strokes) chosen_.reset();
  emit changed();
}

bool StrokesController::wantsConditions() const {
  const auto& strokes = strokes_.value();
  return strokes != nullptr && std::any_of(strokes->begin(), strokes->end(),
                                           [](const RecordedStroke& one) { return one.conditions.empty(); });
}

replay::Conditions StrokesController::conditions() const {
  replay::Conditions out;
  if (!wantsConditions()) return out;
  const auto& inputs = scene_.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isMovedByHand(inputs[i])) out[inputs[i].id] = scene_.value(i);
  }
  return out;
}

editing::SharedModel StrokesController::before() const {
  if (!scene_.model()) return nullptr;
  if (against() == Against::kSignOff) return signed_off_->model;
  if (!ghost_.isOn()) return nullptr;
  // Without an edit the model is compared with itself.
  return ghost_.before() ? ghost_.before()->shared : scene_.shared()->shared;
}

StrokesController::State StrokesController::state() const {
  if (!scene_.model()) return State::kNoModel;
  if (!study_.isOpen()) return State::kNoStudy;
  if (!failure_.isEmpty()) return State::kUnreadable;
  if (strokes_.value() != nullptr && strokes_.value()->empty()) return State::kNoStroke;
  if (against() == Against::kGhost && !ghost_.isOn()) return State::kGhostOff;
  if (shown_ == nullptr) return State::kWaiting;
  return shown_->comparison.strokes.empty() ? State::kNothing : State::kShown;
}

bool StrokesController::isOld() const { return compared_.isBusy() || baseline_.isBusy() || strokes_.isBusy(); }

const RecordedStroke& StrokesController::stroke(std::size_t place) const {
  return (*baseline().strokes)[comparison().strokes[place].stroke];
}

bool StrokesController::mayRecord() const { return !study_.isOpen() || study_.takesOrders(); }

QString StrokesController::nameOf(std::size_t place) const {
  const RecordedStroke& one = stroke(place);
  if (one.calculated) return tr("calculated stroke, recording %1").arg(one.recording_number);
  if (one.recording_number > 0) return tr("recording %1, stroke %2").arg(one.recording_number).arg(one.number);
  return tr("%1, %2 %3").arg(text(one.person), levelLabel(scene_.model()->model, one.level)).arg(one.number);
}

QString StrokesController::verdictOf(std::size_t place) const {
  const ComparedStroke& one = comparison().strokes[place];
  if (!one.numbers) {
    const auto& hole_mm = one.hole_mm[1] ? one.hole_mm[1] : one.hole_mm[0];
    return tr("no rule fires at %1 mm").arg(*hole_mm, 0, 'f', 0);
  }
  const double noticeable = one.numbers->noticeable;
  const QString sign = one.numbers->noticeable_by_n < 0 ? QStringLiteral("−") : QStringLiteral("+");
  return noticeable == 0 ? tr("no difference") : tr("%1%2 JND").arg(sign).arg(noticeable, 0, 'f', 1);
}

QString StrokesController::headline() const {
  const replay::StrokeSummary& summary = comparison().summary;
  QString holes;
  if (summary.holes > 0) {
    holes = tr("%n stroke(s) would meet a place where no rule fires.", nullptr, static_cast<int>(summary.holes));
  }
  if (!summary.worst) return holes.isEmpty() ? tr("No stroke has a force in both models.") : holes;
  if (!holes.isEmpty()) holes.prepend(QLatin1Char(' '));
  const auto& worst = *comparison().strokes[*summary.worst].numbers;
  const int compared = static_cast<int>(summary.compared);
  if (worst.noticeable == 0) return tr("%n stroke(s), and no force changes.", nullptr, compared) + holes;
  if (summary.felt == 0) {
    return tr("None of %n stroke(s) would feel different: at most %1 JND.", nullptr, compared)
               .arg(worst.noticeable, 0, 'f', 1) +
           holes;
  }
  return tr("Of %n stroke(s), %1 would feel different: %2 most, by %3 at %4 mm.", nullptr, compared)
             .arg(QString::number(summary.felt), nameOf(*summary.worst), verdictOf(*summary.worst),
                  QString::number(worst.noticeable_at_mm, 'f', 0)) +
         holes;
}

QString StrokesController::caption() const {
  QStringList parts;
  if (against() == Against::kSignOff || ghost_.before()) {
    parts << tr("Compared with: %1").arg(label_);
  } else {
    parts << tr("No edit yet: the model is compared with itself");
  }
  int without_force = 0;
  int simulated = 0;
  for (const ComparedStroke& one : comparison().strokes) {
    const RecordedStroke& recorded = (*baseline().strokes)[one.stroke];
    without_force += recorded.use == StrokeUse::kForceOff ? 1 : 0;
    simulated += recorded.simulated ? 1 : 0;
  }
  if (simulated == static_cast<int>(comparison().strokes.size())) {
    parts << tr("SIMULATED");
  } else if (simulated > 0) {
    parts << tr("%n stroke(s) SIMULATED", nullptr, simulated);
  }
  if (without_force > 0) {
    parts << tr("%n stroke(s) recorded with the force off: what they would meet", nullptr, without_force);
  }
  parts << tr(
      "Open loop: the recorded hand does not answer to the force, and peaks in fast strokes may differ by a "
      "factor of two");
  return parts.join(QStringLiteral(" · "));
}

QStringList StrokesController::leftOut() const {
  QStringList out;
  if (stored_ != nullptr) {
    for (const std::string& sentence : stored_->unreadable) out << text(sentence);
  }
  if (strokes_.value() == nullptr) return out;
  const auto count = [this](StrokeUse use) {
    const auto& strokes = *strokes_.value();
    return static_cast<int>(
        std::count_if(strokes.begin(), strokes.end(), [use](const RecordedStroke& one) { return one.use == use; }));
  };
  if (const int n = count(StrokeUse::kUnknownModel)) {
    out << tr("%n stroke(s) left out: felt on a model that the study does not keep.", nullptr, n);
  }
  if (const int n = count(StrokeUse::kSamplesLost)) {
    out << tr("%n stroke(s) left out: the recording is incomplete.", nullptr, n);
  }
  if (const int n = count(StrokeUse::kOtherForce)) {
    out << tr(
        "%n stroke(s) left out: their own model does not give the recorded force again. They were recorded with "
        "another version of the program, on a device that limits the spring, or during an edit.",
        nullptr, n);
  }
  if (shown_ != nullptr && shown_->baseline->refusal) {
    out << tr("Strokes are left out. %1").arg(text(shown_->baseline->refusal->message()));
  }
  return out;
}

QString StrokesController::numbersOf(std::size_t place) const {
  const ComparedStroke& one = comparison().strokes[place];
  QStringList lines{nameOf(place) + QStringLiteral(": ") + verdictOf(place)};
  if (!one.numbers) return lines.first();
  const replay::StrokeNumbers& numbers = *one.numbers;
  const std::string& unit = scene_.model()->model.output.unit;
  const auto force = [&](double force_n) { return forceText(force_n, unit); };
  lines << tr("peak %1, before %2").arg(force(numbers.peak_n[1]), force(numbers.peak_n[0]))
        << tr("largest difference %1 at %2 mm").arg(force(numbers.largest_n)).arg(numbers.largest_at_mm, 0, 'f', 0)
        << tr("root mean square %1").arg(force(numbers.rms_n))
        << tr("work of the push %1 mJ, before %2 mJ")
               .arg(numbers.work_mj[1], 0, 'f', 1)
               .arg(numbers.work_mj[0], 0, 'f', 1)
        << tr("above one JND in %1 % of the time, on %2 % of the way")
               .arg(100 * numbers.time_share, 0, 'f', 0)
               .arg(100 * numbers.path_share, 0, 'f', 0);
  return lines.join(QLatin1Char('\n'));
}

std::optional<std::size_t> StrokesController::chosen() const {
  if (!chosen_ || state() != State::kShown) return std::nullopt;
  const auto& strokes = comparison().strokes;
  const auto found = std::find_if(strokes.begin(), strokes.end(),
                                  [this](const ComparedStroke& one) { return one.stroke == *chosen_; });
  return found == strokes.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - strokes.begin()));
}

std::optional<study::RecordId> StrokesController::chosenRecording() const {
  const auto place = chosen();
  if (!place || stroke(*place).use == StrokeUse::kForceOff) return std::nullopt;
  return stroke(*place).recording;
}

void StrokesController::choose(std::size_t place) {
  chosen_ = comparison().strokes[place].stroke;
  emit chosenChanged();
}

void StrokesController::goTo(std::size_t place) {
  choose(place);
  const ComparedStroke& one = comparison().strokes[place];
  const replay::StrokeRun& run = *baseline().runs[one.stroke];
  const auto& inputs = scene_.model()->model.inputs;
  std::vector<double> point = scene_.values();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& conditions = stroke(place).conditions;
    if (const auto found = conditions.find(inputs[i].id); found != conditions.end()) point[i] = found->second;
    if (fuzzy::roleOf(inputs[i]) == fuzzy::Role::kWay) {
      const auto hole_mm = one.hole_mm[1] ? one.hole_mm[1] : one.hole_mm[0];
      point[i] = one.numbers ? one.numbers->largest_at_mm : *hole_mm;
    }
    if (fuzzy::roleOf(inputs[i]) != fuzzy::Role::kRate || !one.numbers) continue;
    // The speed at which the model was asked there.
    for (const replay::StrokeRun::Answer& answer : run.answers) {
      if (answer.tick <= one.numbers->largest_tick) point[i] = answer.point.speed_mm_s;
    }
  }
  scene_.goTo(point);
}

void StrokesController::showGhost() { ghost_.setOn(true); }

void StrokesController::replayChosen() {
  if (const auto recording = chosenRecording()) emit replayRequested(*recording);
}

}  // namespace tactus::workbench
