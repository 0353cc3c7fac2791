#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/force/force_terms_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/origins/origin_window.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/labs/speed/cluster_page.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/labs/speed/trace_row.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/here/rule_panel.h"

namespace tactus::workbench {

OriginsFeature::OriginsFeature(Bench& bench) : QObject(&bench.features), bench_(bench) {
  connectBench();
  connectLabs();
}

OriginsFeature::~OriginsFeature() { delete view_; }

void OriginsFeature::connectBench() {
  MembershipEditor& editor = *bench_.views.membership_editor;
  const RuleController& rules = bench_.rules;
  for (const auto change : {&StudyConnection::opened, &StudyConnection::closed}) {
    connect(&bench_.study, change, &editor, [this, &editor] {
      editor.setOriginsKnown(bench_.study.isOpen());
      bench_.views.why->setAnswersKnown(bench_.study.isOpen());
    });
  }
  connect(&bench_.study, &StudyConnection::closed, this, [this] {
    if (view_ != nullptr) view_->close();
  });
  connect(&editor, &MembershipEditor::originAsked, this,
          [this](const std::string& variable, const std::string& term, std::size_t point) {
            const auto& terms = bench_.terms.terms();
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
  connect(bench_.views.why, &RulePanel::answerAsked, this, [this](const std::string& expert, const fuzzy::Rule& rule) {
    askBench(RuleQuestion{expert, rule});
  });
  connect(bench_.views.curves, &CurvesPanel::originAsked, this, [this](double x) {
    const OpenModel* const open = bench_.scene.model();
    if (open == nullptr) return;
    std::vector<double> point = bench_.scene.values();
    point[bench_.scene.xInput()] = std::clamp(x, bench_.scene.xVariable().min, bench_.scene.xVariable().max);
    const auto force = open->compiled.evaluate(point);
    askBench(ForceQuestion{point, force.fired ? std::optional(force.force_n) : std::nullopt});
  });
}

void OriginsFeature::connectLabs() {
  connect(&bench_.views.speed->terms(), &SpeedTermPlot::vertexAsked, this,
          [this](const std::string& term, std::size_t point) {
            const auto& study = bench_.labs.data.study();
            if (study == nullptr) return;
            const auto* const rate = procedure::of(study->study).rateInput();
            if (rate != nullptr) show(VertexQuestion{rate->id, term, point});
          });
  connect(&bench_.views.force->terms(), &ForceTermsView::vertexAsked, this,
          [this](const std::string& term, std::size_t point) {
            const auto& study = bench_.labs.data.study();
            if (study != nullptr) show(VertexQuestion{procedure::of(study->study).output.id, term, point});
          });
  connect(&bench_.views.force->votes(), &VotesView::originAsked, this, [this](double force_n, const std::string& word) {
    show(VoteQuestion{force_n, word});
  });
}

void OriginsFeature::askBench(OriginQuestion question) {
  if (!bench_.study.isOpen()) {
    bench_.window.say(tr("No study is open: the records behind a model are in its study."));
    return;
  }
  show(std::move(question), whyNotOfStudy());
}

QString OriginsFeature::whyNotOfStudy() const {
  const auto open = bench_.models.current();
  if (open == nullptr || (bench_.study_models.keepsModel() && open->model.provenance)) return {};
  const QString study = bench_.study.fileName();
  const QString model = open->model.name.empty() ? shownFileName(open->path) : harmless(text(open->model.name));
  if (!open->model.provenance) {
    return tr("%1 was not built from records: no study is behind its numbers, and none of %2.").arg(model, study);
  }
  if (bench_.labs.data.study() != nullptr && open->model.provenance->study == bench_.labs.data.study()->study.name)
    return {};
  return tr("%1 was built from the study %2, which is not open. Open it to see the records behind the model; those of "
            "%3 are not.")
      .arg(model, harmless(text(open->model.provenance->study)), study);
}

void OriginsFeature::show(OriginQuestion question, const QString& not_of_study) {
  if (view_ == nullptr) {
    view_ = new OriginWindow(bench_.labs.origins, &bench_.window);
    auto* const preview = new StrokePreview(bench_.labs.data);
    view_->setPreview(preview, [preview](const OriginRecord& record) {
      if (record.kind != OriginRecord::Kind::kStroke) return false;
      preview->showStroke(record.stroke);
      return true;
    });
    connect(view_, &OriginWindow::recordChosen, this, &OriginsFeature::lead);
    connect(view_, &OriginWindow::participantAsked, this, &OriginsFeature::showParticipant);
  }
  view_->show();
  view_->raise();
  bench_.labs.origins.ask(std::move(question), not_of_study);
}

void OriginsFeature::lead(const OriginRecord& record) {
  bench_.window.enter(Stage::kBuild);
  switch (record.kind) {
    case OriginRecord::Kind::kStroke:
      bench_.views.labs->reveal(bench_.views.speed);
      bench_.views.speed->showStroke(record.stroke);
      break;
    case OriginRecord::Kind::kJudgement:
      if (const auto study = bench_.labs.data.study(); study && record.index < study->study.judgements.size()) {
        const auto& one = study->study.judgements[record.index];
        bench_.views.labs->reveal(bench_.views.force);
        bench_.views.force->showJudgement(one.participant, one.series, one.force_n);
      }
      break;
    case OriginRecord::Kind::kAnswer:
    case OriginRecord::Kind::kGivenRule:
      bench_.views.labs->reveal(bench_.views.rules);
      if (record.rule) bench_.labs.rules.chooseRule(record.rule->expert, record.rule->rule);
      break;
  }
}

// The participant's record in the study, at this answer.
void OriginsFeature::showParticipant(const OriginRecord& record) {
  const auto& study = bench_.labs.data.study();
  if (study == nullptr) return;
  const auto person = std::find_if(study->persons.begin(), study->persons.end(), [&](const study::Person& one) {
    return harmless(text(one.code)) == record.participant;
  });
  if (person == study->persons.end()) return;
  const bool answer = record.kind == OriginRecord::Kind::kAnswer && record.index < study->answer_ids.size();
  bench_.views.collect->showRecord(person->id, answer ? std::optional(study->answer_ids[record.index]) : std::nullopt);
}

void addOrigins(Bench& bench) { bench.origins = new OriginsFeature(bench); }

}  // namespace tactus::workbench
