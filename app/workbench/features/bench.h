// What the features of the window share: the controllers of the open model and the open study, the window, and the
// views and panels that one feature shows and another leads to.
#pragma once

#include <QObject>

#include "app/workbench/collect/collect_controller.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/deliver/bundle_maker.h"
#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/deliver/readiness.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/feel/duel/duel_controller.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_marks.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/origins/origin_finder.h"
#include "app/workbench/labs/overview/build_overview.h"
#include "app/workbench/labs/rules/rules_lab.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/session/take_part.h"
#include "app/workbench/shell/demo_maker.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study/table_import.h"
#include "app/workbench/tune/contracts/contracts_controller.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/carry_controller.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/history/recovery_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/strokes/strokes_controller.h"
#include "app/workbench/tune/tell/tell_controller.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/understand/curves/reference_controller.h"
#include "app/workbench/understand/pull/pull_controller.h"

class QSettings;

namespace tactus::workbench {

class CarryDialog;
class CollectView;
class CurvesPanel;
class DepthLabView;
class FeelPanel;
class ForceLabView;
class FrameClock;
class HelpFeature;
class HistoryPanel;
class LabScreen;
class LinkDialog;
class MapPanel;
class MembershipEditor;
class OriginsFeature;
class Panel;
class ReportFeature;
class RulePanel;
class RulesLabView;
class SearchFeature;
class SpeedLabView;
class StartFeature;
class StartView;
class StudyFeature;

/// What leads from recordings to an agreed model.
struct Labs {
  Labs(StudyConnection& study, const AuthorName& author);

  LabData data;
  LabModel model{data};
  Corrections corrections{data};
  SettingsPrice price{data};
  BuildOverview overview{model};
  SpeedLab speed{data};
  ForceLab force{data, model, corrections};
  RulesLab rules{model, corrections};
  DepthLab depth;
  OriginFinder origins{data, model};
};

/// Each is null until its feature has added it, and is the window's.
struct BenchViews {
  CurvesPanel* curves = nullptr;
  RulePanel* why = nullptr;
  MapPanel* map = nullptr;
  FeelPanel* feel = nullptr;
  MembershipEditor* membership_editor = nullptr;
  HistoryPanel* history = nullptr;
  CarryDialog* carry = nullptr;
  LinkDialog* link = nullptr;
  CollectView* collect = nullptr;
  StartView* start = nullptr;
  LabScreen* labs = nullptr;
  DepthLabView* depth = nullptr;
  SpeedLabView* speed = nullptr;
  ForceLabView* force = nullptr;
  RulesLabView* rules = nullptr;
  FrameClock* edit_clock = nullptr;  ///< from an edit to the screen
};

/// Each is null until its feature has added it, and is the window's.
struct BenchPanels {
  Panel* terms_here = nullptr;
  Panel* rules_here = nullptr;
  Panel* curves = nullptr;
  Panel* reading = nullptr;  ///< the forces at the place that is read
  Panel* map = nullptr;
  Panel* surface = nullptr;
  Panel* feel = nullptr;
  Panel* membership_editor = nullptr;
  Panel* rule_editor = nullptr;
  Panel* findings = nullptr;
  Panel* contracts = nullptr;
  Panel* history = nullptr;
  Panel* strokes = nullptr;
  Panel* readiness = nullptr;
  Panel* bundle = nullptr;
};

struct Bench {
  /// Autosaved work is kept below `autosave_root`. The devices are those of `devices`.
  Bench(QSettings& settings, const QString& autosave_root, DeviceAccess devices);

  QSettings& settings;
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
  CarryController carry;
  RuleController rules;
  GhostController ghost;
  ReferenceController references;
  PullController pull;
  FindingsController findings;
  ContractsController contracts;
  TellController tell;
  BundleMaker bundles;
  ReadinessController readiness;
  StudyConnection study;
  StudyModels study_models;
  FeelStore feel_store;
  StrokesController strokes;
  FeelMarks marks;
  DuelController duel;
  CollectController collect;
  ProtocolController protocol;
  Labs labs;
  DemoMaker demo;
  TableImport tables;
  RecentFiles recent;
  MainWindow window;
  ModelFiles files;
  SessionRun run;
  BenchViews views;
  BenchPanels panels;
  // The features that others ask for something; null until added.
  StudyFeature* study_feature = nullptr;
  ReportFeature* report = nullptr;
  OriginsFeature* origins = nullptr;
  StartFeature* start = nullptr;
  HelpFeature* help = nullptr;
  SearchFeature* search = nullptr;
  /// Has all features and ends them before the window, so that none hears its end.
  QObject features;
};

}  // namespace tactus::workbench
