// Adds stage Agree to the window: the labs, which lead from recordings to an agreed model.
#pragma once

#include <QObject>

#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/lab_model.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/experts/experts_lab.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/method/method_lab.h"
#include "app/workbench/labs/rules/rules_lab.h"
#include "app/workbench/labs/speed/speed_lab.h"

namespace tactus::workbench {

class AuthorName;
class DepthLabView;
class ForceLabView;
class MainWindow;
class ModelController;
class ModelFiles;
class RulesLabView;
class SessionRun;
class SpeedLabView;
class StudyModels;

class LabParts : public QObject {
  Q_OBJECT

 public:
  LabParts(MainWindow& window, ModelFiles& files, StudyConnection& study, StudyModels& study_models,
           const ModelController& models, const SessionRun& run, const AuthorName& author);
  /// Takes the screen out of the window, because it shows what ends here.
  ~LabParts() override;

  LabData& data() { return data_; }
  LabModel& model() { return model_; }
  Corrections& corrections() { return corrections_; }
  LabScreen& screen() { return *screen_; }
  DepthLab& depth() { return depth_; }
  DepthLabView& depthView() { return *depth_view_; }
  MethodLab& method() { return method_; }
  SpeedLab& speed() { return speed_; }
  ForceLabView& forceView() { return *force_view_; }
  RulesLab& rules() { return rules_; }
  RulesLabView& rulesView() { return *rules_view_; }
  SpeedLabView& speedView() { return *speed_view_; }

 private:
  bool leads_to_bench_ = false;  ///< a model is being built for tuning
  LabData data_;
  LabModel model_{data_};
  Corrections corrections_{data_};
  SpeedLab speed_{data_};
  ForceLab force_{data_, model_, corrections_};
  RulesLab rules_{data_, model_, corrections_};
  ExpertsLab experts_{data_, model_};
  MethodLab method_{data_};
  DepthLab depth_;
  LabScreen* screen_;
  DepthLabView* depth_view_;
  SpeedLabView* speed_view_;
  ForceLabView* force_view_;
  RulesLabView* rules_view_;
};

}  // namespace tactus::workbench
