#include "app/workbench/workbench.h"

#include <utility>

namespace tactus::workbench {

Workbench::Workbench(QSettings& settings, const QString& autosave_root, DeviceAccess devices)
    : scene(models),
      device(std::move(devices)),
      feel(scene, device),
      link(models),
      edits(models),
      compare(models, edits,
              [this] {
                return scene.model() == nullptr ? CurveSetting() : CurveSetting{scene.xInput(), scene.values()};
              }),
      author(settings, edits),
      autosave(models, edits, autosave_root),
      recovery(models, edits, autosave, autosave_root),
      selection(edits),
      terms(edits),
      rules(edits, scene, selection),
      ghost(edits, scene),
      references(scene),
      findings(edits, scene),
      bundles(edits),
      readiness(models, edits, bundles),
      study_models(study, models, edits),
      feel_store(feel, scene, study, [this] { return study_models.modelVersion(); }),
      recent(settings),
      window(models, scene, settings),
      files(window, models, recent),
      here_parts(window, scene, selection),
      curve_parts(window, models, scene, edits, ghost, references, settings),
      map_parts(window, models, scene),
      feel_parts(window, models, scene, feel),
      link_parts(window, models, scene, feel, link),
      rule_parts(window, rules),
      edit_parts(window, edits, terms, scene, ghost),
      finding_parts(window, findings, terms, rules),
      study_parts(window, files, study, study_models, feel, feel_parts.view(), feel_store, models, recent),
      collect_parts(window, study_parts, study, study_models, device, author),
      start_parts(window, files, collect_parts, models, recent, rule_parts.panel(), study, study_models),
      lab_parts(window, files, study, study_models, models, collect_parts.run(), author),
      origin_parts(window, lab_parts, {models, scene, terms, rules, study, study_models}, edit_parts.editor(),
                   curve_parts.view()),
      report_parts(window, study, lab_parts.data()),
      note_parts(window, study, study_models, edit_parts.editor()),
      history_parts(window, edits, compare, scene, feel, author, ghost),
      selection_parts(window, selection, terms, findings, edits, history_parts, rule_parts.panel(), edit_parts),
      deliver_parts(window, models, findings, finding_parts.panel(), history_parts, bundles, readiness, study_models,
                    link, link_parts, settings),
      recovery_parts(window, files, autosave, recovery, edits, study),
      picture_parts(window, models),
      screens(window,
              {here_parts.terms(), here_parts.rules(), curve_parts.curves(), curve_parts.reading(), map_parts.map(),
               map_parts.surface(), feel_parts.panel(), edit_parts.panel(), rule_parts.panel(), finding_parts.panel(),
               history_parts.panel(), deliver_parts.readinessPanel(), deliver_parts.bundlePanel()}),
      view_menu(window, models, settings),
      help_parts(window, models, start_parts,
                 {curve_parts.curves(), map_parts.map(), here_parts.rules(), edit_parts.panel(), finding_parts.panel(),
                  feel_parts.panel(), deliver_parts.readinessPanel()}),
      search_parts(window, lab_parts.screen(), {scene, terms, rules, findings},
                   {edit_parts.panel(), rule_parts.panel(), finding_parts.panel(), here_parts.rules()}),
      help_menu(window) {}

Workbench::~Workbench() { window.hide(); }

}  // namespace tactus::workbench
