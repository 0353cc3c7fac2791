#include "app/workbench/tune/history/recovery_controller.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "app/editing/same_bits.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/study_path.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "core/base/check.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {

RecoveryController::RecoveryController(ModelController& models, EditController& edits, AutosaveController& autosave,
                                       QString root, QObject* parent)
    : QObject(parent), models_(models), edits_(edits), autosave_(autosave), root_(std::move(root)) {
  connect(&models_, &ModelController::opened, this, &RecoveryController::onOpened);
  connect(&autosave_, &AutosaveController::written, this, &RecoveryController::onWritten);
  // A document that was left before its autosave was written: the files keep what it had, free for the next scan.
  connect(&edits_, &EditController::modelReset, this, [this] { replaced_.clear(); });
  scan();
}

std::optional<LostWork> RecoveryController::offered() const {
  return offered_.empty() ? std::nullopt : std::optional(offered_.front());
}

void RecoveryController::scan() {
  offered_ = lostWork(root_);
  std::erase_if(offered_, [&](const LostWork& work) { return put_off_.contains(work.folder); });
  // What belongs to the open document comes first.
  if (models_.current()) {
    std::stable_partition(offered_.begin(), offered_.end(),
                          [&](const LostWork& work) { return work.document == models_.current()->path; });
  }
  emit offerChanged();
}

void RecoveryController::onOpened() {
  if (busy_) return;
  const QString& path = models_.current()->path;
  for (const LostWork& work : lostWork(root_)) {
    if (work.document == path) put_off_.removeAll(work.folder);
  }
  scan();
  // The history of the study follows the model.
  if (wanted_ == path) QTimer::singleShot(0, this, &RecoveryController::restore);
}

void RecoveryController::restore() {
  if (busy_ || offered_.empty()) return;
  const LostWork& work = offered_.front();
  // A study file keeps the history of its models itself.
  const bool in_study = isStudyPath(work.document);
  if (in_study && (!models_.current() || models_.current()->path != work.document)) {
    wanted_ = work.document;
    emit studyNeeded(work.document);
    return;
  }
  wanted_.clear();
  auto taken = TakenWork::take(work);
  if (!taken) {
    drop();
    emit failed(text(taken.error().message()));
    return;
  }
  busy_ = true;
  taken_ = std::move(*taken);
  emit offerChanged();
  worker_.post([this, taken = taken_, stamp = edits_.stamp(), in_study] {
    const auto found = std::make_shared<base::Result<Found>>(read(*taken, stamp, in_study));
    answers_.post([this, found] { adopt(std::move(*found)); });
  });
}

base::Result<RecoveryController::Found> RecoveryController::read(const TakenWork& taken, const editing::Stamp& stamp,
                                                                 bool in_study) {
  auto autosave = taken.read();
  if (!autosave) return tl::unexpected(autosave.error());
  Found out{std::move(*autosave), {}};
  if (in_study) return out;
  auto history = editing::recovered({}, out.autosave, study::RecordIds(), stamp);
  if (!history) return tl::unexpected(history.error());
  out.history = std::move(*history);
  return out;
}

void RecoveryController::adopt(base::Result<Found> found) {
  const LostWork work = offered_.front();
  const auto taken = std::exchange(taken_, nullptr);
  if (!found) {
    busy_ = false;
    put_off_.append(work.folder);
    drop();
    emit failed(tr("The edits of %1 cannot be restored and stay where they are: %2")
                    .arg(shownFileName(work.document), text(found.error().message())));
    return;
  }
  if (found->history) {
    begin(work, std::move(*found->history));
  } else {
    goOn(found->autosave);
  }
  replaced_.push_back({taken, autosave_.flush()});
  busy_ = false;
  drop();
  emit restored(tr("Restored: %1, edits: %2, with their history.").arg(shownFileName(work.document)).arg(work.edits));
}

void RecoveryController::begin(const LostWork& work, editing::EditHistory history) {
  if (!models_.current() || models_.current()->path != work.document) {
    if (auto open = readOpenModel(work.document)) {
      models_.openRead(std::move(*open));
    } else {
      // The file is gone or damaged; the history has every state of it.
      OpenModel from_history(history.ready());
      from_history.path = work.document;
      from_history.simulated = saysSimulated(from_history.model);
      models_.openUnsaved(std::move(from_history));
    }
  }
  edits_.adopt(std::move(history));
}

// The study has everything but the last moments, which follow as edits of what it has.
void RecoveryController::goOn(const editing::Autosave& autosave) {
  const auto show = [&](const fuzzy::ForceModel& model, const std::string& label) {
    if (!editing::sameBits(model, edits_.model())) edits_.apply(editing::finished(model, label));
  };
  const auto known = edits_.history().events();
  for (const study::ModelVersion& version : autosave.versions) {
    const bool stored =
        std::any_of(known.begin(), known.end(), [&](const editing::Event& event) { return event.id == version.id; });
    if (stored) continue;
    const auto model = model_io::parseModel(version.text, "autosave");
    TACTUS_CHECK(model.has_value());  // parseAutosave read it
    const auto colon = version.label.find(": ");
    const std::string kind = version.label.substr(0, colon);
    const std::string label = colon == std::string::npos ? version.label : version.label.substr(colon + 2);
    show(model->model, label);
    if (kind == editing::name(editing::EventKind::kSnapshot)) edits_.snapshot(text(label));
    if (kind == editing::name(editing::EventKind::kSignOff)) edits_.signOff(text(version.author));
  }
  if (autosave.unfinished)
    show(autosave.unfinished->model, tr("%1 (recovered)").arg(text(autosave.unfinished->label)).toStdString());
}

// An autosave that was begun before the work was restored does not hold it.
void RecoveryController::onWritten(quint64 number) {
  for (const Replaced& replaced : replaced_) {
    if (replaced.number <= number) replaced.work->discard();
  }
  std::erase_if(replaced_, [number](const Replaced& replaced) { return replaced.number <= number; });
}

void RecoveryController::discard() {
  if (busy_ || offered_.empty()) return;
  auto taken = TakenWork::take(offered_.front());
  if (taken) (*taken)->discard();
  const QString failure = taken ? QString() : text(taken.error().message());
  drop();
  if (!failure.isEmpty()) emit failed(failure);
}

void RecoveryController::later() {
  if (busy_ || offered_.empty()) return;
  put_off_.append(offered_.front().folder);
  drop();
}

void RecoveryController::drop() {
  offered_.erase(offered_.begin());
  emit offerChanged();
}

}  // namespace tactus::workbench
