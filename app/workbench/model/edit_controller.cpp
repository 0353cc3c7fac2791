#include "app/workbench/model/edit_controller.h"

#include <chrono>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/shown_impact.h"
#include "core/base/check.h"
#include "core/base/error.h"

namespace tactus::workbench {
namespace {

constexpr int kFrameMs = 16;         // one refresh of the screen at 60 Hz; more often is not visible
constexpr auto kNobody = "unnamed";  // the author is unknown

}  // namespace

EditController::EditController(ModelController& models, QObject* parent) : QObject(parent), models_(models) {
  frame_.setSingleShot(true);
  frame_.setInterval(kFrameMs);
  frame_.setTimerType(Qt::PreciseTimer);
  // What an edit does to the force is looked at after the screen shows it.
  report_.setSingleShot(true);
  report_.setInterval(0);
  connect(&frame_, &QTimer::timeout, this, [this] {
    if (!due_) return;
    emit sending();
    send();
  });
  connect(&report_, &QTimer::timeout, this, &EditController::report);
  connect(&models_, &ModelController::opened, this, &EditController::adoptModel);
  if (models_.current()) adoptModel();
}

void EditController::markStored(const study::RecordId& id) {
  if (!history_) return;
  history_->markStored(id);
  emit stored();
}

void EditController::adopt(editing::EditHistory history, VersionReader read) {
  TACTUS_CHECK(isOpen());
  begin(std::move(history), std::move(read));
  if (!editing::sameBits(models_.current()->model, history_->model())) {
    models_.edit(history_->ready());
  }
  emit modelReset();
  emit changed();
  emit historyChanged();
}

base::Result<editing::SharedModel> EditController::readyOf(editing::StateId state) {
  TACTUS_CHECK(isOpen());
  if (auto there = fetch(state); !there) return tl::unexpected(there.error());
  return history_->readyOf(state);
}

void EditController::setAuthor(const QString& name) { author_ = name.trimmed(); }

void EditController::begin() {
  commit();
  stopped_.clear();
  history_->begin();
}

bool EditController::update(base::Result<editing::Edit> edit) {
  if (!edit) {
    refuse(text(edit.error().message()));
    return false;
  }
  stopped_ = text(edit->stopped);
  if (!frame_.isActive()) emit sending();
  history_->update(std::move(*edit));
  schedule();
  return true;
}

void EditController::commit() {
  if (!inGesture()) return;
  emit sending();
  stopped_.clear();
  const auto state = history_->commit(stamp());
  send();
  if (!state) return;
  emit historyChanged();
  report_.start();
}

void EditController::cancel() {
  if (!inGesture()) return;
  emit sending();
  stopped_.clear();
  history_->cancel();
  send();
}

bool EditController::apply(base::Result<editing::Edit> edit) {
  commit();
  if (!edit) {
    refuse(text(edit.error().message()));
    return false;
  }
  emit sending();
  const QString why = text(edit->stopped);
  const auto state = history_->apply(std::move(*edit), stamp());
  send();
  if (state) {
    emit historyChanged();
    report_.start();
  }
  if (!why.isEmpty()) emit refused(tr("The move stopped at its limit: %1.").arg(why));
  return true;
}

void EditController::refuse(const QString& sentence) { emit refused(sentence); }

QString EditController::undoText() const {
  return history_ && history_->canUndo() ? text(history_->labelOf(history_->current())) : QString();
}

QString EditController::redoText() const {
  return canRedo() ? text(history_->labelOf(*history_->states()[history_->current()].redo)) : QString();
}

void EditController::undo() {
  if (!canUndo()) return;
  commit();
  const QString what = undoText();
  auto there = fetch(history_->states()[history_->current()].parent);
  settle(there ? history_->undo(stamp()) : there, tr("Undone: %1").arg(what));
}

void EditController::redo() {
  if (!canRedo()) return;
  commit();
  const QString what = redoText();
  auto there = fetch(history_->states()[history_->current()].redo);
  settle(there ? history_->redo(stamp()) : there, tr("Redone: %1").arg(what));
}

void EditController::returnTo(editing::StateId state) {
  TACTUS_CHECK(isOpen());
  commit();
  // What was chosen may have been a state of another history.
  if (state == history_->current() || state >= history_->states().size()) return;
  auto there = fetch(state);
  settle(there ? history_->returnTo(state, stamp()) : there, tr("Back to: %1").arg(text(history_->labelOf(state))));
}

// Has a state in memory, or says why not.
base::Result<void> EditController::fetch(std::optional<editing::StateId> state) {
  const auto missing = state ? history_->missing(*state) : std::nullopt;
  if (!missing || !read_version_) return {};
  TACTUS_TRY(const auto version, read_version_(*missing));
  return editing::provideVersion(*history_, *state, version);
}

void EditController::begin(editing::EditHistory history, VersionReader read) {
  due_ = false;
  frame_.stop();
  report_.stop();
  stopped_.clear();
  history_ = std::move(history);
  read_version_ = std::move(read);
}

void EditController::snapshot(const QString& name) {
  if (!isOpen() || name.trimmed().isEmpty()) return;
  commit();
  history_->snapshot(name.trimmed().toStdString(), stamp());
  emit historyChanged();
  emit reported(tr("Snapshot “%1” of: %2").arg(name.trimmed(), text(history_->labelOf(history_->current()))));
}

void EditController::signOff(const QString& who, const std::optional<editing::Felt>& felt) {
  if (!isOpen() || who.trimmed().isEmpty()) return;
  commit();
  editing::Stamp signed_by = stamp();
  signed_by.author = who.trimmed().toStdString();
  history_->signOff(signed_by, felt.value_or(felt_));
  emit historyChanged();
  emit reported(tr("%1: %2").arg(who.trimmed(), text(history_->events().back().label)));
}

void EditController::repeatSignOff(const QString& who, const std::string& label) {
  if (!isOpen()) return;
  commit();
  editing::Stamp signed_by = stamp();
  signed_by.author = who.trimmed().toStdString();
  history_->repeatSignOff(signed_by, label);
  emit historyChanged();
}

void EditController::setFelt(editing::Felt felt) {
  if (felt == felt_) return;
  felt_ = std::move(felt);
  emit feltChanged();
}

void EditController::adoptModel() {
  begin(editing::EditHistory::open(models_.current()->shared, tr("Opened").toStdString(), stamp(), study::RecordIds()),
        {});
  emit modelReset();
  emit historyChanged();
}

void EditController::schedule() {
  due_ = true;
  if (!frame_.isActive()) send();
}

void EditController::send() {
  due_ = false;
  frame_.start();
  models_.edit(history_->ready());
  emit changed();
}

void EditController::settle(const base::Result<void>& moved, const QString& sentence) {
  if (!moved) {
    refuse(text(moved.error().message()));
    return;
  }
  report_.stop();
  emit sending();
  send();
  emit historyChanged();
  emit reported(sentence);
}

void EditController::report() {
  emit reporting();
  const editing::StateId state = history_->current();
  const QString effect = effectOf(state);
  const QString label = text(history_->labelOf(state));
  emit reported(effect.isEmpty() ? label : label + QStringLiteral(" · ") + effect);
  emit historyChanged();
}

editing::Stamp EditController::stamp() const {
  using std::chrono::duration_cast;
  using std::chrono::milliseconds;
  return {author_.isEmpty() ? kNobody : author_.toStdString(),
          duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count()};
}

QString EditController::effectOf(editing::StateId state) {
  const auto impact = impactOf(state);
  return impact ? impactText(*impact, model().output.unit) : QString();
}

std::optional<editing::EditImpact> EditController::impactOf(editing::StateId state) {
  // Both models have to be in memory; a list of states asks again when one was read.
  if (!history_->states()[state].impact && (!fetch(state) || !fetch(history_->states()[state].parent))) return {};
  return history_->impact(state);
}

void EditController::include(const editing::GhostCurve& curve, std::size_t input, std::span<const double> point) {
  if (!history_ || inGesture()) return;
  if (history_->include(history_->current(), curve, input, point)) {
    // The curve may be computed while the screen is painted.
    QMetaObject::invokeMethod(this, &EditController::effectsChanged, Qt::QueuedConnection);
  }
}

}  // namespace tactus::workbench
