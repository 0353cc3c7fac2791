// Adds editing to the window: the Edit menu, the membership function editor, the message after each edit, and the time
// from an edit to the screen.
#pragma once

#include <QObject>

class QAction;

namespace tactus::workbench {

class AuthorName;
class CompareController;
class EditController;
class FeelController;
class FrameClock;
class GhostController;
class HistoryPanel;
class MainWindow;
class MembershipEditor;
class Panel;
class SceneController;
class TermController;

// Adds the versions of the model to the window: the History panel, its entries in the menu Edit, and the strip that
// names the compared versions.

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

class EditParts : public QObject {
  Q_OBJECT

 public:
  EditParts(MainWindow& window, EditController& edits, TermController& terms, SceneController& scene,
            const GhostController& ghost);

  MembershipEditor& editor() { return *editor_; }
  Panel& panel() { return *panel_; }
  const FrameClock& clock() const { return *clock_; }

 private:
  void buildMenu();
  void showUndo();
  void say(const QString& sentence);

  MainWindow& window_;
  EditController& edits_;
  FrameClock* clock_;
  MembershipEditor* editor_;
  Panel* panel_;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
};

}  // namespace tactus::workbench
