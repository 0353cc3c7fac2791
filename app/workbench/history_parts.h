// Adds the versions of the model to the window: the History panel, its entries in the menu Edit, and the strip that
// names the compared versions.
#pragma once

#include <QObject>

class QAction;

namespace tactus::workbench {

class AuthorName;
class CompareController;
class EditController;
class FeelController;
class GhostController;
class HistoryPanel;
class MainWindow;
class Panel;
class SceneController;

class HistoryParts : public QObject {
  Q_OBJECT

 public:
  HistoryParts(MainWindow& window, EditController& edits, CompareController& compare, SceneController& scene,
               FeelController& feel, AuthorName& author, GhostController& ghost);

  HistoryPanel& view() { return *view_; }
  Panel& panel() { return *panel_; }
  /// Shows the panel with the focus in the field for a sign-off.
  void askSignOff();

 private:
  void buildMenu();
  void showHiddenSide(GhostController& ghost);
  void reveal(void (HistoryPanel::*ask)());
  void showActions();

  MainWindow& window_;
  EditController& edits_;
  CompareController& compare_;
  HistoryPanel* view_;
  Panel* panel_;
  QAction* snapshot_ = nullptr;
  QAction* sign_off_ = nullptr;
  QAction* compare_sides_ = nullptr;
  QAction* end_ = nullptr;
  QAction* author_ = nullptr;
};

}  // namespace tactus::workbench
