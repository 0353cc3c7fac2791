// Adds the study to the window: the menu Study, the state of storing, messages, and recordings in the feel panel.
// Closing the window waits until everything is written.
#pragma once

#include <QObject>
#include <QString>

#include "app/workbench/base/worker.h"
#include "app/workbench/kit/notes.h"
#include "elicitation/model/model_builder.h"

class QAction;

namespace tactus::workbench {

class FeelController;
class FeelPanel;
class FeelStore;
class LabData;
class MainWindow;
class ModelController;
class ModelFiles;
class RecentFiles;
class StudyConnection;
class StudyModels;

// Adds the report of the open study to the File menu: its data and every step to the averaged model, as one page.

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

class StudyParts : public QObject {
  Q_OBJECT

 public:
  StudyParts(MainWindow& window, ModelFiles& files, StudyConnection& study, StudyModels& study_models,
             FeelController& feel, FeelPanel& panel, FeelStore& store, const ModelController& models,
             RecentFiles& recent);

  /// Asks for the place of a new study and makes it.
  void chooseNew();
  /// Asks for a study, new or there already, opens it beside the open model and arms a recording.
  void recordIntoStudy();
  /// The open study was chosen to record into: the screen stays where the model is felt.
  bool isToRecord() const;

 private:
  void buildMenu();
  void addRecordings(FeelPanel& panel);
  void connectAll();
  void showState();
  /// What is said of a study beside that it is open for reading only.
  struct ReadOnlyReason {
    QString sentence;
    MessageAct act;
  };

  void onOpened();
  void showReadOnly(ReadOnlyReason beside);
  /// `go_on_there`: the copy is open afterwards, with what the study could not take.
  void chooseCopy(bool go_on_there = false);
  void buildModel();
  /// `act`: what helps; without text there is a way out by what is open.
  void onFailed(const QString& path, const QString& sentence, const MessageAct& act = {});
  /// Keeps the window open until everything is written, or until the user gives it up.
  bool mayEnd();

  MainWindow& window_;
  ModelFiles& files_;
  StudyConnection& study_;
  StudyModels& study_models_;
  FeelController& feel_;
  FeelStore& store_;
  const ModelController& models_;
  RecentFiles& recent_;
  QAction* make_ = nullptr;
  QAction* show_ = nullptr;
  QAction* put_ = nullptr;
  QAction* build_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* close_ = nullptr;
  ReadOnlyReason beside_;
  QString recorded_path_;  ///< of the study that was chosen to record into
  bool ending_ = false;    ///< the window closes as soon as everything is written
};

}  // namespace tactus::workbench
