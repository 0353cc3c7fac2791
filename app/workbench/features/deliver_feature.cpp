#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/deliver/bundle_panel.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/deliver/readiness_panel.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/features/felt_states.h"
#include "app/workbench/feel/procedure.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/finding_words.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/understand/curves/curves_panel.h"

namespace tactus::workbench {
namespace {

struct LinkFeature {
  Q_DECLARE_TR_FUNCTIONS(LinkFeature)

 public:
  /// Where the simulators are on the x axis of the curves.
  static std::vector<SimulatorMark> marks(const LinkController& link, const SceneController& scene);
};

/// The value that a simulator gives for an input; nothing: it does not say it.
std::optional<double> saidOf(const link::Felt& felt, const fuzzy::Variable& input) {
  if (fuzzy::roleOf(input) == fuzzy::Role::kWay) return felt.depth_mm;
  if (fuzzy::roleOf(input) == fuzzy::Role::kRate) return felt.speed_mm_s;
  const auto said = felt.conditions.find(input.id);
  return said != felt.conditions.end() ? std::optional(said->second) : std::nullopt;
}

/// Whether a simulator runs under other conditions than those for which the curves are drawn.
bool isElsewhere(const link::Felt& felt, const SceneController& scene) {
  constexpr double kSame = 1e-3;  // of the universe: less is not seen on the screen
  const auto& inputs = scene.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto said = felt.conditions.find(inputs[i].id);
    if (i == scene.xInput() || said == felt.conditions.end()) continue;
    if (std::abs(said->second - scene.value(i)) > kSame * (inputs[i].max - inputs[i].min)) return true;
  }
  return false;
}

std::vector<SimulatorMark> LinkFeature::marks(const LinkController& link, const SceneController& scene) {
  constexpr int kLongestName = 24;
  std::vector<SimulatorMark> marks;
  if (!scene.model()) return marks;
  for (const Simulator& simulator : link.simulators()) {
    const auto x = saidOf(simulator.felt, scene.xVariable());
    if (!x) continue;
    QString name = simulator.name.isEmpty()
                       ? tr("From the simulator")
                       : tr("From the simulator %1").arg(harmless(simulator.name.left(kLongestName)));
    if (isElsewhere(simulator.felt, scene)) name = tr("%1, under other conditions").arg(name);
    marks.push_back({std::move(name), *x, simulator.felt.force_n});
  }
  return marks;
}

}  // namespace

