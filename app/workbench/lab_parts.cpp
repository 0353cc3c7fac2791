#include "app/workbench/lab_parts.h"

#include <utility>

#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/experts/experts_lab_view.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/method/method_lab_view.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/model/author_name.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/session_run.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/study/study_models.h"

namespace tactus::workbench {

LabParts::LabParts(MainWindow& window, ModelFiles& files, StudyConnection& study, StudyModels& study_models,
                   const ModelController& models, const SessionRun& run, const AuthorName& author)
    : data_(study),
      depth_(data_, [&author] { return author.name(); }),
      screen_(new LabScreen(data_)),
      depth_view_(new DepthLabView(depth_)),
      speed_view_(new SpeedLabView(speed_, model_, corrections_)),
      force_view_(new ForceLabView(force_)),
      rules_view_(new RulesLabView(rules_)) {
  screen_->addLab(tr("Depth"), depth_view_, &depth_);
  screen_->addLab(tr("Speed"), speed_view_, &corrections_);
  screen_->watch(speed_.work(), tr("Clustering the speeds"));
  screen_->watch(model_.work(), tr("Building the model"));
  screen_->addLab(tr("Force"), force_view_, &corrections_);
  screen_->watch(force_.work(), tr("Counting the votes"));
  screen_->addLab(tr("Rules"), rules_view_, &corrections_);
  screen_->watch(rules_.work(), tr("Comparing the experts"));
  screen_->watch([this] { return rules_.isComparing(); });
  auto* const experts = new ExpertsLabView(experts_);
  screen_->addLab(tr("Experts"), experts, nullptr);
  connect(experts, &ExpertsLabView::benchAsked, this, [this, &files, &study_models] {
    if (!files.mayLoseChanges()) return;
    leads_to_bench_ = true;
    study_models.buildModelWith(data_.settings());
  });
  connect(&models, &ModelController::opened, this, [this, &window] {
    if (std::exchange(leads_to_bench_, false)) window.enter(Stage::kTune);
  });
  connect(&study_models, &StudyModels::backOffered, this, [this, &window] {
    if (std::exchange(leads_to_bench_, false)) window.enter(Stage::kTune);
  });
  connect(&study_models, &StudyModels::failed, this, [this] { leads_to_bench_ = false; });
  screen_->watch(experts_.work(), tr("Comparing the weights"));
  screen_->watch(experts_.bands().work(), tr("Drawing participants again"));
  screen_->addLab(tr("Method"), new MethodLabView(method_), nullptr);
  screen_->watch(method_.work(), tr("Comparing the choices of the method"));
  window.addScreen(Stage::kAgree, screen_, MainWindow::Needs::kStudy);
  // From a setting of the speed lab until every plot in sight is painted with it.
  auto* const clock = new FrameClock(*screen_, this);
  auto* const shown_time = new FrameStatus(*clock);
  window.strip().setFrameTime(shown_time);
  connect(&data_, &LabData::settingsChanged, clock, [this, clock] {
    if (speed_view_->isVisible()) clock->begin();
  });
  connect(&speed_, &SpeedLab::resultChanged, clock, [this, clock] {
    if (speed_.isCurrent()) clock->sent();
  });
  connect(&window, &MainWindow::entered, shown_time, [shown_time](Stage stage) {
    if (stage != Stage::kAgree) shown_time->hide();
  });
  connect(&run, &SessionRun::changed, this, [this, &run] { data_.setSessionRunning(run.isRunning()); });
  connect(&corrections_, &Corrections::stored, this, [&window](const QString& what) {
    window.say(tr("Stored as a new record; the old one stays: %1").arg(what));
  });
  connect(&corrections_, &Corrections::refused, this,
          [&window](const QString& sentence, const MessageAct& act) { window.banner().showRemedy(sentence, act); });
}

LabParts::~LabParts() { delete screen_; }

}  // namespace tactus::workbench
