// Makes a study of a folder with tables (speeds.csv, judgements.csv, …), in the background.
#pragma once

#include <QObject>
#include <QString>

#include "app/workbench/base/worker.h"

namespace tactus::workbench {

/// Thread: gui.
class TableImport : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool isRunning() const { return running_; }
  /// Makes the study file `path`, which must not exist, of the tables in `folder`. Without `as_they_are` it refuses
  /// data that can hardly be meant. Ignored while one is made.
  void run(const QString& folder, const QString& path, bool as_they_are);

 signals:
  /// `notes`: one or two sentences, for the user.
  void imported(const QString& path, const QString& notes);
  /// Nothing was made; why, in one sentence.
  void failed(const QString& sentence);
  /// Nothing was made, because of data that a person may say are right: `run` with `as_they_are`.
  void doubted(const QString& folder, const QString& path, const QString& sentence);

 private:
  bool running_ = false;
  CallQueue answers_;
  Worker worker_;  ///< last: its end waits for the work, which posts to `answers_`
};

}  // namespace tactus::workbench
