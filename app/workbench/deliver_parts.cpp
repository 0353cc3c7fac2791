#include "app/workbench/deliver_parts.h"

#include <QAction>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>
#include <variant>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/deliver/bundle_maker.h"
#include "app/workbench/deliver/bundle_panel.h"
#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/deliver/readiness.h"
#include "app/workbench/deliver/readiness_panel.h"
#include "app/workbench/edit_parts.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/feel/procedure.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/finding_words.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/tune/findings/findings_controller.h"

namespace tactus::workbench {
namespace {

/// The values of the inputs that the hand does not move.
std::vector<std::pair<std::string, double>> conditionsOf(const SceneController& scene) {
  std::vector<std::pair<std::string, double>> conditions;
  const auto& inputs = scene.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (inputs[i].id != kDepthId && inputs[i].id != kSpeedId) conditions.emplace_back(inputs[i].id, scene.value(i));
  }
  return conditions;
}

std::vector<link::LinkSetting::Region> regionsOf(const fuzzy::ForceModel& model) {
  std::vector<link::LinkSetting::Region> regions;
  if (const auto depth = inputNamed(model, kDepthId)) {
    for (const DepthRegion& region : depthRegions(model.inputs[*depth]))
      regions.push_back({region.from_mm, region.to_mm, region.id});
  }
  return regions;
}

}  // namespace

std::shared_ptr<const link::LinkSetting> FeltStates::setting() {
  const bool same_model = setting_ && model_ == scene_.shared();
  auto made = std::make_shared<link::LinkSetting>();
  made->conditions = conditionsOf(scene_);
  const auto device = feel_.device();
  made->simulated = device ? device->simulated || feel_.isReplay() : setting_ && setting_->simulated;
  if (same_model && made->conditions == setting_->conditions && made->simulated == setting_->simulated) return setting_;
  made->regions = same_model ? setting_->regions : regionsOf(scene_.model()->model);
  model_ = scene_.shared();
  setting_ = std::move(made);
  return setting_;
}

link::LinkStates FeltStates::of(std::span<const haptics::Sample> samples) {
  if (samples.empty() || !scene_.model()) return {};
  if (feel_.runs() != run_) {
    run_ = feel_.runs();
    run_began_ns_ = samples.front().time_ns;
  }
  link::LinkStates states{setting(), {}};
  states.states.reserve(samples.size());
  for (const haptics::Sample& sample : samples) {
    link::LinkState state;
    state.time_s = static_cast<double>(sample.time_ns - run_began_ns_) * 1e-9;
    state.depth_mm = sample.depth_mm + feel_.depthOffsetMm();
    state.speed_mm_s = sample.speed_mm_s;
    state.slip_speed_mm_s = sample.slip_speed_mm_s;
    state.force_n = sample.force_n;
    state.model_force_n = sample.model_force_n;
    state.held = sample.enabled;
    state.held_last = sample.held;
    state.stroke = sample.stroke;
    states.states.push_back(state);
  }
  return states;
}

link::LinkStates FeltStates::afterRun() {
  if (run_ == 0 || feel_.runs() != run_) return {};
  haptics::Sample last = feel_.latest();
  last.force_n = last.model_force_n = last.speed_mm_s = last.slip_speed_mm_s = 0;
  last.enabled = last.held = false;
  return of({&last, 1});
}

LinkParts::LinkParts(MainWindow& window, const ModelController& models, const SceneController& scene,
                     FeelController& feel, LinkController& link)
    : window_(window),
      feel_(feel),
      link_(link),
      states_(feel, scene),
      dialog_(new LinkDialog(link, &window)),
      serve_(window.menus().addAction(MenuSlot::kFeelLink, tr("Serve to a s&imulator…"))) {
  auto* sign = new LinkSign(link);
  window.strip().addState(sign);
  connect(sign, &QToolButton::clicked, this, &LinkParts::showDialog);
  connect(&link_, &LinkController::allLeft, this, [this] { window_.say(tr("The last simulator has left.")); });
  serve_->setEnabled(models.current() != nullptr);
  connect(&models, &ModelController::opened, serve_, [this] { serve_->setEnabled(true); });
  connect(serve_, &QAction::triggered, this, &LinkParts::showDialog);
  connect(&feel_, &FeelController::sampled, this, [this](std::span<const haptics::Sample> samples) {
    if (link_.wantsStates()) link_.tell(states_.of(samples));
  });
  connect(&feel_, &FeelController::stateChanged, this, &LinkParts::showFelt);
  connect(&link_, &LinkController::changed, this, [this] {
    if (std::exchange(serving_, link_.isServing()) == link_.isServing()) return;
    window_.say(serving_ ? tr("Simulators can connect to %1.").arg(link_.address())
                         : tr("Simulators are no longer served."));
  });
}

