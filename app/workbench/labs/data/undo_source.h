// What a lab's buttons and Ctrl+Z take back: corrections of records, or edits of a measurement.
#pragma once

#include <QObject>
#include <QString>

namespace tactus::workbench {

/// Thread: gui.
class UndoSource : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual bool canUndo() const = 0;
  virtual bool canRedo() const = 0;
  /// What the next undo or redo is about; empty if there is none.
  virtual QString undoText() const = 0;
  virtual QString redoText() const = 0;

 public slots:
  virtual void undo() = 0;
  virtual void redo() = 0;

 signals:
  /// One of the above changed.
  void changed();
};

}  // namespace tactus::workbench
