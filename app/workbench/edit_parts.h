// Adds editing to the window: the Edit menu, the membership function editor, the message after each edit, and the time
// from an edit to the screen.
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace tactus::workbench {

class EditController;
class FrameClock;
class MainWindow;
class MembershipEditor;
class SceneController;
class TermController;

class EditParts : public QObject {
  Q_OBJECT

 public:
  /// Create before a model is opened: a stage gets its layout at its first use.
  EditParts(MainWindow& window, EditController& edits, TermController& terms, SceneController& scene);

  MembershipEditor& editor() { return *editor_; }
  /// The menu Edit.
  QMenu& menu() { return *menu_; }

 private:
  void buildMenu();
  void addPanels(TermController& terms, SceneController& scene);
  void showUndo();
  void say(const QString& sentence);

  MainWindow& window_;
  EditController& edits_;
  FrameClock* clock_;
  MembershipEditor* editor_ = nullptr;
  QMenu* menu_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
};

}  // namespace tactus::workbench
