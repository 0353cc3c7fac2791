#include "app/workbench/collect_parts.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/experts/experts_lab_view.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/force/force_terms_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/method/method_lab_view.h"
#include "app/workbench/labs/origins/origin_window.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/labs/speed/cluster_page.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/labs/speed/trace_row.h"
#include "app/workbench/model/author_name.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study_parts.h"
#include "app/workbench/take_part.h"
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
  screen_->watch(model_, tr("Building the model"));
  screen_->addLab(tr("Force"), force_view_, &corrections_);
  screen_->watch(force_.work(), tr("Counting the votes"));
  screen_->addLab(tr("Rules"), rules_view_, &corrections_);
  screen_->watch(rules_.work(), tr("Comparing the experts"));
  screen_->watch([this] { return rules_.isComparing(); });
  // The screen ends before what they read.
  auto* const experts_lab = new ExpertsLab(data_, model_, screen_);
  auto* const experts = new ExpertsLabView(*experts_lab);
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
  screen_->watch(experts_lab->work(), tr("Comparing the weights"));
  screen_->watch(experts_lab->bands().work(), tr("Drawing participants again"));
  auto* const method = new MethodLab(data_, screen_);
  screen_->addLab(tr("Method"), new MethodLabView(*method), nullptr);
  screen_->watch(method->work(), tr("Comparing the choices of the method"));
  screen_->watch([method] { return method->isDrawing(); });
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

CollectParts::CollectParts(MainWindow& window, StudyParts& study_parts, StudyConnection& study,
                           StudyModels& study_models, DeviceSession& device, const AuthorName& author)
    : window_(window),
      study_parts_(study_parts),
      study_(study),
      study_models_(study_models),
      collect_(study),
      protocol_(study),
      view_(new CollectView(collect_, protocol_, [&author] { return author.name(); })),
      run_(window, study, device) {
  window_.addScreen(Stage::kCollect, view_, MainWindow::Needs::kStudy);
  connectAll();
}

void CollectParts::connectAll() {
  connect(&study_, &StudyConnection::opened, this, &CollectParts::onOpened);
  connect(&study_, &StudyConnection::closed, this, [this] {
    // A window that was closed leads nowhere any more.
    if (window_.isVisible()) window_.setStudyOpen(false);
  });
  connect(&study_models_, &StudyModels::notesChanged, this, [this] { view_->home().showData(study_models_.notes()); });
  connect(&view_->home(), &StudyHome::startAsked, &run_, &SessionRun::start);
  connect(&view_->home(), &StudyHome::usabilityAsked, &run_, &SessionRun::startUsability);
  connect(&run_, &SessionRun::changed, this, [this] { collect_.setSessionRunning(run_.isRunning()); });
  connect(&run_, &SessionRun::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The session did not begin. %1").arg(sentence),
                                {tr("Try again"), [this] { run_.startAgain(); }});
  });
  connect(&run_, &SessionRun::refused, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The session did not begin. %1").arg(sentence),
                                {tr("Edit the protocol"), [this] { showProtocol(); }});
  });
  connectErrors();
  connect(&protocol_, &ProtocolController::stored, this, [this](int version) {
    window_.say(tr("Version %1 of the protocol is stored in %2.").arg(version).arg(study_.fileName()));
  });
  connect(&protocol_, &ProtocolController::keyStored, this, [this](bool is_set) {
    window_.say(is_set ? tr("The research key is set.") : tr("The research key is removed."));
  });
  connect(&collect_, &CollectController::withdrawn, this, [this](const QString& code) {
    window_.banner().showNote(
        tr("Everything of %1 is deleted from %2. Backups and exports made before can still hold the data.")
            .arg(code, study_.fileName()));
  });
}

void CollectParts::showProtocol() {
  window_.enter(Stage::kCollect);
  view_->showProtocol();
}

void CollectParts::connectErrors() {
  const auto show = [this](const QString& sentence, const MessageAct& act) {
    window_.banner().showRemedy(sentence, act);
  };
  connect(&protocol_, &ProtocolController::refused, this, [this, show](const QString& sentence) {
    show(sentence, {tr("Edit the protocol"), [this] { showProtocol(); }});
  });
  connect(&protocol_, &ProtocolController::notRead, this, [this, show](const QString& sentence) {
    show(sentence, {tr("Read it again"), [this] { protocol_.read(); }});
  });
  connect(&protocol_, &ProtocolController::keyRefused, this, [this, show](const QString& sentence) {
    show(sentence, {tr("Enter the key again"), [this] {
                      window_.enter(Stage::kCollect);
                      view_->showKey();
                    }});
  });
  connect(&collect_, &CollectController::refused, this, show);
  connect(&collect_, &CollectController::withdrawalRefused, this,
          [this, show](const study::RecordId& person, const QString& sentence) {
            show(sentence, {tr("Withdraw again…"), [this, person] { view_->askWithdrawal(person); }});
          });
}

void CollectParts::makeStudy() { study_parts_.chooseNew(); }

// A study without a model has nothing else to show, unless an open model is recorded into it.
void CollectParts::onOpened() {
  window_.setStudyOpen(true);
  if (!study_models_.hasModel() && !study_parts_.isToRecord()) window_.enter(Stage::kCollect);
}

}  // namespace tactus::workbench
