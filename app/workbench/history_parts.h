// Puts the versions of the model into the window: the panel History, its entries in the menu Edit, and the strip that
// says what is compared.
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
class StudyController;

class HistoryParts : public QObject {
  Q_OBJECT

 public:
  /// Before a model is opened. `menu` is the menu Edit.
  HistoryParts(MainWindow& window, QMenu& menu, EditController& edits, CompareController& compare,
               SceneController& scene, FeelController& feel, AuthorName& author);

  /// Offers what a crash left behind, opens `study` where it belongs to one, and says where work cannot be kept from
  /// the next one.
  void addRecovery(AutosaveController& autosave, RecoveryController& recovery, StudyController& study);
  /// The curves have the side that is not shown as their ghost while versions are compared.
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