void addLink(Bench& bench) {
  FeelController& feel = bench.feel;
  LinkController& link = bench.link;
  MainWindow& window = bench.window;
  QObject* const context = &bench.features;
  auto* const dialog = new LinkDialog(link, &window);
  bench.views.link = dialog;
  QAction* const serve = window.menus().addAction(MenuSlot::kFeelLink, LinkFeature::tr("Serve to a s&imulator…"));
  auto* sign = new LinkSign(link);
  window.strip().addState(sign);
  QObject::connect(sign, &QToolButton::clicked, dialog, &LinkDialog::bringUp);
  QObject::connect(&link, &LinkController::allLeft, context,
                   [&window] { window.say(LinkFeature::tr("The last simulator has left.")); });
  serve->setEnabled(bench.models.current() != nullptr);
  QObject::connect(&bench.models, &ModelController::opened, serve, [serve] { serve->setEnabled(true); });
  QObject::connect(serve, &QAction::triggered, dialog, &LinkDialog::bringUp);
  const auto felt = std::make_shared<FeltStates>(feel, bench.scene);
  QObject::connect(&feel, &FeelController::sampled, context, [&link, felt](std::span<const haptics::Sample> samples) {
    if (link.wantsStates()) link.tell(felt->of(samples));
  });
  QObject::connect(&feel, &FeelController::stateChanged, context, [&feel, &link, felt, ran = false]() mutable {
    if (std::exchange(ran, feel.isRunning()) && !ran && link.wantsStates()) link.tell(felt->afterRun());
  });
  const auto show_simulators = [&link, &bench] {
    bench.views.curves->setSimulators(LinkFeature::marks(link, bench.scene));
  };
  QObject::connect(&link, &LinkController::simulatorsMoved, bench.views.curves, show_simulators);
  QObject::connect(&bench.scene, &SceneController::xInputChanged, bench.views.curves, show_simulators);
  QObject::connect(&bench.scene, &SceneController::modelChanged, bench.views.curves, show_simulators);
  QObject::connect(&link, &LinkController::changed, context, [&link, &window, serving = false]() mutable {
    if (std::exchange(serving, link.isServing()) == link.isServing()) return;
    window.say(serving ? LinkFeature::tr("Simulators can connect to %1.").arg(link.address())
                       : LinkFeature::tr("Simulators are no longer served."));
  });
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

DeliverContracts summary(const ContractsController& contracts) {
  DeliverContracts out;
  out.current = contracts.isCurrent();
  out.proved = contracts.count(ContractState::kProved);
  out.broken = contracts.count(ContractState::kBroken);
  out.open = contracts.count(ContractState::kOpen);
  const auto& shown = contracts.shown();
  const auto first =
      std::find_if(shown.begin(), shown.end(), [](const auto& one) { return one.state == ContractState::kBroken; });
  if (first != shown.end()) out.first_broken = first->sentence;
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

struct DeliverFeature {
  Q_DECLARE_TR_FUNCTIONS(DeliverFeature)

 public:
  static void lead(Bench& bench, ReadinessTopic topic);
  static void showFindings(Bench& bench, ReadinessTopic topic);
  static void showOrigin(Bench& bench);
  static void showNotes(Bench& bench);
  static void popUp(Bench& bench, const QVector<NoteGroup>& groups);
  static void make(Bench& bench);
  static void readBack(Bench& bench);
  /// Where the dialogs begin.
  static QString startFolder(const Bench& bench);
};

void DeliverFeature::lead(Bench& bench, ReadinessTopic topic) {
  switch (topic) {
    case ReadinessTopic::kHoles:
    case ReadinessTopic::kForceSteps:
    case ReadinessTopic::kConflicts:
    case ReadinessTopic::kExpertsApart: showFindings(bench, topic); break;
    case ReadinessTopic::kContracts:
      bench.window.enter(Stage::kTune);
      bench.panels.contracts->reveal();
      break;
    case ReadinessTopic::kSignOff:
      bench.window.enter(Stage::kTune);
      bench.panels.history->reveal();
      bench.views.history->askSignOff();
      break;
    case ReadinessTopic::kData: showNotes(bench); break;
    case ReadinessTopic::kMethod:
    case ReadinessTopic::kOrigin: showOrigin(bench); break;
    case ReadinessTopic::kChecks: readBack(bench); break;
  }
}

void DeliverFeature::showFindings(Bench& bench, ReadinessTopic topic) {
  bench.window.enter(Stage::kTune);
  bench.panels.findings->reveal();
  if (!bench.findings.isCurrent()) return;
  const auto& all = bench.findings.findings();
  const auto first =
      std::find_if(all.begin(), all.end(), [topic](const ShownFinding& shown) { return isAbout(shown, topic); });
  if (first != all.end()) bench.findings.choose(static_cast<std::size_t>(first - all.begin()));
}

void DeliverFeature::popUp(Bench& bench, const QVector<NoteGroup>& groups) {
  showNotesPopup(bench.window, bench.panels.readiness->mapToGlobal(bench.panels.readiness->rect().center()), groups);
}

void DeliverFeature::showNotes(Bench& bench) {
  QVector<NoteGroup> groups;
  for (NoteGroup& group : QVector{dataGroup(bench.readiness.notes()), buildGroup(bench.readiness.notes())}) {
    if (!group.sentences.isEmpty()) groups << std::move(group);
  }
  if (groups.isEmpty()) groups << NoteGroup{tr("Notes on the data"), {tr("The open study has no note on this model.")}};
  popUp(bench, groups);
}

void DeliverFeature::showOrigin(Bench& bench) {
  const auto open = bench.models.current();
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
  popUp(bench, {group});
}

QString DeliverFeature::startFolder(const Bench& bench) {
  const auto open = bench.models.current();
  const QString before = bench.settings.value(QLatin1String(kFolderKey)).toString();
  return !before.isEmpty() ? before : open ? QFileInfo(open->path).absolutePath() : documentsFolder();
}

void DeliverFeature::make(Bench& bench) {
  const auto open = bench.models.current();
  if (!open) return;
  const QString chosen = file_dialog::getFolderToWrite(&bench.window, tr("Folder for the bundle"),
                                                       QDir(startFolder(bench)).filePath(bundleName(open->path)));
  if (chosen.isEmpty()) return;
  bench.settings.setValue(QLatin1String(kFolderKey), QFileInfo(chosen).absolutePath());
  bench.bundles.make(bundleFolder(chosen, open->path));
}

void DeliverFeature::readBack(Bench& bench) {
  const QString folder = file_dialog::getExistingDirectory(&bench.window, tr("Folder of a bundle"), startFolder(bench));
  if (folder.isEmpty()) return;
  bench.settings.setValue(QLatin1String(kFolderKey), QFileInfo(folder).absolutePath());
  bench.bundles.readBack(folder);
}

}  // namespace

void addDeliver(Bench& bench) {
  QObject* const context = &bench.features;
  ReadinessController& readiness = bench.readiness;
  auto* lines = new ReadinessPanel(readiness);
  auto* bundle = new BundlePanel(bench.bundles, readiness);
  bench.panels.readiness = &bench.window.addPanel(QStringLiteral("readiness"), DeliverFeature::tr("Readiness"), lines);
  bench.panels.bundle = &bench.window.addPanel(QStringLiteral("bundle"), DeliverFeature::tr("Bundle"), bundle);
  auto* live = new LinkRow(bench.link);
  bundle->addBelow(live);
  auto* report = new QWidget(bundle);
  auto* write = new QPushButton(DeliverFeature::tr("Write the report…"), report);
  write->setMinimumHeight(4 * theme::kGrid);
  auto* what = new QLabel(
      DeliverFeature::tr("The data of the open study and every step to the model, as a page to print."), report);
  setMuted(*what);
  what->setWordWrap(true);
  makeRow(report, {write, {what, 1}}, 2 * theme::kGrid);
  bundle->addBelow(report);
  QObject::connect(write, &QPushButton::clicked, context, [&bench] { bench.report->choose(); });
  const auto may_write = [&bench, write] { write->setEnabled(bench.study.isOpen() && !bench.report->isBusy()); };
  may_write();
  QObject::connect(&bench.study, &StudyConnection::opened, context, may_write);
  QObject::connect(&bench.study, &StudyConnection::closed, context, may_write);
  QObject::connect(bench.panels.readiness, &QDockWidget::visibilityChanged, lines,
                   [&bench, lines](bool visible) { bench.contracts.hold(*lines, visible); });
  QObject::connect(live, &LinkRow::asked, bench.views.link, &LinkDialog::bringUp);
  QObject::connect(lines, &ReadinessPanel::asked, context,
                   [&bench](ReadinessTopic topic) { DeliverFeature::lead(bench, topic); });
  QObject::connect(bundle, &BundlePanel::wanted, context, [&bench] { DeliverFeature::make(bench); });
  QObject::connect(bundle, &BundlePanel::readBackWanted, context, [&bench] { DeliverFeature::readBack(bench); });
  const auto take_findings = [&bench] { bench.readiness.setFindings(summary(bench.findings)); };
  QObject::connect(&bench.findings, &FindingsController::changed, &readiness, take_findings);
  take_findings();
  const auto take_contracts = [&bench] { bench.readiness.setContracts(summary(bench.contracts)); };
  QObject::connect(&bench.contracts, &ContractsController::changed, &readiness, take_contracts);
  take_contracts();
  const auto take_notes = [&bench] {
    bench.readiness.setNotes(bench.study_models.keepsModel() ? bench.study_models.notes() : BuildNotes());
  };
  QObject::connect(&bench.study_models, &StudyModels::notesChanged, &readiness, take_notes);
  QObject::connect(&bench.study_models, &StudyModels::savedChanged, &readiness, take_notes);
  take_notes();
}

}  // namespace tactus::workbench