void LinkParts::showDialog() {
  dialog_->show();
  dialog_->raise();
  dialog_->activateWindow();
}

void LinkParts::showFelt() {
  if (std::exchange(felt_, feel_.isRunning()) && !felt_ && link_.wantsStates()) link_.tell(states_.afterRun());
}

namespace {

constexpr auto kFolderKey = "bundle_folder";

using Kind = elicitation::RuleFinding::Kind;

/// A place where no rule of any expert fires; null for every other finding.
const analysis::Hole* holeOfMean(const ShownFinding& shown) {
  const bool is_one =
      shown.finding.kind == Kind::kHole && shown.finding.experts.empty() && shown.acceptance != Acceptance::kLapsed;
  return is_one ? std::get_if<analysis::Hole>(&shown.finding.where) : nullptr;
}

DeliverFindings summary(const FindingsController& findings) {
  DeliverFindings out;
  const fuzzy::ForceModel* model = findings.lintedModel();
  out.current = findings.isCurrent() && model != nullptr;
  if (!out.current) return out;
  out.complete = findings.lint()->model.coverage_complete;
  double most_apart = 0;
  double largest_step = 0;
  for (const ShownFinding& shown : findings.findings()) {
    if (const analysis::Hole* hole = holeOfMean(shown)) {
      out.holes.push_back(
          {describe(*hole, *model), holeText(*model, *hole), shown.acceptance == Acceptance::kAccepted});
    }
    if (shown.finding.kind == Kind::kConflict) ++out.conflicts;
    if (shown.finding.kind == Kind::kForceStep) {
      ++out.steps;
      largest_step = std::max(largest_step, shown.finding.newtons.value_or(0));
    }
    if (shown.finding.kind != Kind::kExpertsApart) continue;
    ++out.apart;
    most_apart = std::max(most_apart, shown.finding.newtons.value_or(0));
  }
  out.most_apart = forceText(most_apart, model->output.unit);
  out.largest_step = forceText(largest_step, model->output.unit);
  return out;
}

bool isAbout(const ShownFinding& shown, ReadinessTopic topic) {
  switch (topic) {
    case ReadinessTopic::kHoles: return holeOfMean(shown) != nullptr;
    case ReadinessTopic::kForceSteps: return shown.finding.kind == Kind::kForceStep;
    case ReadinessTopic::kConflicts: return shown.finding.kind == Kind::kConflict;
    default: return shown.finding.kind == Kind::kExpertsApart;
  }
}

}  // namespace

DeliverParts::DeliverParts(MainWindow& window, const ModelController& models, FindingsController& findings,
                           Panel& findings_panel, HistoryParts& history, BundleMaker& maker,
                           ReadinessController& readiness, StudyModels& study_models, const LinkController& link,
                           LinkParts& link_parts, QSettings& settings)
    : window_(window),
      models_(models),
      findings_(findings),
      findings_panel_(findings_panel),
      history_(history),
      maker_(maker),
      readiness_(readiness),
      settings_(settings) {
  auto* lines = new ReadinessPanel(readiness);
  auto* bundle = new BundlePanel(maker, readiness);
  readiness_panel_ = &window.addPanel(QStringLiteral("readiness"), tr("Readiness"), lines);
  bundle_panel_ = &window.addPanel(QStringLiteral("bundle"), tr("Bundle"), bundle);
  auto* live = new LinkRow(link);
  bundle->addBelow(live);
  connect(live, &LinkRow::asked, &link_parts, &LinkParts::showDialog);
  connect(lines, &ReadinessPanel::asked, this, &DeliverParts::lead);
  connect(bundle, &BundlePanel::wanted, this, &DeliverParts::make);
  connect(bundle, &BundlePanel::readBackWanted, this, &DeliverParts::readBack);
  connect(&findings_, &FindingsController::changed, &readiness,
          [this, &readiness] { readiness.setFindings(summary(findings_)); });
  readiness.setFindings(summary(findings_));
  const auto take_notes = [&study_models, &readiness] {
    readiness.setNotes(study_models.keepsModel() ? study_models.notes() : BuildNotes());
  };
  connect(&study_models, &StudyModels::notesChanged, &readiness, take_notes);
  connect(&study_models, &StudyModels::savedChanged, &readiness, take_notes);
  take_notes();
}

