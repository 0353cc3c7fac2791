#include "app/workbench/recovery_parts.h"

#include "app/workbench/kit/message_banner.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/recovery_controller.h"
#include "app/workbench/tune/history/recovery_strip.h"

namespace tactus::workbench {

RecoveryParts::RecoveryParts(MainWindow& window, ModelFiles& files, AutosaveController& autosave,
                             RecoveryController& recovery, EditController& edits, StudyConnection& study) {
  auto* strip = new RecoveryStrip(recovery);
  window.addStrip(strip);
  QObject::connect(strip, &RecoveryStrip::restoreRequested, &recovery, [&files, &recovery] {
    if (files.mayLoseChanges()) recovery.restore();
  });
  QObject::connect(&recovery, &RecoveryController::studyNeeded, &study, &StudyConnection::open);
  QObject::connect(&recovery, &RecoveryController::restored, &edits, &EditController::reported);
  QObject::connect(&recovery, &RecoveryController::failed, &window.banner(), &MessageBanner::showError);
  QObject::connect(&autosave, &AutosaveController::failed, &window.banner(), &MessageBanner::showError);
  QObject::connect(&autosave, &AutosaveController::said, &window.banner(), &MessageBanner::showNote);
}

}  // namespace tactus::workbench
