// What the window shows of the selection: the editor of what was pointed at comes to the front, a chosen finding and a
// visited edit of the history select what they are about.
#pragma once

#include <QObject>

#include "app/editing/edit_history.h"

namespace tactus::workbench {

class EditController;
class EditParts;
class FindingsController;
class HistoryParts;
class MainWindow;
class Panel;
class Selection;
class TermController;

class SelectionParts : public QObject {
  Q_OBJECT

 public:
  SelectionParts(MainWindow& window, Selection& selection, TermController& terms, FindingsController& findings,
                 EditController& edits, HistoryParts& history, Panel& rule_editor, EditParts& edit_parts);

 private:
  void bringForward(Panel& editor);
  void showTerm();
  void selectChosen(const FindingsController& findings);
  void showEdit(editing::StateId state);

  MainWindow& window_;
  Selection& selection_;
  TermController& terms_;
  EditController& edits_;
};

}  // namespace tactus::workbench
