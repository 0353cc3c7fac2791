#include "app/workbench/origin_parts.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/lab_parts.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/force/force_terms_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/origins/origin_window.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/labs/speed/speed_term_plot.h"
#include "app/workbench/labs/speed/trace_row.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {

OriginParts::OriginParts(MainWindow& window, LabParts& labs, const Controllers& controllers, MembershipEditor& editor,
                         CurvesPanel& curves)
    : window_(window), labs_(labs), on_(controllers), finder_(labs.data(), labs.model()) {
  connectBench(editor, controllers.rules, curves);
  connectLabs();
}

OriginParts::~OriginParts() { delete view_; }

void OriginParts::connectBench(MembershipEditor& editor, const RuleController& rules, CurvesPanel& curves) {
  for (const auto change : {&StudyConnection::opened, &StudyConnection::closed}) {
    connect(&on_.study, change, &editor, [this, &editor] { editor.setOriginsKnown(on_.study.isOpen()); });
  }
  connect(&on_.study, &StudyConnection::closed, this, [this] {
    if (view_ != nullptr) view_->close();
  });
  connect(&editor, &MembershipEditor::originAsked, this,
          [this](const std::string& variable, const std::string& term, std::size_t point) {
            const auto& terms = on_.terms.terms();
            const auto found =
                std::find_if(terms.begin(), terms.end(), [&](const auto& one) { return one.id == term; });
            if (found == terms.end() || point >= found->points.size()) return;
            askBench(VertexQuestion{variable, term, point, found->points[point]});
          });
  connect(&rules, &RuleController::originAsked, this, [this, &rules] {
    const auto cell = rules.selected();
    if (!cell) return;
    if (const auto rule = rules.cell(*cell).rule) {
      askBench(RuleQuestion{rules.expert().id, rules.expert().rules[*rule]});
    }
  });
  connect(&curves, &CurvesPanel::originAsked, this, [this](double x) {
    const OpenModel* const open = on_.scene.model();
    if (open == nullptr) return;
    std::vector<double> point = on_.scene.values();
    point[on_.scene.xInput()] = std::clamp(x, on_.scene.xVariable().min, on_.scene.xVariable().max);
    const auto force = open->compiled.evaluate(point);
    askBench(ForceQuestion{point, force.fired ? std::optional(force.force_n) : std::nullopt});
  });
}

void OriginParts::connectLabs() {
  connect(&labs_.speedView().terms(), &SpeedTermPlot::vertexAsked, this,
          [this](const std::string& term, std::size_t point) {
            askLabs(VertexQuestion{"speed", term, point});
          });
  connect(&labs_.forceView().terms(), &ForceTermsView::vertexAsked, this,
          [this](const std::string& term, std::size_t point) {
            askLabs(VertexQuestion{elicitation::ngtOutput().id, term, point});
          });
  connect(&labs_.forceView().votes(), &VotesView::originAsked, this, [this](double force_n, const std::string& word) {
    askLabs(VoteQuestion{force_n, word});
  });
}

void OriginParts::askLabs(OriginQuestion question) { show(std::move(question), {}); }

void OriginParts::askBench(OriginQuestion question) {
  if (!on_.study.isOpen()) {
    window_.say(tr("No study is open: the records behind a model are in its study."));
    return;
  }
  show(std::move(question), whyNotOfStudy());
}

QString OriginParts::whyNotOfStudy() const {
  const auto open = on_.models.current();
  if (open == nullptr || (on_.study_models.keepsModel() && open->model.provenance)) return {};
  const QString study = on_.study.fileName();
  const QString model = open->model.name.empty() ? shownFileName(open->path) : harmless(text(open->model.name));
  if (!open->model.provenance) {
    return tr("%1 was not built from records: no study is behind its numbers, and none of %2.").arg(model, study);
  }
  if (labs_.data().study() != nullptr && open->model.provenance->study == labs_.data().study()->study.name) return {};
  return tr("%1 was built from the study %2, which is not open. Open it to see the records behind the model; those of "
            "%3 are not.")
      .arg(model, harmless(text(open->model.provenance->study)), study);
}

void OriginParts::show(OriginQuestion question, const QString& not_of_study) {
  if (view_ == nullptr) {
    view_ = new OriginWindow(finder_, &window_);
    auto* const preview = new StrokePreview(labs_.data());
    view_->setPreview(preview, [preview](const OriginRecord& record) {
      if (record.kind != OriginRecord::Kind::kStroke) return false;
      preview->showStroke(record.stroke);
      return true;
    });
    connect(view_, &OriginWindow::recordChosen, this, &OriginParts::lead);
  }
  view_->show();
  view_->raise();
  finder_.ask(std::move(question), not_of_study);
}

void OriginParts::lead(const OriginRecord& record) {
  window_.enter(Stage::kAgree);
  switch (record.kind) {
    case OriginRecord::Kind::kStroke:
      labs_.screen().reveal(&labs_.speedView());
      labs_.speedView().showStroke(record.stroke);
      break;
    case OriginRecord::Kind::kJudgement:
      if (const auto study = labs_.data().study(); study && record.index < study->study.judgements.size()) {
        const auto& one = study->study.judgements[record.index];
        labs_.screen().reveal(&labs_.forceView());
        labs_.forceView().showJudgement(one.participant, one.series, one.force_n);
      }
      break;
    case OriginRecord::Kind::kAnswer:
    case OriginRecord::Kind::kGivenRule:
      labs_.screen().reveal(&labs_.rulesView());
      if (record.rule) labs_.rules().chooseRule(record.rule->expert, record.rule->rule);
      break;
  }
}

}  // namespace tactus::workbench
