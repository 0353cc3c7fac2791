#include "app/workbench/lab_parts.h"

#include "app/workbench/kit/message_banner.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/session_run.h"
#include "app/workbench/shell/main_window.h"

namespace tactus::workbench {

LabParts::LabParts(MainWindow& window, StudyConnection& study, const SessionRun& run)
    : data_(study), screen_(new LabScreen(data_)), speed_view_(new SpeedLabView(speed_, corrections_)) {
  screen_->addLab(tr("Speed"), speed_view_, &corrections_);
  screen_->watch(speed_.work(), tr("Clustering the speeds"));
  screen_->watch(model_.work(), tr("Building the model"));
  window.addScreen(Stage::kAgree, screen_, MainWindow::Needs::kStudy);
  connect(&run, &SessionRun::changed, this, [this, &run] { data_.setSessionRunning(run.isRunning()); });
  connect(&corrections_, &Corrections::stored, this, [&window](const QString& what) {
    window.say(tr("Stored as a new record; the old one stays: %1").arg(what));
  });
  connect(&corrections_, &Corrections::refused, this,
          [&window](const QString& sentence) { window.banner().showError(sentence); });
}

LabParts::~LabParts() { delete screen_; }

}  // namespace tactus::workbench
