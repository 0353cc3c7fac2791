#include "app/workbench/workbench.h"

#include <QAction>
#include <QMenuBar>
#include <algorithm>
#include <utility>

#include "app/editing/changed_parts.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/edit_parts.h"
#include "app/workbench/feel_parts.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/study/study_notice_strip.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/findings/findings_panel.h"
#include "app/workbench/tune/history/autosave_controller.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/history/recovery_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/understand/here/variable_row.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_panel.h"

namespace tactus::workbench {

SelectionParts::SelectionParts(MainWindow& window, Selection& selection, TermController& terms,
                               FindingsController& findings, EditController& edits, HistoryParts& history,
                               Panel& rule_editor, EditParts& edit_parts)
    : window_(window), selection_(selection), terms_(terms), edits_(edits) {
  connect(&selection_, &Selection::rulesPointed, this, [this, &rule_editor] { bringForward(rule_editor); });
  connect(&selection_, &Selection::termPointed, this, [this, &edit_parts] {
    showTerm();
    bringForward(edit_parts.panel());
  });
  connect(&selection_, &Selection::editAsked, this, [this, &rule_editor] {
    window_.enter(Stage::kTune);
    rule_editor.reveal();
    selection_.pointAtRules(selection_.expert(), selection_.rules());
    rule_editor.setFocus();
  });
  connect(&findings, &FindingsController::rulePointed, this,
          [this](const QString& expert, std::size_t rule) { selection_.pointAtRules(expert.toStdString(), {rule}); });
  connect(&findings, &FindingsController::lookedAt, this, [this, &findings] { selectChosen(findings); });
  connect(&history.view(), &HistoryPanel::visited, this, &SelectionParts::showEdit);
}

// While the model is understood, the editors are elsewhere and stay there until the user asks for them.
void SelectionParts::bringForward(Panel& editor) {
  if (window_.stage() == Stage::kTune) editor.reveal();
}

void SelectionParts::showTerm() {
  const editing::TermPlace& place = *selection_.term();
  terms_.setExpert(place.list.expert);
  terms_.setVariable(place.list.variable);
  const auto& terms = terms_.terms();
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const fuzzy::Term& term) { return term.id == place.term; });
  if (found == terms.end()) return;
  terms_.select(Grip{static_cast<std::size_t>(found - terms.begin()), Grip::Part::kTerm});
}

// Silently: the findings stay in front while the user goes through them.
void SelectionParts::selectChosen(const FindingsController& findings) {
  if (!findings.chosen() || !findings.isCurrent()) return;
  const auto& rules = findings.findings()[*findings.chosen()].rules;
  std::vector<std::size_t> of_first;
  for (const RuleOfExpert& one : rules) {
    if (one.expert == rules.front().expert) of_first.push_back(one.rule);
  }
  if (of_first.empty()) return;
  selection_.setExpert(rules.front().expert);
  selection_.selectRules(std::move(of_first));
}

void SelectionParts::showEdit(editing::StateId state) {
  const auto before_it = edits_.history().states()[state].parent;
  if (!before_it) return;
  const auto before = edits_.readyOf(*before_it);
  const auto after = edits_.readyOf(state);
  if (!before || !after) return;
  const editing::ChangedParts parts = editing::changedParts((*before)->model, (*after)->model);
  if (!parts.rules.empty()) {
    selection_.pointAtRules(parts.expert, parts.rules);
  } else if (parts.term) {
    selection_.pointAtTerm(*parts.term);
  }
}

NoteParts::NoteParts(MainWindow& window, StudyConnection& study, StudyModels& study_models, MembershipEditor& editor)
    : window_(window),
      study_(study),
      study_models_(study_models),
      editor_(editor),
      strip_(new StudyNoticeStrip(study, &window)) {
  window_.addStrip(strip_);
  WindowMenus& menus = window_.menus();
  notices_ = menus.addAction(MenuSlot::kStudyNotes, tr("Show what &happened to the study"));
  data_ = menus.addAction(MenuSlot::kStudyNotes, tr("&Look at the data first"));
  build_ = menus.addAction(MenuSlot::kStudyNotes, tr("Show the n&otes of the build"));
  connect(notices_, &QAction::triggered, this, [this] {
    strip_->showAll();
    if (!study_.notices().before.isEmpty()) popUp(noticeGroups(study_.notices()));
  });
  connect(data_, &QAction::triggered, this, [this] { popUp({dataGroup(study_models_.notes())}); });
  connect(build_, &QAction::triggered, this, [this] { popUp({buildGroup(study_models_.notes())}); });
  connect(&study_models_, &StudyModels::notesChanged, this, &NoteParts::showNotes);
  connect(&study_, &StudyConnection::noticesChanged, this, &NoteParts::showNotices);
  // The notes of the build are of the study's model alone.
  connect(&study_models_, &StudyModels::savedChanged, this, &NoteParts::showNotes);
  showNotes();
  showNotices();
}

