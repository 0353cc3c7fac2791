// The demo study as a copy of the user's: made once, in the background, in a folder of the user's documents.
#pragma once

#include <QObject>
#include <QString>

#include "app/workbench/base/worker.h"

namespace tactus::workbench {

/// Thread: gui.
class DemoMaker : public QObject {
  Q_OBJECT

 public:
  static constexpr int kParts = 4;  ///< of the work (demo::DemoPart)

  /// `documents`: the folder in which the demo's folder is made.
  explicit DemoMaker(const QString& documents, QObject* parent = nullptr);

  /// From now on another folder holds the demo's folder.
  void setDocuments(const QString& documents);
  /// Where the demo is, or will be.
  const QString& folder() const { return folder_; }
  /// Whether a copy was made before.
  bool isThere() const;
  bool isMaking() const { return making_; }
  int partsDone() const { return done_; }
  /// The part of the work in progress; empty while nothing is made.
  QString partText() const;

  /// Leads to `ready` or `failed`: the copy that is there, or a new one.
  void explore();
  /// A new copy, in a folder beside those that are there. Ignored while one is made.
  void makeFresh();

 signals:
  /// Any of the above.
  void changed();
  /// The study file of the copy is whole. Of a new copy the models, tables and the report follow.
  void ready(const QString& study);
  void failed(const QString& sentence);

 private:
  QString study() const;
  void make();
  void begin(int part);
  void tell(int done);
  void end(const QString& failure);

  QString documents_;
  QString folder_;
  bool making_ = false;
  int done_ = 0;
  CallQueue answers_;
  Worker worker_;  ///< last: its end waits for the work, which posts to `answers_`
};

}  // namespace tactus::workbench
