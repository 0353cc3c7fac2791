// Adds the versions of the model to the window: the History panel, its entries in the menu Edit, and the strip that
// names the compared versions.
#pragma once

#include <QObject>

#include "app/workbench/tune/history/recovery_controller.h"

class QAction;
class QDockWidget;
class QMenu;

namespace tactus::workbench {

class AuthorName;
class AutosaveController;
class CompareController;
class EditController;
class FeelController;
class GhostController;
class HistoryPanel;
class MainWindow;
class SceneController;
class StudyConnection;

class HistoryParts : public QObject {
  Q_OBJECT

 public:
  /// Create before a model is opened. `menu` is the menu Edit.
  HistoryParts(MainWindow& window, QMenu& menu, EditController& edits, CompareController& compare,
               SceneController& scene, FeelController& feel, AuthorName& author);

  /// Offers work that a crash left behind, opens `study` if the work belongs to it, and warns if work cannot be
  /// autosaved.
  void addRecovery(AutosaveController& autosave, RecoveryController& recovery, StudyConnection& study);
  /// While versions are compared, the curves show the hidden side as their ghost.
  void addGhost(GhostController& ghost);

 private:
  void buildMenu(QMenu& menu);
  void reveal(void (HistoryPanel::*ask)());
  void showActions();

  MainWindow& window_;
  EditController& edits_;
  CompareController& compare_;
  HistoryPanel* panel_;
  QDockWidget* dock_;
  QAction* snapshot_ = nullptr;
  QAction* sign_off_ = nullptr;
  QAction* compare_sides_ = nullptr;
  QAction* end_ = nullptr;
  QAction* author_ = nullptr;
};

}  // namespace tactus::workbench
