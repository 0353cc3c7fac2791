#include "app/workbench/history_parts.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/kit/message_banner.h"
#include "app/workbench/main_window.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/history/recovery_strip.h"

namespace tactus::workbench {

HistoryParts::HistoryParts(MainWindow& window, QMenu& menu, EditController& edits, CompareController& compare,
                           SceneController& scene, FeelController& feel, AuthorName& author)
    : window_(window),
      edits_(edits),
      compare_(compare),
      panel_(new HistoryPanel(edits, compare, scene, author)),
      dock_(window.panels().addPanel(QStringLiteral("history"), tr("History"), panel_)) {
  auto* strip = new CompareStrip(compare);
  window.addStrip(strip);
  connect(&feel, &FeelController::stateChanged, strip, [strip, &feel] { strip->setFelt(feel.isRunning()); });
  buildMenu(menu);
  connect(&edits_, &EditController::modelReset, this, &HistoryParts::showActions);
  connect(&compare_, &CompareController::shownChanged, this, &HistoryParts::showActions);
  connect(&compare_, &CompareController::said, &edits_, &EditController::reported);
  connect(&compare_, &CompareController::refused, &edits_, &EditController::refused);
  showActions();
}

void HistoryParts::addRecovery(AutosaveController& autosave, RecoveryController& recovery, StudyConnection& study) {
  auto* strip = new RecoveryStrip(recovery);
  window_.addStrip(strip);
  connect(strip, &RecoveryStrip::restoreRequested, this, [this, &recovery] {
    if (window_.mayLoseChanges()) recovery.restore();
  });
  connect(&recovery, &RecoveryController::studyNeeded, &study, &StudyConnection::open);
  connect(&recovery, &RecoveryController::restored, &edits_, &EditController::reported);
  connect(&recovery, &RecoveryController::failed, &window_.banner(), &MessageBanner::showError);
  connect(&autosave, &AutosaveController::failed, &window_.banner(), &MessageBanner::showError);
}

void HistoryParts::addGhost(GhostController& ghost) {
  connect(&compare_, &CompareController::shownChanged, &ghost, [this, &ghost] {
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
  });
}

void HistoryParts::buildMenu(QMenu& menu) {
  menu.addSeparator();
  snapshot_ = menu.addAction(tr("&Name this state…"));
  snapshot_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_N);
  sign_off_ = menu.addAction(tr("&Sign off by an expert…"));
  sign_off_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_G);
  menu.addSeparator();
  compare_sides_ = menu.addAction(tr("&Compare: switch between A and B"));
  compare_sides_->setShortcut(Qt::CTRL | Qt::Key_B);
  end_ = menu.addAction(tr("&End the comparison"));
  end_->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_B);
  menu.addSeparator();
  author_ = menu.addAction(tr("&Your name…"));
  connect(snapshot_, &QAction::triggered, this, [this] { reveal(&HistoryPanel::askSnapshot); });
  connect(sign_off_, &QAction::triggered, this, [this] { reveal(&HistoryPanel::askSignOff); });
  connect(author_, &QAction::triggered, this, [this] { reveal(&HistoryPanel::askAuthor); });
  connect(compare_sides_, &QAction::triggered, &compare_, &CompareController::toggle);
  connect(end_, &QAction::triggered, &compare_, &CompareController::end);
}

void HistoryParts::reveal(void (HistoryPanel::*ask)()) {
  dock_->show();
  dock_->raise();
  (panel_->*ask)();
}

void HistoryParts::showActions() {
  for (QAction* action : {snapshot_, sign_off_, compare_sides_, author_}) action->setEnabled(edits_.isOpen());
  end_->setEnabled(compare_.shown().has_value());
}

}  // namespace tactus::workbench
