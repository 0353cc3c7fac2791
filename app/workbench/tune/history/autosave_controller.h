// Autosaves the edits that a crash would lose. A worker writes them to a separate file within a second of an edit. The
// file is deleted when the edits are stored or the document is closed.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <utility>

#include "app/workbench/base/call_queue.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/tune/history/autosave_folder.h"

namespace tactus::workbench {

class EditController;
class ModelController;

class AutosaveController : public QObject {
  Q_OBJECT

 public:
  /// The delays before a write, ms.
  struct Times {
    int after_edit_ms = 1000;
    int in_gesture_ms = 2000;     ///< a drag changes the model with every frame
    int after_failure_ms = 5000;  ///< before the next attempt
  };

  /// Writes into a new folder below `root`.
  AutosaveController(ModelController& models, EditController& edits, QString root, Times times,
                     QObject* parent = nullptr);
  AutosaveController(ModelController& models, EditController& edits, QString root, QObject* parent = nullptr)
      : AutosaveController(models, edits, std::move(root), Times(), parent) {}
  /// Deletes the autosave: at a normal end the user has already decided about unsaved changes.
  ~AutosaveController() override;

  /// Writes pending changes now, and waits until all is written. Returns the number of the write that holds the current
  /// state; `written` reports success.
  quint64 flush();
  /// The autosave folder; empty if there is none. Waits for the worker.
  QString folder();

 signals:
  /// The write of this number, and all earlier ones of the same document, are on disk.
  void written(quint64 number);
  /// One sentence; emitted once per series of failures. The write is retried anyway.
  void failed(const QString& sentence);

 private:
  void onChange();
  void onReset();
  void write();
  void finish(quint64 number, const QString& failure);
  void writeWithin(int delay_ms);

  ModelController& models_;
  EditController& edits_;
  const Times times_;
  std::shared_ptr<AutosaveFolder> folder_;
  QTimer due_;
  bool busy_ = false;   ///< the worker is writing
  bool again_ = false;  ///< the model changed after the write began
  quint64 number_ = 0;  ///< number of the last write that began
  QString failure_;
  CallQueue answers_;
  Worker worker_;  ///< last: it waits for its end before the rest is gone
};

}  // namespace tactus::workbench
