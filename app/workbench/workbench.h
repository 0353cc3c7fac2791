// The composition root of tactus-workbench: owns the controllers and the window, and connects them.
#pragma once

#include "app/workbench/curve_parts.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/edit_parts.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/finding_parts.h"
#include "app/workbench/history_parts.h"
#include "app/workbench/main_window.h"
#include "app/workbench/model/author_name.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/note_parts.h"
#include "app/workbench/rule_parts.h"
#include "app/workbench/shell/recent_files.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study_parts.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/understand/curves/reference_controller.h"

class QSettings;

namespace tactus::workbench {

struct Workbench {
  /// Autosaved work is kept below `autosave_root`.
  explicit Workbench(QSettings& settings, const QString& autosave_root = autosaveRoot())
      : scene(models),
        feel(scene, device),
        edits(models),
        compare(models, edits),
        author(settings, edits),
        autosave(models, edits, autosave_root),
        recovery(models, edits, autosave, autosave_root),
        terms(edits),
        rules(edits, scene),
        ghost(edits, scene),
        references(scene),
        findings(edits, scene),
        study_models(study, models, edits),
        feel_store(feel, scene, study, [this] { return study_models.modelVersion(); }),
        recent(settings),
        window(models, scene, feel, recent, settings),
        rule_parts(window, rules),
        edit_parts(window, edits, terms, scene),
        curve_parts(window, models, edits, ghost, references, settings),
        finding_parts(window, findings, terms, rules),
        study_parts(window, study, study_models, feel, feel_store, models, recent),
        note_parts(window, study_parts.menu(), study, study_models, edit_parts.editor()),
        history_parts(window, edit_parts.menu(), edits, compare, scene, feel, author) {
    history_parts.addRecovery(autosave, recovery, study);
    history_parts.addGhost(ghost);
    compare.setCurve([this] {
      return scene.model() == nullptr ? CurveSetting() : CurveSetting{scene.xInput(), scene.values()};
    });
  }

  ModelController models;
  SceneController scene;
  DeviceSession device;
  FeelController feel;  ///< before the window, so that the device gets an edit before the screen does
  EditController edits;
  CompareController compare;
  AuthorName author;
  AutosaveController autosave;
  RecoveryController recovery;
  TermController terms;
  RuleController rules;
  GhostController ghost;
  ReferenceController references;
  FindingsController findings;
  StudyConnection study;
  StudyModels study_models;
  FeelStore feel_store;
  RecentFiles recent;
  MainWindow window;
  RuleParts rule_parts;
  EditParts edit_parts;
  CurveParts curve_parts;
  FindingParts finding_parts;
  StudyParts study_parts;
  NoteParts note_parts;
  HistoryParts history_parts;
};

}  // namespace tactus::workbench
