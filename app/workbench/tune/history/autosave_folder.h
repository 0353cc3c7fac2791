// Where edits that are stored nowhere else wait: a folder for each process and document, locked while the process
// lives. What is found in a folder without a living process was left by a crash.
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

/// The folder of this user for autosaved work; it need not be there.
QString autosaveRoot();

/// Writes what a history has not stored into a folder. Versions that were written once are not written again: they
/// stand in closed parts of 50 versions, fewer where the model is large; the newest part is replaced as a whole.
/// Thread: one at a time.
class AutosaveFolder {
 public:
  /// Nothing is made before the first `write`. Folders stand in `root`.
  explicit AutosaveFolder(QString root);
  ~AutosaveFolder();

  /// What there is to lose, apart from the history itself.
  struct Facts {
    QString document;    ///< path of what is edited
    bool saved = false;  ///< its file has the current state
  };
  base::Result<void> write(const editing::EditHistory& history, const Facts& facts);
  /// Forgets and deletes everything: it is stored, or was given up. The next `write` begins anew.
  void remove();

  /// Empty before the first write.
  const QString& path() const { return path_; }

 private:
  base::Result<void> begin();

  QString root_;
  QString path_;
  std::unique_ptr<QLockFile> lock_;
  std::size_t closed_parts_ = 0;
  std::size_t closed_events_ = 0;  ///< that stand in them
};

/// Work that a process left behind when it ended without closing its document.
struct LostWork {
  QString folder;
  QString document;
  int edits = 0;       ///< gestures, undo and redo not counted
  QDateTime last;      ///< when something was written last
  bool saved = false;  ///< the file of the document has the last state; only the history is left
};

/// All of it in `root`, the newest first. Folders of living processes are left out, this one's too.
std::vector<LostWork> lostWork(const QString& root);

/// Lost work, taken so that no other process takes it too.
class TakenWork {
 public:
  /// Refused where another process has it by now.
  static base::Result<std::unique_ptr<TakenWork>> take(const LostWork& work);
  ~TakenWork();

  /// All parts as one. Thread: any, one at a time.
  base::Result<editing::Autosave> read() const;
  /// Deletes it for good.
  void discard();

 private:
  TakenWork(QString folder, std::unique_ptr<QLockFile> lock);

  QString folder_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace tactus::workbench
