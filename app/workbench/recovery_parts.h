// Adds the way back after a crash to the window: the strip that offers the work that was left behind, and what helps
// where it is not restored or the history of the edits is not kept.
#pragma once

#include <QObject>

namespace tactus::workbench {

class AutosaveController;
class EditController;
class MainWindow;
class ModelFiles;
class RecoveryController;
class StudyConnection;

class RecoveryParts : public QObject {
  Q_OBJECT

 public:
  /// Opens `study` if the work belongs to it, and warns if work cannot be autosaved.
  RecoveryParts(MainWindow& window, ModelFiles& files, AutosaveController& autosave, RecoveryController& recovery,
                EditController& edits, StudyConnection& study);

 private:
  void connectRecovery(EditController& edits, StudyConnection& study);
  void connectAutosave();

  MainWindow& window_;
  ModelFiles& files_;
  AutosaveController& autosave_;
  RecoveryController& recovery_;
};

}  // namespace tactus::workbench
