// Recovery after a crash: finds unstored work and, as the user decides, restores it with its history or deletes it.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/base/call_queue.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/tune/history/autosave_folder.h"

namespace tactus::workbench {

class AutosaveController;
class EditController;
class ModelController;

class RecoveryController : public QObject {
  Q_OBJECT

 public:
  /// Looks into `root` at once, and again whenever a document is opened.
  RecoveryController(ModelController& models, EditController& edits, AutosaveController& autosave, QString root,
                     QObject* parent = nullptr);

  /// The work offered now; nothing if there is none or the user postponed it.
  std::optional<LostWork> offered() const;
  /// The number of further offers.
  int others() const { return offered_.empty() ? 0 : static_cast<int>(offered_.size()) - 1; }
  bool isBusy() const { return busy_; }

 public slots:
  /// Opens the document of the offered work, if it is not open, and continues its history. The work is deleted after
  /// the restored state is autosaved; if the document is closed before, the work stays and is offered again. Ends with
  /// `restored` or `failed`. Changes of the open model are replaced.
  void restore();
  /// Deletes the offered work.
  void discard();
  /// Postpones the offer until the document is opened again or until the next start.
  void later();

 signals:
  void offerChanged();
  /// The work belongs to the study `path`, which must be opened first. The work is restored when the study's model is
  /// open.
  void studyNeeded(const QString& path);
  void restored(const QString& sentence);
  void failed(const QString& sentence);

 private:
  void scan();
  void onOpened();
  /// The result of the worker's read.
  struct Found {
    editing::Autosave autosave;
    std::optional<editing::EditHistory> history;  ///< nothing if the beginning of the history is in a study
  };
  static base::Result<Found> read(const TakenWork& taken, const editing::Stamp& stamp, bool in_study);
  void adopt(base::Result<Found> found);
  void begin(const LostWork& work, editing::EditHistory history);
  void goOn(const editing::Autosave& autosave);
  void onWritten(quint64 number);
  void drop();

  ModelController& models_;
  EditController& edits_;
  AutosaveController& autosave_;
  const QString root_;
  std::vector<LostWork> offered_;
  QStringList put_off_;               ///< folders of postponed work
  std::shared_ptr<TakenWork> taken_;  ///< the work being restored
  /// Work restored into the open document.
  struct Replaced {
    std::shared_ptr<TakenWork> work;
    quint64 number = 0;  ///< number of the first autosave that contains it
  };
  std::vector<Replaced> replaced_;  ///< to be deleted after that write
  bool busy_ = false;
  QString wanted_;  ///< the study that has to be opened first
  CallQueue answers_;
  Worker worker_;  ///< last: it waits for its end before the rest is gone
};

}  // namespace tactus::workbench
