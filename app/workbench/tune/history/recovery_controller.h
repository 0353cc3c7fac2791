// Recovery after a crash: finds edits that the model's file lacks and, as the user decides, shows them again or gives
// them up.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/base/worker.h"
#include "app/workbench/tune/history/history_file.h"

namespace tactus::workbench {

class AutosaveController;
class EditController;
class ModelController;

/// Edits that a crash left.
struct LostWork {
  enum class Where {
    kOpenDocument,  ///< in the history of the open document (AutosaveController::lost)
    kHistoryFile,   ///< in the history file of a document that is not open
  };
  Where where = Where::kHistoryFile;
  QString source;  ///< file or folder
  QString document;
  int edits = 0;
  QDateTime last;  ///< time of the last write

  bool operator==(const LostWork&) const = default;
};

class RecoveryController : public QObject {
  Q_OBJECT

 public:
  /// Looks into `root` at once, and again whenever a document is opened. `offerChanged` tells the result.
  RecoveryController(ModelController& models, EditController& edits, AutosaveController& autosave, QString root,
                     QObject* parent = nullptr);
  ~RecoveryController() override;

  /// The work offered now; nothing if there is none or the user postponed it.
  std::optional<LostWork> offered() const;
  /// The number of further offers.
  int others() const { return offered_.empty() ? 0 : static_cast<int>(offered_.size()) - 1; }
  bool isBusy() const { return busy_; }

 public slots:
  /// Opens the document of the offered work, if it is not open, and shows its last state, with the whole history. Ends
  /// with `restored` or `notRestored`. Changes of the open model are replaced.
  void restore();
  /// The same of work that was not restored before.
  void restoreWork(const tactus::workbench::LostWork& work);
  /// Gives up the offered work. What is in the history of a model file stays there.
  void discard();
  /// The same of work that was not discarded before.
  void discardWork(const tactus::workbench::LostWork& work);
  /// Postpones the offer until the document is opened again or until the next start.
  void later();

 signals:
  void offerChanged();
  /// The work belongs to the study `path`, which must be opened first. The work is restored when the study's model is
  /// open.
  void studyNeeded(const QString& path);
  void restored(const QString& sentence);
  /// One sentence: why `work` was not restored, or not discarded.
  void notRestored(const QString& sentence, const tactus::workbench::LostWork& work);
  void notDiscarded(const QString& sentence, const tactus::workbench::LostWork& work);

 private:
  void scan();
  void show(std::vector<LostWork> found);
  void onOpened();
  void onLookedUp(const QString& document);
  void restoreOpen(const LostWork& work);
  /// The result of the worker's read.
  struct Found {
    editing::KeptVersions kept;
    std::optional<editing::EditHistory> history;  ///< nothing if the beginning of the history is in a study
  };
  static base::Result<Found> read(const LostWork& work, const editing::Stamp& stamp);
  void adopt(const LostWork& work, base::Result<Found> found);
  void begin(const LostWork& work, editing::EditHistory history);
  base::Result<void> goOn(const editing::KeptVersions& kept);
  void onWritten(quint64 number);
  void drop(const LostWork& work);
  void say(const LostWork& work);
  static std::string recoveredLabel(const editing::Unfinished& drag);

  ModelController& models_;
  EditController& edits_;
  AutosaveController& autosave_;
  const QString root_;
  std::vector<LostWork> offered_;
  std::vector<LostWork> put_off_;  ///< postponed
  /// Work restored into the open document.
  struct Replaced {
    LostWork work;
    quint64 number = 0;  ///< number of the first autosave that contains it
  };
  std::vector<Replaced> replaced_;  ///< to be deleted after that write
  bool busy_ = false;
  std::optional<LostWork> wanted_;  ///< its document has to be opened first
  CallQueue answers_;
};

}  // namespace tactus::workbench
