// Keeps the history of the open model in a history file (history_file.h), within a second of an edit, and lets the
// history go on when the model is opened again. A worker reads and writes; the window waits for neither.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/workbench/base/worker.h"
#include "app/workbench/tune/history/history_file.h"

namespace tactus::workbench {

class EditController;
class ModelController;

/// Edits of the open model that its file lacks, because the program ended before they were saved or given up.
struct LostEdits {
  editing::StateId state = 0;  ///< with the edits
  std::optional<editing::Unfinished> drag;
  int edits = 0;
  std::int64_t last_utc_ms = 0;
};

class AutosaveController : public QObject {
  Q_OBJECT

 public:
  /// The delays before a write, ms.
  struct Times {
    int after_edit_ms = 1000;
    int in_gesture_ms = 2000;     ///< a drag changes the model with every frame
    int after_failure_ms = 5000;  ///< before the next attempt
  };

  /// Writes below `root`.
  AutosaveController(ModelController& models, EditController& edits, QString root, Times times,
                     QObject* parent = nullptr);
  AutosaveController(ModelController& models, EditController& edits, QString root, QObject* parent = nullptr)
      : AutosaveController(models, edits, std::move(root), Times(), parent) {}
  /// Ends the history in order: where edits were given up, with a return to the model of the file.
  ~AutosaveController() override;

  /// What the history of the open model holds beyond its file.
  const std::optional<LostEdits>& lost() const { return lost_; }
  /// The offer was answered. The history ends with the state that is shown now, so that it is not made again.
  void settleLost();

  /// Runs `task` in the worker's thread, which alone uses history files, after all tasks before.
  void post(std::function<void(HistoryFile& own)> task);
  /// Waits until all posted tasks are done.
  void wait();

  /// Writes pending changes now, and waits until all is written. Returns the number of the write that holds the current
  /// state; `written` reports success.
  quint64 flush();
  /// The file that keeps the history; empty if there is none. Waits for the worker.
  QString file();

 signals:
  /// The write of this number, and all earlier ones of the same document, are on disk.
  void written(quint64 number);
  /// The earlier history of the document that was opened was looked for; `lost` is set.
  void lookedUp(const QString& document);
  /// One or two sentences.
  void said(const QString& sentence);
  /// One sentence; emitted once per series of failures. The write is retried anyway; the model itself can be saved.
  void failed(const QString& sentence);
  /// The series of failures has ended.
  void worksAgain();
  /// The earlier history of `document` was not read: one sentence. Opening the document again looks for it again.
  void notRead(const QString& sentence, const QString& document);
  /// The earlier history does not fit the model: one sentence. The study file `aside` keeps it.
  void setAside(const QString& sentence, const QString& aside);

 private:
  /// The result of the worker's look at the history file.
  struct Found {
    std::optional<editing::EarlierHistory> history;
    bool merged = false;
    QString failure;
    QString aside;  ///< the file of a history that does not fit the model
  };
  void onChange();
  void onReset();
  void onSaved();
  void takeOver();
  void lookUp();
  static Found lookUp(HistoryFile& file, const QString& document, const editing::EditHistory& fresh,
                      const std::string& changed_label, const editing::Stamp& stamp);
  void adopt(const QString& document, Found found);
  void leave();
  bool needsWriting() const;
  void write();
  void finish(quint64 number, const QString& failure);
  void writeWithin(int delay_ms);

  ModelController& models_;
  EditController& edits_;
  const Times times_;
  std::shared_ptr<HistoryFile> file_;
  QString document_;  ///< whose history it is; empty: none is open
  bool in_study_ = false;
  std::shared_ptr<const editing::EditHistory> history_;  ///< the newest, a gesture in progress excepted
  std::size_t kept_ = 0;                                 ///< events that need no write before another one follows
  std::optional<editing::StateId> saved_;                ///< the state of the document's file
  std::optional<LostEdits> lost_;
  bool adopting_ = false;
  bool drag_kept_ = false;  ///< the file has a gesture that may have ended without an entry
  QTimer due_;
  bool busy_ = false;   ///< the worker is writing
  bool again_ = false;  ///< the model changed after the write began
  quint64 number_ = 0;  ///< number of the last write that began
  QString failure_;
  CallQueue answers_;
  Worker worker_;  ///< last: it waits for its end before the rest is gone
};

}  // namespace tactus::workbench