void NoteParts::showNotes() {
  BuildNotes notes = study_models_.notes();
  data_->setEnabled(!notes.data.empty());
  build_->setEnabled(!notes.build.empty());
  if (!study_models_.keepsModel()) notes.build.clear();
  window_.header().showNotes(notes);
  // What is odd in the data of the study says nothing of terms that are of another model.
  editor_.setNotes(study_models_.keepsModel() ? std::move(notes) : BuildNotes());
}

void NoteParts::showNotices() {
  const StudyNotices& notices = study_.notices();
  notices_->setEnabled(!notices.now.empty() || !notices.before.isEmpty());
  window_.header().showNotices(notices);
}

void NoteParts::popUp(const QVector<NoteGroup>& groups) {
  const QMenuBar* bar = window_.menuBar();
  showNotesPopup(window_, bar->mapToGlobal(QPoint(theme::kGrid, bar->height() + 4)), groups);
}

RecoveryParts::RecoveryParts(MainWindow& window, ModelFiles& files, AutosaveController& autosave,
                             RecoveryController& recovery, EditController& edits, StudyConnection& study)
    : window_(window), files_(files), autosave_(autosave), recovery_(recovery) {
  auto* strip = new RecoveryStrip(recovery);
  window.addStrip(strip);
  connect(strip, &RecoveryStrip::restoreRequested, this, [this] {
    if (files_.mayLoseChanges()) recovery_.restore();
  });
  connectRecovery(edits, study);
  connectAutosave();
}

void RecoveryParts::connectRecovery(EditController& edits, StudyConnection& study) {
  connect(&recovery_, &RecoveryController::studyNeeded, &study, &StudyConnection::open);
  connect(&recovery_, &RecoveryController::restored, &edits, &EditController::reported);
  connect(&recovery_, &RecoveryController::notRestored, this, [this](const QString& sentence, const LostWork& work) {
    window_.banner().showRemedy(sentence, {tr("Try again"), [this, work] {
                                             if (files_.mayLoseChanges()) recovery_.restoreWork(work);
                                           }});
  });
  connect(&recovery_, &RecoveryController::notDiscarded, this, [this](const QString& sentence, const LostWork& work) {
    window_.banner().showRemedy(sentence, {tr("Try again"), [this, work] { recovery_.discardWork(work); }});
  });
}

void RecoveryParts::connectAutosave() {
  connect(&autosave_, &AutosaveController::said, &window_.banner(), &MessageBanner::showNote);
  connect(&autosave_, &AutosaveController::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(sentence, {tr("Save the model"), [this] { files_.save(); }}, &autosave_);
  });
  connect(&autosave_, &AutosaveController::worksAgain, this, [this] { window_.banner().takeBack(autosave_); });
  const auto open = [this](const QString& path) { return [this, path] { files_.open(path); }; };
  connect(&autosave_, &AutosaveController::notRead, this,
          [this, open](const QString& sentence, const QString& document) {
            window_.banner().showRemedy(sentence, {tr("Open the model again"), open(document)});
          });
  connect(&autosave_, &AutosaveController::setAside, this, [this, open](const QString& sentence, const QString& aside) {
    window_.banner().showRemedy(sentence, {tr("Open the earlier history"), open(aside)});
  });
}

