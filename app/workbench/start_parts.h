// Adds the start screen to the window: the demo study, new studies and models, imports, and recent files.
#pragma once

#include <QObject>

#include "app/workbench/shell/demo_maker.h"
#include "app/workbench/study/table_import.h"

namespace tactus::workbench {

class CollectParts;
class MainWindow;
class ModelController;
class ModelFiles;
class Panel;
class RecentFiles;
class StartView;
class StudyConnection;
class StudyModels;

class StartParts : public QObject {
  Q_OBJECT

 public:
  /// `rule_editor`: where a model without rules is begun.
  StartParts(MainWindow& window, ModelFiles& files, CollectParts& collect, ModelController& models,
             const RecentFiles& recent, Panel& rule_editor, const StudyConnection& study, StudyModels& study_models);

  StartView& view() { return *view_; }
  DemoMaker& demo() { return demo_; }
  TableImport& tables() { return tables_; }

 public slots:
  /// Opens the copy of the demo study, and makes it before if there is none.
  void exploreDemo();

 signals:
  /// The model of the demo study, which was asked for, is on the screen.
  void demoShown();
  void tourRequested();
  void guideRequested();

 private:
  void connectAll();
  void makeModel();
  void chooseTables();
  void chooseDemoFolder();
  void onDemoReady(const QString& study);
  void onStudyOpened();
  void onModelOpened();

  MainWindow& window_;
  ModelFiles& files_;
  CollectParts& collect_;
  ModelController& models_;
  Panel& rule_editor_;
  const StudyConnection& study_;
  StudyModels& study_models_;
  DemoMaker demo_;
  TableImport tables_;
  StartView* view_;
  QString demo_study_;  ///< asked for, and not on the screen yet
};

}  // namespace tactus::workbench
