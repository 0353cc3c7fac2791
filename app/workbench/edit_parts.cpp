#include "app/workbench/edit_parts.h"

#include <QAction>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/undo_keys.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {

HistoryParts::HistoryParts(MainWindow& window, EditController& edits, CompareController& compare,
                           SceneController& scene, FeelController& feel, AuthorName& author, GhostController& ghost)
    : window_(window),
      edits_(edits),
      compare_(compare),
      view_(new HistoryPanel(edits, compare, scene, author)),
      panel_(&window.addPanel(QStringLiteral("history"), tr("History"), view_)) {
  auto* strip = new CompareStrip(compare);
  window.addStrip(strip);
  connect(&feel, &FeelController::stateChanged, strip, [strip, &feel] { strip->setFelt(feel.isRunning()); });
  new FeltState(feel, scene, edits, this);
  buildMenu();
  connect(&edits_, &EditController::modelReset, this, &HistoryParts::showActions);
  connect(&compare_, &CompareController::shownChanged, this, &HistoryParts::showActions);
  // While versions are compared, the curves show the hidden side as their ghost.
  connect(&compare_, &CompareController::shownChanged, &ghost, [this, &ghost] { showHiddenSide(ghost); });
  connect(&compare_, &CompareController::said, &edits_, &EditController::reported);
  connect(&compare_, &CompareController::refused, &edits_, &EditController::refused);
  showActions();
}

void HistoryParts::showHiddenSide(GhostController& ghost) {
  const auto shown = compare_.shown();
  if (!shown) {
    ghost.clearReference();
    return;
  }
  const CompareSide hidden = *shown == CompareSide::kA ? CompareSide::kB : CompareSide::kA;
  const auto model = compare_.modelOf(hidden);
  const auto set = model ? ghost.setReference(*model, compare_.nameOf(compare_.choice(hidden)))
                         : base::Result<void>(tl::unexpected(model.error()));
  if (!set) window_.say(text(set.error().message()));
}

void HistoryParts::buildMenu() {
  WindowMenus& menus = window_.menus();
  snapshot_ = menus.addAction(MenuSlot::kEditStates, tr("&Name this state…"), Qt::CTRL | Qt::SHIFT | Qt::Key_N);
  sign_off_ = menus.addAction(MenuSlot::kEditStates, tr("&Sign off by an expert…"), Qt::CTRL | Qt::SHIFT | Qt::Key_G);
  compare_sides_ =
      menus.addAction(MenuSlot::kEditCompare, tr("&Compare: switch between A and B"), Qt::CTRL | Qt::Key_B);
  end_ = menus.addAction(MenuSlot::kEditCompare, tr("&End the comparison"), Qt::CTRL | Qt::SHIFT | Qt::Key_B);
  author_ = menus.addAction(MenuSlot::kEditAuthor, tr("Enter &your name…"));
  connect(snapshot_, &QAction::triggered, this, [this] { reveal(&HistoryPanel::askSnapshot); });
  connect(sign_off_, &QAction::triggered, this, &HistoryParts::askSignOff);
  connect(author_, &QAction::triggered, this, [this] { reveal(&HistoryPanel::askAuthor); });
  connect(compare_sides_, &QAction::triggered, &compare_, &CompareController::toggle);
  connect(end_, &QAction::triggered, &compare_, &CompareController::end);
}

void HistoryParts::askSignOff() { reveal(&HistoryPanel::askSignOff); }

void HistoryParts::reveal(void (HistoryPanel::*ask)()) {
  panel_->reveal();
  (view_->*ask)();
}

void HistoryParts::showActions() {
  for (QAction* action : {snapshot_, sign_off_, compare_sides_, author_}) action->setEnabled(edits_.isOpen());
  end_->setEnabled(compare_.shown().has_value());
}

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
