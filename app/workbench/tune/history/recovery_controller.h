// After a crash: finds what was not stored, and brings it back with its history, or deletes it, as the person decides.
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

  /// What is offered now; nothing where there is none, or where it was put off.
  std::optional<LostWork> offered() const;
  /// How many more wait behind it.
  int others() const { return offered_.empty() ? 0 : static_cast<int>(offered_.size()) - 1; }
  bool isBusy() const { return busy_; }

 public slots:
  /// Opens the document of what is offered, where it is not open, and goes on with its history. The work is deleted
  /// once the restored state itself is autosaved; where the document is left before, it stays and is offered again.
  /// Ends with `restored` or `failed`. Changes of the open model are replaced.
  void restore();
  /// Deletes what is offered.
  void discard();
  /// Leaves it where it is until its document is opened, or the next start.
  void later();

 signals:
  void offerChanged();
  /// Work of a study: the study `path` has to be opened first; the work is restored as soon as its model is open.
  void studyNeeded(const QString& path);
  void restored(const QString& sentence);
  void failed(const QString& sentence);

 private:
  void scan();
  void onOpened();
  /// What a worker made of the files.
  struct Found {
    editing::Autosave autosave;
    std::optional<editing::EditHistory> history;  ///< nothing where a study has the beginning of it
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
  QStringList put_off_;               ///< folders
  std::shared_ptr<TakenWork> taken_;  ///< being restored
  /// Work that was restored into the open document.
  struct Replaced {
    std::shared_ptr<TakenWork> work;
    quint64 number = 0;  ///< of the first autosave that holds it
  };
  std::vector<Replaced> replaced_;  ///< to be deleted once that is written
  bool busy_ = false;
  QString wanted_;  ///< the study that has to be opened first
  CallQueue answers_;
  Worker worker_;  ///< last: it waits for its end before the rest is gone
};

}  // namespace tactus::workbench
