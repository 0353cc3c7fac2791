// Adds the study to the window: the menu Study, the state of storing, messages, and recordings in the feel panel.
// Closing the window waits until everything is written.
#pragma once

#include <QObject>

#include "app/workbench/kit/notes.h"

class QAction;

namespace tactus::workbench {

class FeelController;
class FeelPanel;
class FeelStore;
class MainWindow;
class ModelController;
class ModelFiles;
class RecentFiles;
class StudyConnection;
class StudyModels;

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
  struct Beside {
    QString sentence;
    MessageAct act;
  };

  void onOpened();
  void showReadOnly(Beside beside);
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
  Beside beside_;
  QString recorded_path_;  ///< of the study that was chosen to record into
  bool ending_ = false;    ///< the window closes as soon as everything is written
};

}  // namespace tactus::workbench
