#include "app/workbench/controllers/edit_controller.h"

#include <chrono>
#include <utility>

#include "app/workbench/display_text.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

constexpr int kFrameMs = 16;  // a refresh of the screen at 60 Hz; more often nobody sees
constexpr auto kAuthor = "researcher";

}  // namespace

EditController::EditController(ModelController& models, QObject* parent) : QObject(parent), models_(models) {
  frame_.setSingleShot(true);
  frame_.setInterval(kFrameMs);
  frame_.setTimerType(Qt::PreciseTimer);
  // What an edit does to the force is looked at after the screen shows it.
  report_.setSingleShot(true);
  report_.setInterval(0);
  connect(&frame_, &QTimer::timeout, this, [this] {
    if (due_) send();
  });
  connect(&report_, &QTimer::timeout, this, &EditController::report);
  connect(&models_, &ModelController::opened, this, &EditController::adoptModel);
  if (models_.current()) adoptModel();
}

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
  history_->update(std::move(*edit));
  schedule();
  return true;
}

void EditController::commit() {
  if (!inGesture()) return;
  stopped_.clear();
  const auto state = history_->commit(stamp());
  send();
  if (!state) return;
  emit historyChanged();
  report_.start();
}

void EditController::cancel() {
  if (!inGesture()) return;
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
  const QString why = text(edit->stopped);
  const auto state = history_->apply(std::move(*edit), stamp());
  send();
  if (state) {
    emit historyChanged();
    report_.start();
  }
  if (!why.isEmpty()) emit refused(tr("It went as far as it can: stopped by %1.").arg(why));
  return true;
}

void EditController::refuse(const QString& sentence) { emit refused(sentence); }

QString EditController::undoText() const {
  return history_ && history_->canUndo() ? text(history_->labelOf(history_->current())) : QString();
}

QString EditController::redoText() const {
  return canRedo() ? text(history_->labelOf(*history_->states()[history_->current()].redo)) : QString();
}

std::vector<EditController::Entry> EditController::entries() {
  std::vector<Entry> out;
  if (!history_) return out;
  for (const editing::StateId state : history_->line()) {
    out.push_back({state, text(history_->labelOf(state)), effectOf(state), state == history_->current()});
  }
  return out;
}

void EditController::undo() {
  if (!canUndo()) return;
  commit();
  const QString what = undoText();
  settle(history_->undo(stamp()), tr("Undone: %1").arg(what));
}

void EditController::redo() {
  if (!canRedo()) return;
  commit();
  const QString what = redoText();
  settle(history_->redo(stamp()), tr("Done again: %1").arg(what));
}

void EditController::returnTo(editing::StateId state) {
  TACTUS_CHECK(isOpen());
  commit();
  if (state == history_->current()) return;
  settle(history_->returnTo(state, stamp()), tr("Back to: %1").arg(text(history_->labelOf(state))));
}

void EditController::adoptModel() {
  due_ = false;
  frame_.stop();
  report_.stop();
  stopped_.clear();
  const OpenModel& open = *models_.current();
  auto history = editing::EditHistory::open(open.model, tr("Opened").toStdString(), stamp(), study::RecordIds());
  // The model that is open was compiled, so it is valid.
  TACTUS_CHECK(history.has_value());
  history_ = std::move(*history);
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
  models_.edit(history_->model(), history_->compiled());
  emit changed();
}

void EditController::settle(const base::Result<void>& moved, const QString& sentence) {
  if (!moved) {
    refuse(text(moved.error().message()));
    return;
  }
  report_.stop();
  send();
  emit historyChanged();
  emit reported(sentence);
}

void EditController::report() {
  const editing::StateId state = history_->current();
  const QString effect = effectOf(state);
  const QString label = text(history_->labelOf(state));
  emit reported(effect.isEmpty() ? label : label + QStringLiteral(" · ") + effect);
  emit historyChanged();
}

editing::Stamp EditController::stamp() const {
  using std::chrono::duration_cast;
  using std::chrono::milliseconds;
  return {kAuthor, duration_cast<milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count()};
}

QString EditController::effectOf(editing::StateId state) {
  const auto impact = history_->impact(state);
  if (!impact) return {};
  QString out = impact->largest_n == 0
                    ? tr("no change of the force")
                    : tr("max ΔF %1 (%2 JND)")
                          .arg(forceText(impact->largest_n, model().output.unit), numberText(impact->noticeable, 1));
  if (impact->opened > 0) out += tr(" · leaves places without a force");
  return out;
}

}  // namespace tactus::workbench
