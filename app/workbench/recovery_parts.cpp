#include "app/workbench/recovery_parts.h"

#include "app/workbench/kit/notes.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/recovery_controller.h"
#include "app/workbench/tune/history/compare_strip.h"

namespace tactus::workbench {

RecoveryParts::RecoveryParts(MainWindow& window, ModelFiles& files, AutosaveController& autosave,
                             RecoveryController& recovery, EditController& edits, StudyConnection& study)
    : window_(window), files_(files), autosave_(autosave), recovery_(recovery) {
  auto* strip = new RecoveryStrip(recovery);
  window.addStrip(strip);
  connect(strip, &RecoveryStrip::restoreRequested, this, [this] {
    if (files_.mayLoseChanges()) recovery_.restore();
  });
  connectRecovery(edits, study);
  connectAutosave();
}

void RecoveryParts::connectRecovery(EditController& edits, StudyConnection& study) {
  connect(&recovery_, &RecoveryController::studyNeeded, &study, &StudyConnection::open);
  connect(&recovery_, &RecoveryController::restored, &edits, &EditController::reported);
  connect(&recovery_, &RecoveryController::notRestored, this, [this](const QString& sentence, const LostWork& work) {
    window_.banner().showRemedy(sentence, {tr("Try again"), [this, work] {
                                             if (files_.mayLoseChanges()) recovery_.restoreWork(work);
                                           }});
  });
  connect(&recovery_, &RecoveryController::notDiscarded, this, [this](const QString& sentence, const LostWork& work) {
    window_.banner().showRemedy(sentence, {tr("Try again"), [this, work] { recovery_.discardWork(work); }});
  });
}

void RecoveryParts::connectAutosave() {
  connect(&autosave_, &AutosaveController::said, &window_.banner(), &MessageBanner::showNote);
  connect(&autosave_, &AutosaveController::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(sentence, {tr("Save the model"), [this] { files_.save(); }}, &autosave_);
  });
  connect(&autosave_, &AutosaveController::worksAgain, this, [this] { window_.banner().takeBack(autosave_); });
  const auto open = [this](const QString& path) { return [this, path] { files_.open(path); }; };
  connect(&autosave_, &AutosaveController::notRead, this,
          [this, open](const QString& sentence, const QString& document) {
            window_.banner().showRemedy(sentence, {tr("Open the model again"), open(document)});
          });
  connect(&autosave_, &AutosaveController::setAside, this, [this, open](const QString& sentence, const QString& aside) {
    window_.banner().showRemedy(sentence, {tr("Open the earlier history"), open(aside)});
  });
}

}  // namespace tactus::workbench
