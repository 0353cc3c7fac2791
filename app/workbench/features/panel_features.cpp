// The panels of the open model that need little wiring, their places, and what is pointed at in them.
#include <QAction>
#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "app/editing/changed_parts.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/findings/findings_panel.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/understand/here/variable_row.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_panel.h"

namespace tactus::workbench {
namespace {

struct PanelFeatures {
  Q_DECLARE_TR_FUNCTIONS(PanelFeatures)
};

// While the model is understood, the editors are elsewhere and stay there until the user asks for them.
void bringForward(const MainWindow& window, Panel& editor) {
  if (window.stage() == Stage::kTune) editor.reveal();
}

void showTerm(Bench& bench) {
  const editing::TermPlace& place = *bench.selection.term();
  bench.terms.setExpert(place.list.expert);
  bench.terms.setVariable(place.list.variable);
  const auto& terms = bench.terms.terms();
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const fuzzy::Term& term) { return term.id == place.term; });
  if (found == terms.end()) return;
  bench.terms.select(Grip{static_cast<std::size_t>(found - terms.begin()), Grip::Part::kTerm});
}

// Silently: the findings stay in front while the user goes through them.
void selectChosen(Bench& bench) {
  const FindingsController& findings = bench.findings;
  if (!findings.chosen() || !findings.isCurrent()) return;
  const auto& rules = findings.findings()[*findings.chosen()].rules;
  std::vector<std::size_t> of_first;
  for (const RuleOfExpert& one : rules) {
    if (one.expert == rules.front().expert) of_first.push_back(one.rule);
  }
  if (of_first.empty()) return;
  bench.selection.setExpert(rules.front().expert);
  bench.selection.selectRules(std::move(of_first));
}

void showEdit(Bench& bench, editing::StateId state) {
  const auto before_it = bench.edits.history().states()[state].parent;
  if (!before_it) return;
  const auto before = bench.edits.readyOf(*before_it);
  const auto after = bench.edits.readyOf(state);
  if (!before || !after) return;
  const editing::ChangedParts parts = editing::changedParts((*before)->model, (*after)->model);
  if (!parts.rules.empty()) {
    bench.selection.pointAtRules(parts.expert, parts.rules);
  } else if (parts.term) {
    bench.selection.pointAtTerm(*parts.term);
  }
}

}  // namespace

void addHere(Bench& bench) {
  bench.panels.terms_here = &bench.window.addPanel(QStringLiteral("terms"), PanelFeatures::tr("Membership functions"),
                                                   new VariableRow(bench.scene));
  bench.views.why = new RulePanel(bench.scene, bench.selection);
  bench.panels.rules_here =
      &bench.window.addPanel(QStringLiteral("rules"), PanelFeatures::tr("Why here"), bench.views.why);
}

