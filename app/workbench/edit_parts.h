// Adds editing to the window: the Edit menu, the membership function editor, the message after each edit, and the time
// from an edit to the screen.
#pragma once

#include <QObject>

class QAction;

namespace tactus::workbench {

class EditController;
class FrameClock;
class GhostController;
class MainWindow;
class MembershipEditor;
class Panel;
class SceneController;
class TermController;

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
