#include "app/workbench/history_parts.h"

#include <QAction>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_panel.h"

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

}  // namespace tactus::workbench
