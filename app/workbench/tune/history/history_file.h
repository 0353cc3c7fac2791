// The history of a model that is opened alone: a study file in the autosave folder, which holds the versions of the
// model as any study does (core/store/model_versions.h). Its study is named after the path of the model file.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/editing/history_versions.h"
#include "core/store/study_file.h"

namespace tactus::workbench {

/// This user's folder for autosaves; it may not exist yet.
QString autosaveRoot();

/// What a history file holds.
struct KeptWork {
  QString document;  ///< the path of its file
  editing::KeptVersions kept;
  bool merged = false;  ///< two windows had the document open; their entries stand one after the other
};

/// Thread: any, one at a time.
class HistoryFile {
 public:
  /// Creates nothing before the first `write`. The files are inside `root`.
  explicit HistoryFile(QString root) : root_(std::move(root)) {}

  /// Everything kept of `document`, whose model has the SHA-256 `model_sha256` now; nothing if there is none. What a
  /// second window kept of the same document is put into the one history. So is the history of a file that is gone and
  /// whose last state was this model: the file was moved.
  base::Result<std::optional<KeptWork>> open(const QString& document, const std::string& model_sha256);
  enum class Place {
    kHistory,  ///< the file of this document; a new one if there is none
    kNewFile,  ///< always a new one: for what a study has not stored yet. One that a crash left stays as it is
  };
  /// Keeps the events of `history` that the file lacks, and the gesture in progress. Another document than the last one
  /// has another file. Events that are stored in a study are left out. `utc_ms`: of the gesture.
  base::Result<void> write(const editing::EditHistory& history, const QString& document, Place place,
                           std::int64_t utc_ms);
  /// Closes the file in order: without the journal that shows a crash.
  void close();
  /// Deletes what is kept of the document, because a study has all of it.
  void remove();
  /// Gives the file another name, so that the next `write` begins a new history. The file still opens as a study.
  /// Returns its new path.
  QString setAside();
  /// The file; empty before the first one.
  const QString& path() const { return path_; }

  /// The histories in `root` that no program has open and that a crash left.
  static QStringList leftByCrash(const QString& root);
  /// Reads a history without a change to it. `with_texts`: else versions have their SHA-256 alone, and there is no
  /// gesture.
  static base::Result<KeptWork> read(const QString& path, bool with_texts);
  /// Ends the history at `path` in order, with a return to the model `sha256` if it had that model once.
  static base::Result<void> settle(const QString& path, const std::string& sha256, const editing::Stamp& stamp);
  /// Deletes the histories that were closed in order, the oldest first, until those in `root` take at most
  /// `most_bytes`. One that a crash left, or that a program has open, stays.
  static void makeRoom(const QString& root, qint64 most_bytes = kMostKeptBytes);
  /// Several thousand edits of a model of four experts.
  static constexpr qint64 kMostKeptBytes = qint64{512} << 20U;
  /// Deletes the history at `path` for good.
  static void discard(const QString& path);

 private:
  enum class IfAbsent { kLeave, kCreate };
  base::Result<void> openFile(const QString& document, IfAbsent absent, Place place = Place::kHistory);
  base::Result<void> adoptFile(store::StudyFile file, const QString& path);
  base::Result<void> absorb(const QString& path);
  bool absorbSideFiles();
  void absorbMoved(const QString& document, const std::string& model_sha256);
  base::Result<void> append(std::vector<study::ModelVersion> versions);

  QString root_;
  QString document_;
  QString path_;
  std::optional<store::StudyFile> file_;
  std::set<study::RecordId> there_;  ///< the versions in the file
  std::string drag_sha256_;          ///< of the last version if it is a drag
  study::RecordIds ids_;
};

}  // namespace tactus::workbench
