// The autosave folders. Each process and document has its own folder, locked while the process lives. A folder without
// a living process was left by a crash.
#pragma once

#include <QDateTime>
#include <QString>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/editing/autosave.h"

class QLockFile;

namespace tactus::workbench {

/// This user's folder for autosaves; it may not exist yet.
QString autosaveRoot();

/// Writes the unstored part of a history into a folder. Closed parts of 50 versions (fewer for a large model) are
/// written once; the newest part is replaced as a whole. Thread: any, one at a time.
class AutosaveFolder {
 public:
  /// Creates nothing before the first `write`. The folders are inside `root`.
  explicit AutosaveFolder(QString root);
  ~AutosaveFolder();

  /// Facts about the document, apart from its history.
  struct Facts {
    QString document;    ///< path of the edited document
    bool saved = false;  ///< the file of the document has the current state
  };
  base::Result<void> write(const editing::EditHistory& history, const Facts& facts);
  /// Deletes the autosave, because its edits are stored or given up. The next `write` starts a new one.
  void remove();

  /// The folder; empty before the first write.
  const QString& path() const { return path_; }

 private:
  base::Result<void> begin();

  QString root_;
  QString path_;
  std::unique_ptr<QLockFile> lock_;
  std::size_t closed_parts_ = 0;
  std::size_t closed_events_ = 0;  ///< number of events in the closed parts
};

/// Autosaved work of a process that ended without closing its document.
struct LostWork {
  QString folder;
  QString document;
  int edits = 0;       ///< gestures, without undo and redo
  QDateTime last;      ///< time of the last write
  bool saved = false;  ///< the document's file has the last state; only the history would be lost
};

/// All lost work in `root`, newest first. Skips the folders of living processes, also of this one.
std::vector<LostWork> lostWork(const QString& root);

/// Lost work, locked so that no other process can take it.
class TakenWork {
 public:
  /// Refused if another process has taken it already.
  static base::Result<std::unique_ptr<TakenWork>> take(const LostWork& work);
  ~TakenWork();

  /// Reads all parts as one. Thread: any, one at a time.
  base::Result<editing::Autosave> read() const;
  /// Deletes the work permanently.
  void discard();

 private:
  TakenWork(QString folder, std::unique_ptr<QLockFile> lock);

  QString folder_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace tactus::workbench