void addMap(Bench& bench) {
  auto* forces = new ForceMapController(bench.scene, &bench.features);
  bench.views.map = new MapPanel(bench.scene, *forces);
  bench.panels.map = &bench.window.addPanel(QStringLiteral("map"), PanelFeatures::tr("Map"), bench.views.map);
  bench.panels.surface = &bench.window.addPanel(QStringLiteral("surface"), PanelFeatures::tr("Surface"),
                                                new SurfacePanel(bench.scene, *forces));

  QAction* const picture = bench.window.menus().addAction(
      MenuSlot::kFilePictures, PanelFeatures::tr("Save picture of the &map…"), Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  picture->setEnabled(false);
  QObject::connect(picture, &QAction::triggered, &bench.views.map->plotMenu(), &PlotMenu::choosePicture);
  QObject::connect(&bench.models, &ModelController::opened, picture, [picture, &models = bench.models] {
    picture->setEnabled(models.current()->model.inputs.size() > 1);
  });
}

void addRules(Bench& bench) {
  auto* editor = new RuleEditor(bench.rules);
  bench.panels.rule_editor = &bench.window.addPanel(QStringLiteral("rule_editor"), PanelFeatures::tr("Rules"), editor);
  bench.panels.rule_editor->setFocusProxy(editor);
}

void addFindings(Bench& bench) {
  FindingsController& findings = bench.findings;
  Panel& panel =
      bench.window.addPanel(QStringLiteral("findings"), PanelFeatures::tr("Findings"), new FindingsPanel(findings));
  bench.panels.findings = &panel;
  // The tab says what the last edit added, also while another panel lies on top.
  QObject::connect(&findings, &FindingsController::changed, &panel, [&panel, &findings] {
    const QString title = findings.added() == 0 ? PanelFeatures::tr("Findings")
                                                : PanelFeatures::tr("Findings (+%1)").arg(findings.added());
    if (findings.isCurrent() && title != panel.windowTitle()) panel.setWindowTitle(title);
  });
  // The editors behind the findings then stand at what the finding is about.
  QObject::connect(&findings, &FindingsController::lookedAt, &bench.terms,
                   [&terms = bench.terms, &rules = bench.rules](const QString& expert, const QString& input) {
                     if (!terms.isOpen()) return;
                     if (!expert.isEmpty()) rules.setExpert(expert.toStdString());
                     terms.setExpert(expert.toStdString());
                     if (!input.isEmpty()) terms.setVariable(input.toStdString());
                   });
}

void addContracts(Bench& bench) {
  ContractsController& contracts = bench.contracts;
  Panel& panel =
      bench.window.addPanel(QStringLiteral("contracts"), PanelFeatures::tr("Contracts"), makeContractsPanel(contracts));
  bench.panels.contracts = &panel;
  // The tab says what is broken, also while another panel lies on top: as long as it can be seen, it is kept current.
  QObject::connect(&contracts, &ContractsController::changed, &panel, [&panel, &contracts] {
    const auto broken = static_cast<int>(contracts.count(ContractState::kBroken));
    const QString title =
        broken == 0 ? PanelFeatures::tr("Contracts") : PanelFeatures::tr("Contracts (%n broken)", nullptr, broken);
    if (title != panel.windowTitle()) panel.setWindowTitle(title);
  });
  QObject::connect(&bench.window, &MainWindow::entered, &panel,
                   [&bench, &panel] { bench.contracts.hold(panel, bench.window.stage() == Stage::kTune); });
  QObject::connect(&contracts, &ContractsController::placeShown, &bench.features,
                   [&bench](const std::vector<double>& point) {
                     bench.panels.feel->reveal();
                     const auto way = fuzzy::wayOf(bench.scene.model()->model.inputs);
                     if (way && bench.feel.isRunning() && !bench.feel.isReplay())
                       bench.feel.newPlacementAt(point[*way]);
                   });
}

void addStrokes(Bench& bench) {
  bench.panels.strokes =
      &bench.window.addPanel(QStringLiteral("strokes"), PanelFeatures::tr("Strokes"), makeStrokesPanel(bench.strokes));
  QObject::connect(&bench.strokes, &StrokesController::recordRequested, &bench.features, [&bench] {
    if (!bench.study.isOpen()) return bench.study_feature->recordIntoStudy();
    bench.panels.feel->reveal();
    bench.feel_store.setRecording(true);
  });
  QObject::connect(&bench.strokes, &StrokesController::replayRequested, &bench.features,
                   [&bench](const study::RecordId& recording) {
                     bench.panels.feel->reveal();
                     bench.feel_store.replay(recording);
                   });
}

void addPictures(Bench& bench) {
  QAction* const copy = bench.window.menus().addAction(
      MenuSlot::kFilePictures, PanelFeatures::tr("&Copy picture of the plot"), Qt::CTRL | Qt::SHIFT | Qt::Key_C);
  copy->setToolTip(PanelFeatures::tr("Copy the plot with the keyboard or under the mouse"));
  copy->setEnabled(false);
  QObject::connect(copy, &QAction::triggered, &bench.window, [&window = bench.window] {
    if (PlotMenu* plot = currentPlot(window)) plot->copyPicture();
  });
  QObject::connect(&bench.models, &ModelController::opened, copy, [copy] { copy->setEnabled(true); });
}

void addSelection(Bench& bench) {
  Selection& selection = bench.selection;
  QObject* const context = &bench.features;
  QObject::connect(&selection, &Selection::rulesPointed, context,
                   [&bench] { bringForward(bench.window, *bench.panels.rule_editor); });
  QObject::connect(&selection, &Selection::termPointed, context, [&bench] {
    showTerm(bench);
    bringForward(bench.window, *bench.panels.membership_editor);
  });
  QObject::connect(&selection, &Selection::editAsked, context, [&bench, &selection] {
    bench.window.enter(Stage::kTune);
    bench.panels.rule_editor->reveal();
    selection.pointAtRules(selection.expert(), selection.rules());
    bench.panels.rule_editor->setFocus();
  });
  QObject::connect(&selection, &Selection::termEditAsked, context, [&bench] {
    bench.window.enter(Stage::kTune);
    bench.panels.membership_editor->reveal();
  });
  QObject::connect(
      &bench.findings, &FindingsController::rulePointed, context,
      [&selection](const QString& expert, std::size_t rule) { selection.pointAtRules(expert.toStdString(), {rule}); });
  QObject::connect(&bench.findings, &FindingsController::lookedAt, context, [&bench] { selectChosen(bench); });
  QObject::connect(bench.views.history, &HistoryPanel::visited, context,
                   [&bench](editing::StateId state) { showEdit(bench, state); });
}

void addScreens(Bench& bench) {
  using Place = PanelPlace;
  const BenchPanels& on = bench.panels;
  MainWindow& window = bench.window;
  window.addScreen(Stage::kUnderstand,
                   {Place::first(*on.curves), Place::below(*on.rules_here, 38, *on.curves),
                    Place::right(*on.map, 44, *on.curves), Place::behind(*on.surface, *on.map),
                    Place::behind(*on.terms_here, *on.rules_here), Place::right(*on.reading, 26, *on.rules_here)},
                   {Place::first(*on.curves), Place::below(*on.rules_here, 40, *on.curves),
                    Place::right(*on.map, 44, *on.curves), Place::behind(*on.surface, *on.map),
                    Place::behind(*on.terms_here, *on.rules_here), Place::behind(*on.reading, *on.rules_here)});
  // What is edited, what that does to the curves, and how it feels, at one glance.
  window.addScreen(
      Stage::kTune,
      {Place::first(*on.membership_editor), Place::behind(*on.rule_editor, *on.membership_editor),
       Place::behind(*on.findings, *on.membership_editor), Place::behind(*on.contracts, *on.membership_editor),
       Place::right(*on.curves, 51, *on.membership_editor), Place::below(*on.feel, 43, *on.curves),
       Place::behind(*on.strokes, *on.feel), Place::behind(*on.map, *on.feel), Place::behind(*on.surface, *on.feel),
       Place::behind(*on.rules_here, *on.feel), Place::behind(*on.reading, *on.feel),
       Place::behind(*on.history, *on.feel)},
      // Two places instead of three. Map and surface, for which the tabs have no room, are in Understand.
      {Place::first(*on.membership_editor), Place::behind(*on.rule_editor, *on.membership_editor),
       Place::behind(*on.findings, *on.membership_editor), Place::behind(*on.contracts, *on.membership_editor),
       Place::behind(*on.history, *on.membership_editor), Place::right(*on.curves, 51, *on.membership_editor),
       Place::behind(*on.feel, *on.curves), Place::behind(*on.strokes, *on.curves),
       Place::behind(*on.rules_here, *on.curves), Place::behind(*on.reading, *on.curves)});
  window.addLayout(feelLayout(), {Place::first(*on.feel)});
  window.addScreen(Stage::kDeliver, {Place::first(*on.readiness), Place::right(*on.bundle, 52, *on.readiness)});
}

}  // namespace tactus::workbench