BenchScreens::BenchScreens(MainWindow& window, const BenchPanels& panels) {
  using Place = PanelPlace;
  window.addScreen(
      Stage::kUnderstand,
      {Place::first(panels.curves), Place::below(panels.rules_here, 38, panels.curves),
       Place::right(panels.map, 44, panels.curves), Place::behind(panels.surface, panels.map),
       Place::behind(panels.terms_here, panels.rules_here), Place::right(panels.reading, 26, panels.rules_here)},
      {Place::first(panels.curves), Place::below(panels.rules_here, 40, panels.curves),
       Place::right(panels.map, 44, panels.curves), Place::behind(panels.surface, panels.map),
       Place::behind(panels.terms_here, panels.rules_here), Place::behind(panels.reading, panels.rules_here)});
  // What is edited, what that does to the curves, and how it feels, at one glance.
  window.addScreen(Stage::kTune,
                   {Place::first(panels.membership_editor), Place::behind(panels.rule_editor, panels.membership_editor),
                    Place::behind(panels.findings, panels.membership_editor),
                    Place::right(panels.curves, 51, panels.membership_editor),
                    Place::below(panels.feel, 43, panels.curves), Place::behind(panels.map, panels.feel),
                    Place::behind(panels.surface, panels.feel), Place::behind(panels.rules_here, panels.feel),
                    Place::behind(panels.reading, panels.feel), Place::behind(panels.history, panels.feel)},
                   // Two places instead of three. The surface, for which the tabs have no room, is in Understand.
                   {Place::first(panels.membership_editor), Place::behind(panels.rule_editor, panels.membership_editor),
                    Place::behind(panels.findings, panels.membership_editor),
                    Place::behind(panels.history, panels.membership_editor),
                    Place::right(panels.curves, 51, panels.membership_editor),
                    Place::behind(panels.feel, panels.curves), Place::behind(panels.map, panels.curves),
                    Place::behind(panels.rules_here, panels.curves), Place::behind(panels.reading, panels.curves)});
  window.addLayout(FeelParts::layoutId(), {Place::first(panels.feel)});
  window.addScreen(Stage::kDeliver,
                   {Place::first(panels.readiness), Place::right(panels.bundle, 52, panels.readiness)});
}

