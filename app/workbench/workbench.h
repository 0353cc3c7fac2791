// The composition root of tactus-workbench: owns the controllers and the window, and passes them down.
#pragma once

#include "app/workbench/controllers/author_name.h"
#include "app/workbench/controllers/autosave_controller.h"
#include "app/workbench/controllers/compare_controller.h"
#include "app/workbench/controllers/edit_controller.h"
#include "app/workbench/controllers/feel_controller.h"
#include "app/workbench/controllers/feel_store.h"
#include "app/workbench/controllers/findings_controller.h"
#include "app/workbench/controllers/ghost_controller.h"
#include "app/workbench/controllers/model_controller.h"
#include "app/workbench/controllers/recent_files.h"
#include "app/workbench/controllers/reference_controller.h"
#include "app/workbench/controllers/rule_controller.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/controllers/study_controller.h"
#include "app/workbench/controllers/term_controller.h"
#include "app/workbench/views/curve_parts.h"
#include "app/workbench/views/edit_parts.h"
#include "app/workbench/views/finding_parts.h"
#include "app/workbench/views/history_parts.h"
#include "app/workbench/views/main_window.h"
#include "app/workbench/views/membership_editor.h"
#include "app/workbench/views/rule_parts.h"
#include "app/workbench/views/study_parts.h"

class QSettings;

namespace tactus::workbench {

struct Workbench {
  /// What a crash would lose is kept below `autosave_root`.
  explicit Workbench(QSettings& settings, const QString& autosave_root = autosaveRoot())
      : scene(models),
        feel(scene),
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
        study(models, edits),
        feel_store(feel, scene, study),
        recent(settings),
        window(models, scene, feel, recent, settings),
        rule_parts(window, rules),
        edit_parts(window, edits, terms, scene),
        curve_parts(window, models, edits, ghost, references, settings),
        finding_parts(window, findings, terms, rules),
        study_parts(window, study, feel, feel_store, models, recent),
        history_parts(window, edit_parts.menu(), edits, compare, scene, feel, author) {
    history_parts.addRecovery(autosave, recovery, study);
    history_parts.addGhost(ghost);
    QObject::connect(&study, &StudyController::notesChanged, &edit_parts.editor(), [this] {
      edit_parts.editor().setNotes(study.notes());
      window.showNotes(study.notes());
    });
    compare.setCurve([this] {
      return scene.model() == nullptr ? CurveSetting() : CurveSetting{scene.xInput(), scene.values()};
    });
  }

  ModelController models;
  SceneController scene;
  FeelController feel;  ///< before the window, so that an edit is felt before it is drawn
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
  StudyController study;
  FeelStore feel_store;
  RecentFiles recent;
  MainWindow window;
  RuleParts rule_parts;
  EditParts edit_parts;
  CurveParts curve_parts;
  FindingParts finding_parts;
  StudyParts study_parts;
  HistoryParts history_parts;
};

}  // namespace tactus::workbench