void DeliverParts::lead(ReadinessTopic topic) {
  switch (topic) {
    case ReadinessTopic::kHoles:
    case ReadinessTopic::kForceSteps:
    case ReadinessTopic::kConflicts:
    case ReadinessTopic::kExpertsApart: showFindings(topic); break;
    case ReadinessTopic::kSignOff:
      window_.enter(Stage::kTune);
      history_.askSignOff();
      break;
    case ReadinessTopic::kData: showNotes(); break;
    case ReadinessTopic::kMethod:
    case ReadinessTopic::kOrigin: showOrigin(); break;
    case ReadinessTopic::kChecks: readBack(); break;
  }
}

void DeliverParts::showFindings(ReadinessTopic topic) {
  window_.enter(Stage::kTune);
  findings_panel_.reveal();
  if (!findings_.isCurrent()) return;
  const auto& all = findings_.findings();
  const auto first =
      std::find_if(all.begin(), all.end(), [topic](const ShownFinding& shown) { return isAbout(shown, topic); });
  if (first != all.end()) findings_.choose(static_cast<std::size_t>(first - all.begin()));
}

void DeliverParts::popUp(const QVector<NoteGroup>& groups) {
  showNotesPopup(window_, readiness_panel_->mapToGlobal(readiness_panel_->rect().center()), groups);
}

void DeliverParts::showNotes() {
  QVector<NoteGroup> groups;
  for (NoteGroup& group : QVector{dataGroup(readiness_.notes()), buildGroup(readiness_.notes())}) {
    if (!group.sentences.isEmpty()) groups << std::move(group);
  }
  if (groups.isEmpty()) groups << NoteGroup{tr("Notes on the data"), {tr("The open study has no note on this model.")}};
  popUp(groups);
}

void DeliverParts::showOrigin() {
  const auto open = models_.current();
  if (!open) return;
  NoteGroup group{tr("Origin of the data"), {}};
  if (const auto& origin = open->model.provenance) {
    if (!origin->study.empty()) group.sentences << tr("Study: %1").arg(harmless(text(origin->study)));
    if (!origin->notes.empty()) group.sentences << harmless(text(origin->notes));
    for (const auto* members : {&origin->sources, &origin->settings}) {
      for (const fuzzy::NamedJson& member : *members)
        group.sentences << tr("%1: %2").arg(harmless(text(member.key)), harmless(text(member.json)));
    }
  }
  if (group.sentences.isEmpty()) group.sentences << tr("The file does not say what data the model is from.");
  popUp({group});
}

QString DeliverParts::askFolder(const QString& title) {
  const auto open = models_.current();
  const QString before = settings_.value(QLatin1String(kFolderKey)).toString();
  const QString start = !before.isEmpty() ? before : open ? QFileInfo(open->path).absolutePath() : QString();
  const QString folder = file_dialog::getExistingDirectory(&window_, title, start);
  if (!folder.isEmpty()) settings_.setValue(QLatin1String(kFolderKey), folder);
  return folder;
}

void DeliverParts::make() {
  const QString chosen = askFolder(tr("Folder for the bundle"));
  const auto open = models_.current();
  if (!chosen.isEmpty() && open) maker_.make(bundleFolder(chosen, open->path));
}

void DeliverParts::readBack() {
  const QString folder = askFolder(tr("Folder of a bundle"));
  if (!folder.isEmpty()) maker_.readBack(folder);
}

}  // namespace tactus::workbench
