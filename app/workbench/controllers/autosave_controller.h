// Keeps what a crash would lose in a file of its own: within a second of an edit, by a worker, until it is stored or
// the document is closed.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>

#include "app/workbench/controllers/autosave_folder.h"
#include "app/workbench/controllers/mailbox.h"
#include "app/workbench/controllers/worker.h"

namespace tactus::workbench {

class EditController;
class ModelController;

class AutosaveController : public QObject {
  Q_OBJECT

 public:
  /// Writes into a folder of its own below `root`.
  AutosaveController(ModelController& models, EditController& edits, QString root, QObject* parent = nullptr);
  /// A process that ends in order has been asked what to do with its changes: nothing stays behind.
  ~AutosaveController() override;

  /// Writes now what is due, and waits until everything is written.
  void flush();
  /// The folder that is written to; empty where nothing is due.
  QString folder();

 signals:
  /// Everything so far is on disk.
  void written();
  /// One sentence; once until it works again.
  void failed(const QString& sentence);

 private:
  void onChange();
  void onReset();
  void write();
  void finish(const QString& failure);

  ModelController& models_;
  EditController& edits_;
  std::shared_ptr<AutosaveFolder> folder_;
  QTimer due_;
  bool busy_ = false;   ///< the worker writes
  bool again_ = false;  ///< there is something newer than what it writes
  QString failure_;
  Mailbox answers_;
  Worker worker_;  ///< last: it waits for its end before the rest is gone
};

}  // namespace tactus::workbench
