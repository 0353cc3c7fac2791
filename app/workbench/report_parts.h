// Adds the report of the open study to the File menu: its data and every step to the averaged model, as one page.
#pragma once

#include <QObject>
#include <QString>

#include "app/workbench/base/worker.h"
#include "elicitation/model/model_builder.h"

class QAction;

namespace tactus::workbench {

class LabData;
class MainWindow;
class StudyConnection;

class ReportParts : public QObject {
  Q_OBJECT

 public:
  /// The report has the settings of `labs`. All outlive this.
  ReportParts(MainWindow& window, StudyConnection& study, const LabData& labs);

  /// Asks for a file, then writes the report.
  void choose();
  /// Writes the report to `path`, whole or not at all. Ends with `written` or `failed`. Ignored while one is written.
  void write(const QString& path);
  bool isBusy() const { return busy_; }

 signals:
  void written(const QString& path);
  /// One sentence: what could not be written, and why.
  void failed(const QString& sentence);

 private:
  void showState();
  void end(const QString& path, const QString& failure);

  MainWindow& window_;
  StudyConnection& study_;
  const LabData& labs_;
  QAction* action_;
  bool busy_ = false;
  Background background_;  ///< last: its end waits for a report
};

}  // namespace tactus::workbench
