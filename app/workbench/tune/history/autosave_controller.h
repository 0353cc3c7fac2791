// Keeps what a crash would lose in a file of its own: within a second of an edit, by a worker, until it is stored or
// the document is closed.
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
  /// When something is written, ms.
  struct Times {
    int after_edit_ms = 1000;
    int in_gesture_ms = 2000;     ///< a drag changes the model with every frame
    int after_failure_ms = 5000;  ///< until it is tried again
  };

  /// Writes into a folder of its own below `root`.
  AutosaveController(ModelController& models, EditController& edits, QString root, Times times,
                     QObject* parent = nullptr);
  AutosaveController(ModelController& models, EditController& edits, QString root, QObject* parent = nullptr)
      : AutosaveController(models, edits, std::move(root), Times(), parent) {}
  /// A process that ends in order has been asked what to do with its changes: nothing stays behind.
  ~AutosaveController() override;

  /// Writes now what is due, and waits until everything is written. Returns the number of that writing, which holds
  /// the present state: `written` tells whether it succeeded.
  quint64 flush();
  /// The folder that is written to; empty where nothing is due.
  QString folder();

 signals:
  /// The writing of this number, and with it all earlier ones of the same document, is on disk.
  void written(quint64 number);
  /// One sentence; once until it works again. It is tried again all the same.
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
  bool busy_ = false;   ///< the worker writes
  bool again_ = false;  ///< there is something newer than what it writes
  quint64 number_ = 0;  ///< of the last writing that was begun
  QString failure_;
  CallQueue answers_;
  Worker worker_;  ///< last: it waits for its end before the rest is gone
};

}  // namespace tactus::workbench
