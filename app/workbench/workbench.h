// The composition root of tactus-workbench: owns the controllers and the window, and lists the features in their order.
#pragma once

#include "app/workbench/bench_screens.h"
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
#include "app/workbench/finding_parts.h"
#include "app/workbench/help_parts.h"
#include "app/workbench/here_parts.h"
#include "app/workbench/history_parts.h"
#include "app/workbench/lab_parts.h"
#include "app/workbench/link_parts.h"
#include "app/workbench/map_parts.h"
#include "app/workbench/model/author_name.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/note_parts.h"
#include "app/workbench/origin_parts.h"
#include "app/workbench/picture_parts.h"
#include "app/workbench/recovery_parts.h"
#include "app/workbench/report_parts.h"
#include "app/workbench/rule_parts.h"
#include "app/workbench/search_parts.h"
#include "app/workbench/selection_parts.h"
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

class QSettings;

namespace tactus::workbench {

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
