// Puts into the window what there is to say about the open study: what happened to it, what is odd in its data, and
// what the build says of its model.
#pragma once

#include <QObject>
#include <QVector>

#include "app/workbench/kit/notes.h"

class QAction;

namespace tactus::workbench {

class MainWindow;
class MembershipEditor;
class StudyConnection;
class StudyModels;
class StudyNoticeStrip;

class NoteParts : public QObject {
  Q_OBJECT

 public:
  NoteParts(MainWindow& window, StudyConnection& study, StudyModels& study_models, MembershipEditor& editor);

 private:
  void showNotes();
  void showNotices();
  /// Below the menu bar.
  void popUp(const QVector<NoteGroup>& groups);

  MainWindow& window_;
  StudyConnection& study_;
  StudyModels& study_models_;
  MembershipEditor& editor_;
  StudyNoticeStrip* strip_;
  QAction* notices_;
  QAction* data_;
  QAction* build_;
};

}  // namespace tactus::workbench
