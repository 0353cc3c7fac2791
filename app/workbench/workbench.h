// The composition root of tactus-workbench: owns the controllers and the window, and lists the features in their order.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <QVector>

#include "app/editing/edit_history.h"
#include "app/workbench/collect_parts.h"
#include "app/workbench/curve_parts.h"
#include "app/workbench/deliver/bundle_maker.h"
#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/deliver/readiness.h"
#include "app/workbench/deliver_parts.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/edit_parts.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/feel_parts.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/author_name.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/shell/help_menu.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/shell/view_menu.h"
#include "app/workbench/start_parts.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study_parts.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/recovery_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/understand/curves/reference_controller.h"

class QAction;
class QSettings;

namespace tactus::workbench {

class AutosaveController;
class EditController;
class EditParts;
class FindingsController;
class HistoryParts;
class MainWindow;
class MapPanel;
class MembershipEditor;
class ModelController;
class ModelFiles;
class Panel;
class RecoveryController;
class RuleController;
class RuleEditor;
class SceneController;
class Selection;
class StudyConnection;
class StudyModels;
class StudyNoticeStrip;
class TermController;

// What the window shows of the selection: the editor of what was pointed at comes to the front, a chosen finding and a
// visited edit of the history select what they are about.

class SelectionParts : public QObject {
  Q_OBJECT

 public:
  SelectionParts(MainWindow& window, Selection& selection, TermController& terms, FindingsController& findings,
                 EditController& edits, HistoryParts& history, Panel& rule_editor, EditParts& edit_parts);

 private:
  void bringForward(Panel& editor);
  void showTerm();
  void selectChosen(const FindingsController& findings);
  void showEdit(editing::StateId state);

  MainWindow& window_;
  Selection& selection_;
  TermController& terms_;
  EditController& edits_;
};

// Puts into the window what there is to say about the open study: what happened to it, what is odd in its data, and
// what the build says of its model.

class NoteParts : public QObject {
  Q_OBJECT

 public:
  NoteParts(MainWindow& window, StudyConnection& study, StudyModels& study_models, MembershipEditor& editor);

 private:
  void showNotes();
  void showNotices();
  /// Below the menu bar.
  void popUp(const QVector<NoteGroup>& groups);

  MainWindow& window_;
  StudyConnection& study_;
  StudyModels& study_models_;
  MembershipEditor& editor_;
  StudyNoticeStrip* strip_;
  QAction* notices_;
  QAction* data_;
  QAction* build_;
};

// Adds the way back after a crash to the window: the strip that offers the work that was left behind, and what helps
// where it is not restored or the history of the edits is not kept.

class RecoveryParts : public QObject {
  Q_OBJECT

 public:
  /// Opens `study` if the work belongs to it, and warns if work cannot be autosaved.
  RecoveryParts(MainWindow& window, ModelFiles& files, AutosaveController& autosave, RecoveryController& recovery,
                EditController& edits, StudyConnection& study);

 private:
  void connectRecovery(EditController& edits, StudyConnection& study);
  void connectAutosave();

  MainWindow& window_;
  ModelFiles& files_;
  AutosaveController& autosave_;
  RecoveryController& recovery_;
};

// The stages that show the open model, and the places of their panels before the user moves them.

struct BenchPanels {
  Panel& terms_here;
  Panel& rules_here;
  Panel& curves;
  Panel& reading;
  Panel& map;
  Panel& surface;
  Panel& feel;
  Panel& membership_editor;
  Panel& rule_editor;
  Panel& findings;
  Panel& history;
  Panel& readiness;
  Panel& bundle;
};

class BenchScreens {
 public:
  BenchScreens(MainWindow& window, const BenchPanels& panels);
};

// Adds the force over two inputs to the window: as a map and as a surface, with pictures of them.

class MapParts : public QObject {
  Q_OBJECT

 public:
  MapParts(MainWindow& window, const ModelController& models, SceneController& scene);

  MapPanel& view() { return *view_; }
  Panel& map() { return *map_; }
  Panel& surface() { return *surface_; }

 private:
  MapPanel* view_;
  Panel* map_;
  Panel* surface_;
};

// Adds the findings to the window: their panel, and the links from a chosen finding to the other panels.

class FindingParts {
  Q_DECLARE_TR_FUNCTIONS(FindingParts)

 public:
  FindingParts(MainWindow& window, FindingsController& findings, TermController& terms, RuleController& rules);

  Panel& panel() { return panel_; }

 private:
  Panel& panel_;
};

// Adds the rule editor to the window.

class RuleParts {
  Q_DECLARE_TR_FUNCTIONS(RuleParts)

 public:
  RuleParts(MainWindow& window, RuleController& rules);

  Panel& panel() { return panel_; }

 private:
  RuleEditor* editor_;
  Panel& panel_;
};

// Adds to the window the copy of a picture of the plot in use, whichever panel it belongs to.

class PictureParts {
  Q_DECLARE_TR_FUNCTIONS(PictureParts)

 public:
  PictureParts(MainWindow& window, const ModelController& models);
};

// Adds to the window why the force is what it is at the place that is read: the terms and the rules there.

class HereParts : public QObject {
  Q_OBJECT

 public:
  HereParts(MainWindow& window, SceneController& scene, Selection& selection);

  Panel& terms() { return terms_; }
  Panel& rules() { return rules_; }

 private:
  Panel& terms_;
  Panel& rules_;
};

struct Workbench {
  /// Autosaved work is kept below `autosave_root`. The devices are those of `devices`.
  explicit Workbench(QSettings& settings, const QString& autosave_root = autosaveRoot(),
                     DeviceAccess devices = realDevices());
  /// Hides the window first: views that are hidden stop what the features compute, and those go before the window.
  ~Workbench();

  ModelController models;
  SceneController scene;
  DeviceSession device;
  FeelController feel;  ///< before the window, so that the device gets an edit before the screen does
  LinkController link;  ///< likewise, for simulators
  EditController edits;
  CompareController compare;
  AuthorName author;
  AutosaveController autosave;
  RecoveryController recovery;
  Selection selection;  ///< before its users
  TermController terms;
  RuleController rules;
  GhostController ghost;
  ReferenceController references;
  FindingsController findings;
  BundleMaker bundles;
  ReadinessController readiness;
  StudyConnection study;
  StudyModels study_models;
  FeelStore feel_store;
  RecentFiles recent;
  MainWindow window;

  // The features: each adds to the window what it shows, in this order.
  ModelFiles files;
  HereParts here_parts;
  CurveParts curve_parts;
  MapParts map_parts;
  FeelParts feel_parts;
  LinkParts link_parts;
  RuleParts rule_parts;
  EditParts edit_parts;
  FindingParts finding_parts;
  StudyParts study_parts;
  CollectParts collect_parts;
  StartParts start_parts;
  LabParts lab_parts;
  OriginParts origin_parts;
  ReportParts report_parts;
  NoteParts note_parts;
  HistoryParts history_parts;
  SelectionParts selection_parts;
  DeliverParts deliver_parts;
  RecoveryParts recovery_parts;
  PictureParts picture_parts;
  BenchScreens screens;
  ViewMenu view_menu;
  HelpParts help_parts;
  SearchParts search_parts;
  HelpMenu help_menu;
};

}  // namespace tactus::workbench
