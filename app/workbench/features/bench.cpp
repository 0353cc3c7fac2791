#include "app/workbench/features/bench.h"

#include <utility>

#include "app/workbench/base/documents.h"

namespace tactus::workbench {

namespace {

// The curve on the screen.
CurveSetting curveOf(const SceneController& scene) {
  return scene.model() == nullptr ? CurveSetting() : CurveSetting{scene.xInput(), scene.values()};
}

}  // namespace

Labs::Labs(StudyConnection& study, const AuthorName& author)
    : data(study), depth(data, [&author] { return author.name(); }) {}

Bench::Bench(QSettings& user_settings, const QString& autosave_root, DeviceAccess devices)
    : settings(user_settings),
      scene(models),
      device(std::move(devices)),
      feel(scene, device),
      link(models),
      edits(models),
      compare(models, edits, [this] { return curveOf(scene); }),
      author(settings, edits),
      autosave(models, edits, autosave_root),
      recovery(models, edits, autosave, autosave_root),
      selection(edits),
      terms(edits),
      carry(
          edits, [this] { return terms.locked(); }, [this] { return curveOf(scene); }),
      rules(edits, scene, selection),
      ghost(edits, scene),
      references(scene),
      pull(edits, scene, [this] { return terms.locked(); }),
      findings(edits, scene),
      contracts(edits, scene),
      tell(compare, edits),
      bundles(edits),
      readiness(models, edits, bundles),
      study_models(study, models, edits),
      feel_store(feel, scene, study, [this] { return study_models.modelVersion(); }),
      strokes(ghost, edits, scene, study),
      marks(feel, scene, study, feel_store),
      duel(device, study, feel_store),
      collect(study),
      protocol(study),
      labs(study, author),
      demo(documentsFolder()),
      recent(settings),
      window(models, scene, settings),
      files(window, models, recent),
      run(window, study, device) {}

}  // namespace tactus::workbench
