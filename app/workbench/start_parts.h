// Adds the start screen to the window: the demo study, new studies and models, imports, and recent files.
#pragma once

#include <QObject>
#include <vector>

#include "app/workbench/help/tour.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/demo_maker.h"
#include "app/workbench/study/table_import.h"

namespace tactus::workbench {

class CollectParts;
class FindingsController;
class GuideWindow;
class LabScreen;
class MainWindow;
class ModelController;
class ModelFiles;
class Panel;
class RecentFiles;
class RuleController;
class SceneController;
class StartView;
class StudyConnection;
class StudyModels;
class TermController;

// Adds the search (Ctrl+K) to the window: menus, panels, tables and figures of the labs, and the experts, terms,
// findings and places of the open model.

class SearchParts : public QObject {
  Q_OBJECT

 public:
  struct Controllers {
    SceneController& scene;
    TermController& terms;
    RuleController& rules;
    FindingsController& findings;
  };
  /// Where terms, rules, findings and the reason of a force are shown.
  struct Places {
    Panel& membership_editor;
    Panel& rule_editor;
    Panel& findings;
    Panel& rules_here;
  };
  SearchParts(MainWindow& window, LabScreen& labs, const Controllers& controllers, const Places& places);

  const std::vector<SearchSource>& sources() const { return sources_; }
  /// What is typed as a place leads to it, and to why the force is as it is there.
  QList<SearchEntry> placesIn(const QString& typed) const;

 private:
  void open();
  QList<SearchEntry> experts() const;
  QList<SearchEntry> terms() const;
  QList<SearchEntry> findings() const;
  void reveal(Panel& panel) const;

  MainWindow& window_;
  Controllers on_;
  Places places_;
  std::vector<SearchSource> sources_;
};

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

// Adds the guide and the tour to the window: the first actions of the menu Help, and their buttons on the start screen.

/// The panels of which the tour speaks.
struct ToldPanels {
  Panel& curves;
  Panel& map;
  Panel& rules_here;
  Panel& membership_editor;
  Panel& findings;
  Panel& feel;
  Panel& readiness;
};

class HelpParts : public QObject {
  Q_OBJECT

 public:
  HelpParts(MainWindow& window, const ModelController& models, StartParts& start, const ToldPanels& panels);

  GuideWindow& guide() { return *guide_; }
  Tour& tour() { return tour_; }

 public slots:
  /// Without a model the demo study is opened before.
  void startTour();

 private:
  std::vector<TourStep> steps(const ToldPanels& panels);

  MainWindow& window_;
  const ModelController& models_;
  StartParts& start_;
  GuideWindow* guide_;
  Tour tour_;
  bool tour_waits_ = false;  ///< for the demo study
};

}  // namespace tactus::workbench
