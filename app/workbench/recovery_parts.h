// Adds the way back after a crash to the window: the strip that offers the work that was left behind.
#pragma once

namespace tactus::workbench {

class AutosaveController;
class EditController;
class MainWindow;
class ModelFiles;
class RecoveryController;
class StudyConnection;

class RecoveryParts {
 public:
  /// Opens `study` if the work belongs to it, and warns if work cannot be autosaved.
  RecoveryParts(MainWindow& window, ModelFiles& files, AutosaveController& autosave, RecoveryController& recovery,
                EditController& edits, StudyConnection& study);
};

}  // namespace tactus::workbench
