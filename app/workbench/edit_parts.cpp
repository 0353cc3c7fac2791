#include "app/workbench/edit_parts.h"

#include <QAction>

#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/undo_keys.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kLongestAction = 60;  // characters of a label in the menu

// `Undo: Insertion depth / Nasopharynx: right foot 125 to 132 mm`, cut where a menu would get too wide.
QString actionText(const QString& action, const QString& label) {
  if (label.isEmpty()) return action;
  QString shown = label.size() > kLongestAction ? label.left(kLongestAction - 1) + QStringLiteral("…") : label;
  return action + QStringLiteral(": ") + shown.replace(QLatin1Char('&'), QLatin1String("&&"));
}

}  // namespace

EditParts::EditParts(MainWindow& window, EditController& edits, TermController& terms, SceneController& scene,
                     const GhostController& ghost)
    : window_(window),
      edits_(edits),
      clock_(new FrameClock(window.panels(), this)),
      editor_(new MembershipEditor(edits, terms, scene, ghost)),
      panel_(&window.addPanel(QStringLiteral("membership_editor"), tr("Membership function editor"), editor_)) {
  buildMenu();
  connect(undo_, &QAction::triggered, &edits_, &EditController::undo);
  connect(redo_, &QAction::triggered, &edits_, &EditController::redo);
  connect(&edits_, &EditController::historyChanged, this, &EditParts::showUndo);
  connect(&edits_, &EditController::reported, this, &EditParts::say);
  connect(&edits_, &EditController::refused, this, &EditParts::say);
  connect(&edits_, &EditController::sending, clock_, &FrameClock::begin);
  connect(&edits_, &EditController::changed, clock_, &FrameClock::sent);
  auto* const shown_time = new FrameStatus(*clock_);
  window_.strip().setFrameTime(shown_time);
  connect(&window_, &MainWindow::entered, shown_time, [shown_time](Stage stage) {
    if (stage == Stage::kAgree) shown_time->hide();  // the labs have a clock of their own
  });
  new UndoKeys(this);
  showUndo();
}

void EditParts::buildMenu() {
  undo_ = window_.menus().addAction(MenuSlot::kEditUndo, tr("&Undo"), Qt::CTRL | Qt::Key_Z);
  redo_ = window_.menus().addAction(MenuSlot::kEditUndo, tr("&Redo"), Qt::CTRL | Qt::SHIFT | Qt::Key_Z);
  redo_->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
}

void EditParts::showUndo() {
  undo_->setEnabled(edits_.canUndo());
  undo_->setText(actionText(tr("&Undo"), edits_.undoText()));
  redo_->setEnabled(edits_.canRedo());
  redo_->setText(actionText(tr("&Redo"), edits_.redoText()));
}

void EditParts::say(const QString& sentence) { window_.say(sentence); }

}  // namespace tactus::workbench
