// Adds stage Collect to the window: the study's home, its protocol, sessions on the participant's screens, and the ways
// to it from the start screen.
#pragma once

#include <QObject>

#include "app/workbench/collect/collect_controller.h"
#include "app/workbench/collect/protocol_controller.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/origins/origin_finder.h"
#include "app/workbench/labs/rules/rules_lab.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/take_part.h"

namespace tactus::workbench {

class AuthorName;
class CollectView;
class CurvesPanel;
class DepthLabView;
class DeviceSession;
class ForceLabView;
class MainWindow;
class MembershipEditor;
class ModelController;
class ModelFiles;
class OriginWindow;
class RuleController;
class RulesLabView;
class SceneController;
class SessionRun;
class SpeedLabView;
class StudyConnection;
class StudyModels;
class StudyParts;
class TermController;

// Adds stage Agree to the window: the labs, which lead from recordings to an agreed model.

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
  RulesLab rules_{model_, corrections_};
  DepthLab depth_;
  LabScreen* screen_;
  DepthLabView* depth_view_;
  SpeedLabView* speed_view_;
  ForceLabView* force_view_;
  RulesLabView* rules_view_;
};

class CollectParts : public QObject {
  Q_OBJECT

 public:
  CollectParts(MainWindow& window, StudyParts& study_parts, StudyConnection& study, StudyModels& study_models,
               DeviceSession& device, const AuthorName& author);

  CollectController& collect() { return collect_; }
  ProtocolController& protocol() { return protocol_; }
  CollectView& view() { return *view_; }
  SessionRun& run() { return run_; }
  /// Asks for the place of a new study and makes it. A study without a model enters this stage.
  void makeStudy();
  /// The study is read.
  bool isReady() const { return protocol_.isReady(); }

 private:
  void connectAll();
  void connectErrors();
  void showProtocol();
  void onOpened();

  MainWindow& window_;
  StudyParts& study_parts_;
  StudyConnection& study_;
  StudyModels& study_models_;
  CollectController collect_;
  ProtocolController protocol_;
  CollectView* view_;
  SessionRun run_;
};

// Connects the numbers of bench and labs with the records behind them: who asks "Where does this come from?", and which
// lab shows a record.

class OriginParts : public QObject {
  Q_OBJECT

 public:
  struct Controllers {
    const ModelController& models;
    const SceneController& scene;
    const TermController& terms;
    const RuleController& rules;
    const StudyConnection& study;
    const StudyModels& study_models;
  };
  OriginParts(MainWindow& window, LabParts& labs, const Controllers& controllers, MembershipEditor& editor,
              CurvesPanel& curves);

  /// Ends its window, which shows what ends here.
  ~OriginParts() override;

  OriginFinder& finder() { return finder_; }
  /// The window; null before the first question.
  OriginWindow* view() { return view_; }

 private:
  void connectBench(MembershipEditor& editor, const RuleController& rules, CurvesPanel& curves);
  void connectLabs();
  /// A number of the model that the labs build.
  void askLabs(OriginQuestion question);
  /// A number of the model on the bench, which may not be built from the open study.
  void askBench(OriginQuestion question);
  QString whyNotOfStudy() const;
  void show(OriginQuestion question, const QString& not_of_study);
  void lead(const OriginRecord& record);

  MainWindow& window_;
  LabParts& labs_;
  Controllers on_;
  OriginFinder finder_;
  OriginWindow* view_ = nullptr;
};

}  // namespace tactus::workbench
