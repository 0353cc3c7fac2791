// Autosaves of the program before version 0.2: folders with the edits of a crash as JSON. They are recovered once and
// never written. Delete this file when no such folder can be left.
#pragma once

#include <QDateTime>
#include <QString>
#include <memory>
#include <vector>

#include "app/workbench/tune/history/history_file.h"

class QLockFile;

namespace tactus::workbench {

struct OldAutosave {
  QString folder;
  QString document;
  int edits = 0;
  QDateTime last;
};

/// Those in `root`. Skips the folders of living processes.
std::vector<OldAutosave> oldAutosaves(const QString& root);

/// An old autosave, locked so that no other process can take it.
class TakenAutosave {
 public:
  /// Refused if another process has taken it already.
  static base::Result<std::unique_ptr<TakenAutosave>> take(const QString& folder);
  ~TakenAutosave();

  /// Reads all parts as one. Thread: any, one at a time.
  base::Result<KeptWork> read() const;
  /// Deletes the folder.
  void discard();

 private:
  TakenAutosave(QString folder, std::unique_ptr<QLockFile> lock);

  QString folder_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace tactus::workbench