MapParts::MapParts(MainWindow& window, const ModelController& models, SceneController& scene) {
  auto* forces = new ForceMapController(scene, this);
  view_ = new MapPanel(scene, *forces);
  map_ = &window.addPanel(QStringLiteral("map"), tr("Map"), view_);
  surface_ = &window.addPanel(QStringLiteral("surface"), tr("Surface"), new SurfacePanel(scene, *forces));

  QAction* const picture = window.menus().addAction(MenuSlot::kFilePictures, tr("Save picture of the &map…"),
                                                    Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  picture->setEnabled(false);
  connect(picture, &QAction::triggered, &view_->plotMenu(), &PlotMenu::choosePicture);
  connect(&models, &ModelController::opened, picture,
          [picture, &models] { picture->setEnabled(models.current()->model.inputs.size() > 1); });
}

FindingParts::FindingParts(MainWindow& window, FindingsController& findings, TermController& terms,
                           RuleController& rules)
    : panel_(window.addPanel(QStringLiteral("findings"), tr("Findings"), new FindingsPanel(findings))) {
  // The tab says what the last edit added, also while another panel lies on top.
  QObject::connect(&findings, &FindingsController::changed, &panel_, [panel = &panel_, &findings] {
    const QString title = findings.added() == 0 ? tr("Findings") : tr("Findings (+%1)").arg(findings.added());
    if (findings.isCurrent() && title != panel->windowTitle()) panel->setWindowTitle(title);
  });
  // The editors behind the findings then stand at what the finding is about.
  QObject::connect(&findings, &FindingsController::lookedAt, &terms,
                   [&terms, &rules](const QString& expert, const QString& input) {
                     if (!terms.isOpen()) return;
                     if (!expert.isEmpty()) rules.setExpert(expert.toStdString());
                     terms.setExpert(expert.toStdString());
                     if (!input.isEmpty()) terms.setVariable(input.toStdString());
                   });
}

RuleParts::RuleParts(MainWindow& window, RuleController& rules)
    : editor_(new RuleEditor(rules)), panel_(window.addPanel(QStringLiteral("rule_editor"), tr("Rules"), editor_)) {
  panel_.setFocusProxy(editor_);
}

PictureParts::PictureParts(MainWindow& window, const ModelController& models) {
  QAction* const copy = window.menus().addAction(MenuSlot::kFilePictures, tr("&Copy picture of the plot"),
                                                 Qt::CTRL | Qt::SHIFT | Qt::Key_C);
  copy->setToolTip(tr("Copy the plot with the keyboard or under the mouse"));
  copy->setEnabled(false);
  QObject::connect(copy, &QAction::triggered, &window, [&window] {
    if (PlotMenu* plot = currentPlot(window)) plot->copyPicture();
  });
  QObject::connect(&models, &ModelController::opened, copy, [copy] { copy->setEnabled(true); });
}

HereParts::HereParts(MainWindow& window, SceneController& scene, Selection& selection)
    : terms_(window.addPanel(QStringLiteral("terms"), tr("Membership functions"), new VariableRow(scene))),
      rules_(window.addPanel(QStringLiteral("rules"), tr("Rules here"), new RulePanel(scene, selection))) {}

Workbench::Workbench(QSettings& settings, const QString& autosave_root, DeviceAccess devices)
    : scene(models),
      device(std::move(devices)),
      feel(scene, device),
      link(models),
      edits(models),
      compare(models, edits,
              [this] {
                return scene.model() == nullptr ? CurveSetting() : CurveSetting{scene.xInput(), scene.values()};
              }),
      author(settings, edits),
      autosave(models, edits, autosave_root),
      recovery(models, edits, autosave, autosave_root),
      selection(edits),
      terms(edits),
      rules(edits, scene, selection),
      ghost(edits, scene),
      references(scene),
      findings(edits, scene),
      bundles(edits),
      readiness(models, edits, bundles),
      study_models(study, models, edits),
      feel_store(feel, scene, study, [this] { return study_models.modelVersion(); }),
      recent(settings),
      window(models, scene, settings),
      files(window, models, recent),
      here_parts(window, scene, selection),
      curve_parts(window, models, scene, edits, ghost, references, settings),
      map_parts(window, models, scene),
      feel_parts(window, models, scene, feel),
      link_parts(window, models, scene, feel, link),
      rule_parts(window, rules),
      edit_parts(window, edits, terms, scene, ghost),
      finding_parts(window, findings, terms, rules),
      study_parts(window, files, study, study_models, feel, feel_parts.view(), feel_store, models, recent),
      collect_parts(window, study_parts, study, study_models, device, author),
      start_parts(window, files, collect_parts, models, recent, rule_parts.panel(), study, study_models),
      lab_parts(window, files, study, study_models, models, collect_parts.run(), author),
      origin_parts(window, lab_parts, {models, scene, terms, rules, study, study_models}, edit_parts.editor(),
                   curve_parts.view()),
      report_parts(window, study, lab_parts.data()),
      note_parts(window, study, study_models, edit_parts.editor()),
      history_parts(window, edits, compare, scene, feel, author, ghost),
      selection_parts(window, selection, terms, findings, edits, history_parts, rule_parts.panel(), edit_parts),
      deliver_parts(window, models, findings, finding_parts.panel(), history_parts, bundles, readiness, study_models,
                    link, link_parts, settings),
      recovery_parts(window, files, autosave, recovery, edits, study),
      picture_parts(window, models),
      screens(window,
              {here_parts.terms(), here_parts.rules(), curve_parts.curves(), curve_parts.reading(), map_parts.map(),
               map_parts.surface(), feel_parts.panel(), edit_parts.panel(), rule_parts.panel(), finding_parts.panel(),
               history_parts.panel(), deliver_parts.readinessPanel(), deliver_parts.bundlePanel()}),
      view_menu(window, models, settings),
      help_parts(window, models, start_parts,
                 {curve_parts.curves(), map_parts.map(), here_parts.rules(), edit_parts.panel(), finding_parts.panel(),
                  feel_parts.panel(), deliver_parts.readinessPanel()}),
      search_parts(window, lab_parts.screen(), {scene, terms, rules, findings},
                   {edit_parts.panel(), rule_parts.panel(), finding_parts.panel(), here_parts.rules()}),
      help_menu(window) {}

Workbench::~Workbench() { window.hide(); }

}  // namespace tactus::workbench
