// Connects the numbers of bench and labs with the records behind them: who asks "Where does this come from?", and which
// lab shows a record.
#pragma once

#include <QObject>

#include "app/workbench/labs/origins/origin_finder.h"

namespace tactus::workbench {

class CurvesPanel;
class LabParts;
class MainWindow;
class MembershipEditor;
class ModelController;
class OriginWindow;
class RuleController;
class SceneController;
class StudyConnection;
class StudyModels;
class TermController;

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
