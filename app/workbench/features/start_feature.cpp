#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMenuBar>
#include <QTabWidget>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/documents.h"
#include "app/workbench/base/file_dialog.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/features/bench.h"
#include "app/workbench/features/features.h"
#include "app/workbench/help/guide_window.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/model/places.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/start_view.h"

namespace tactus::workbench {

// What the search (Ctrl+K) finds in stage Build: the tables and figures of the paper by their numbers, and the labs'
// pages.

namespace {

struct LabSearch {
  Q_DECLARE_TR_FUNCTIONS(LabSearch)
};

/// By the names of the widgets.
struct LabPlace {
  QString text;
  const char* lab;
  const char* page = nullptr;  ///< empty: the first one; null: the lab has one page, or any will do
};

bool isFigure(const QString& text) { return text.startsWith(LabSearch::tr("Fig.")); }
bool isOfPaper(const QString& text) { return isFigure(text) || text.startsWith(LabSearch::tr("Table")); }

QList<LabPlace> places() {
  return {{LabSearch::tr("Table 1: insertion speed of each participant"), "speed", "table"},
          {LabSearch::tr("Table 2: votes for each force"), "force"},
          {LabSearch::tr("Table 3: answers to the usability scale"), "rules", "usability"},
          {LabSearch::tr("Fig. 3d: terms of the speed"), "speed", ""},
          {LabSearch::tr("Fig. 3e: words of the force"), "force"},
          {LabSearch::tr("Fig. 4: way of the tube on an image"), "depth"},
          {LabSearch::tr("Fig. 6: recordings of the strokes"), "speed", "strokes"},
          {LabSearch::tr("Fig. 7: clusters of each participant"), "speed", ""},
          {LabSearch::tr("Fig. 8: speed terms of each participant, and their average"), "speed", ""},
          {LabSearch::tr("Insertion length of a person"), "depth", "length"},
          {LabSearch::tr("Judgements of the forces"), "force", "judgements"},
          {LabSearch::tr("Rules of all experts, and the conflict map"), "rules", "cell"},
          {LabSearch::tr("Findings about the experts' rules"), "rules", "findings"},
          {LabSearch::tr("Agreement of the experts (Krippendorff, Kendall, Fleiss)"), "rules", "agreement"},
          {LabSearch::tr("Weights, and leaving one expert out"), "experts", "policies"},
          {LabSearch::tr("Does a choice of the method matter?"), "method"},
          {LabSearch::tr("How many nurses and questions a study takes"), "plan"}};
}

}  // namespace

void SearchFeature::showLab(const char* lab, const char* page) const {
  bench_.window.enter(Stage::kBuild);
  LabScreen& labs = *bench_.views.labs;
  for (QWidget* const one : labs.labs()) {
    if (one->objectName() != QLatin1String(lab)) continue;
    labs.reveal(one);
    auto* const pages = one->findChild<QTabWidget*>();
    if (page == nullptr || pages == nullptr) return;
    auto* const named = *page == 0 ? pages->widget(0) : pages->findChild<QWidget*>(QLatin1String(page));
    if (named != nullptr) pages->setCurrentWidget(named);
  }
}

// None while stage Build cannot be entered.
QList<SearchEntry> SearchFeature::labs() const {
  QList<SearchEntry> entries;
  if (!bench_.window.canEnter(Stage::kBuild)) return entries;
  // Figures and tables of the paper are of its procedure.
  const bool of_paper = bench_.study.procedure()->id == procedure::defaultProcedure()->id;
  for (const LabPlace& place : places()) {
    if (!of_paper && (isOfPaper(place.text) || place.lab == std::string_view("depth"))) continue;
    // "Fig. 7" is found as "figure 7" too.
    const QString kind =
        isFigure(place.text) ? LabSearch::tr("Figure · %1").arg(stageName(Stage::kBuild)) : stageName(Stage::kBuild);
    entries << SearchEntry{place.text, kind, [this, lab = place.lab, page = place.page] { showLab(lab, page); }};
  }
  return entries;
}

SearchFeature::SearchFeature(Bench& bench) : QObject(&bench.features), bench_(bench) {
  sources_ = {[this] { return menuEntries(*bench_.window.menuBar()); },
              [this] { return panelEntries(bench_.window); },
              [this] { return labs(); },
              [this] { return experts(); },
              [this] { return terms(); },
              [this] { return findings(); }};
  QAction* const search = bench_.window.menus().addAction(MenuSlot::kHelp, tr("&Search…"), Qt::CTRL | Qt::Key_K);
  connect(search, &QAction::triggered, this, &SearchFeature::open);
}

void SearchFeature::open() {
  CommandSearch(
      sources_, [this](const QString& typed) { return placesIn(typed); }, &bench_.window)
      .exec();
}

QList<SearchEntry> SearchFeature::placesIn(const QString& typed) const {
  if (bench_.scene.model() == nullptr) return {};
  const auto place = typedPlace(typed, bench_.scene.model()->model, bench_.scene.values());
  if (!place) return {};
  return {SearchEntry{tr("Go to %1").arg(place->words.join(QStringLiteral(" · "))), tr("Place: why this force"),
                      [this, point = place->point] {
                        bench_.scene.goTo(point);
                        bench_.window.enter(Stage::kUnderstand);
                        bench_.panels.rules_here->reveal();
                      }}};
}

void SearchFeature::reveal(Panel& panel) const {
  bench_.window.enter(Stage::kTune);
  panel.reveal();
}

// An expert is shown with his own terms, and his rules are in the editor.
QList<SearchEntry> SearchFeature::experts() const {
  QList<SearchEntry> entries;
  if (bench_.scene.model() == nullptr) return entries;
  for (const fuzzy::Expert& expert : bench_.scene.model()->model.experts) {
    entries << SearchEntry{labelOf(expert), tr("Expert: rules"), [this, id = expert.id] {
                             bench_.rules.setExpert(id);
                             bench_.terms.setExpert(id);
                             reveal(*bench_.panels.rule_editor);
                           }};
  }
  return entries;
}

QList<SearchEntry> SearchFeature::terms() const {
  QList<SearchEntry> entries;
  if (bench_.scene.model() == nullptr) return entries;
  const auto add = [&](const fuzzy::Variable& variable) {
    for (const fuzzy::Term& term : variable.terms) {
      entries << SearchEntry{labelOf(term), tr("Term of %1").arg(labelOf(variable)), [this, id = variable.id] {
                               bench_.terms.setVariable(id);
                               reveal(*bench_.panels.membership_editor);
                             }};
    }
  };
  const fuzzy::ForceModel& model = bench_.scene.model()->model;
  for (const fuzzy::Variable& input : model.inputs) add(input);
  add(model.output);
  return entries;
}

QList<SearchEntry> SearchFeature::findings() const {
  QList<SearchEntry> entries;
  const auto shown = bench_.findings.shared();
  for (std::size_t i = 0; i < shown->size(); ++i) {
    entries << SearchEntry{(*shown)[i].kind + QStringLiteral(": ") + (*shown)[i].sentence, tr("Finding"),
                           [this, i, shown] {
                             reveal(*bench_.panels.findings);
                             // Another list has come meanwhile: its findings have other numbers.
                             if (bench_.findings.shared() == shown) bench_.findings.choose(i);
                           }};
  }
  return entries;
}

HelpFeature::HelpFeature(Bench& bench)
    : QObject(&bench.features), bench_(bench), guide_(new GuideWindow(&bench.window)), tour_(bench.window, steps()) {
  WindowMenus& menus = bench_.window.menus();
  QAction* const guide = menus.addAction(MenuSlot::kHelp, tr("Read the &guide"), QKeySequence(Qt::Key_F1));
  QAction* const tour = menus.addAction(MenuSlot::kHelp, tr("Take the five-minute &tour"));
  connect(guide, &QAction::triggered, guide_, &GuideWindow::open);
  connect(tour, &QAction::triggered, this, &HelpFeature::startTour);
  connect(bench_.views.start, &StartView::guideRequested, guide_, &GuideWindow::open);
  connect(bench_.views.start, &StartView::tourRequested, this, &HelpFeature::startTour);
  connect(bench_.start, &StartFeature::demoShown, this, [this] {
    if (std::exchange(tour_waits_, false)) tour_.start();
  });
  connect(&bench_.window, &MainWindow::closing, &tour_, &Tour::end);
}

void HelpFeature::startTour() {
  tour_waits_ = bench_.models.current() == nullptr;
  if (tour_waits_) {
    bench_.demo.explore();
  } else {
    tour_.start();
  }
}

std::vector<TourStep> HelpFeature::steps() {
  const BenchPanels& panels = bench_.panels;
  const auto at = [this](Stage stage, Panel* panel) {
    return [this, stage, panel]() -> QWidget* {
      bench_.window.enter(stage);
      panel->reveal();
      return panel;
    };
  };
  const auto strip = [this]() -> QWidget* {
    bench_.window.enter(Stage::kUnderstand);
    return &bench_.window.strip();
  };
  // Of a model without a study there are no people to show.
  const auto of_study = [this](Stage stage, QWidget* screen) {
    return [this, stage, screen]() -> QWidget* {
      if (!bench_.window.canEnter(stage)) return &bench_.window.strip();
      bench_.window.enter(stage);
      return screen;
    };
  };
  return {
      {tr("Who was asked"),
       tr("Each row is a nurse, each column a step of a session. Try a double click on a row: it shows everything that "
          "she said."),
       of_study(Stage::kCollect, bench_.views.collect)},
      {tr("From answers to a model"),
       tr("Strokes become words for the speed, judgements words for the force, answers rules. Move a slider in the tab "
          "Speed: the line below the tabs says what it does to the force, and Ctrl+Z takes it back."),
       of_study(Stage::kBuild, bench_.views.labs)},
      {tr("The force on the way of the tool"),
       tr("Each thin line is one nurse, the thick one is their mean. Click into the curves to go to a place; turn the "
          "wheel to come closer. A gap is a place for which no nurse gave a rule."),
       at(Stage::kUnderstand, panels.curves)},
      {tr("One place for everything"),
       tr("One value of each input: this is the situation that all panels speak of. Type a number, or click into the "
          "curves."),
       strip},
      {tr("Why this force"),
       tr("A sentence says why; below it stands what each word pulls, what the force would be without each nurse, and "
          "the "
          "smallest moves that a hand would feel. Click a word: its rules open."),
       at(Stage::kUnderstand, panels.rules_here)},
      {tr("The whole picture"),
       tr("The force for every depth and speed at once. Sharp edges are places where one word ends and the next "
          "begins."),
       at(Stage::kUnderstand, panels.map)},
      {tr("Change what a word means"),
       tr("Drag a corner: the curves follow while you drag. Ctrl+Z takes everything back, and the history keeps every "
          "state."),
       at(Stage::kTune, panels.membership_editor)},
      {tr("What to look at first"),
       tr("Holes, contradictions and jumps of the force, largest first. Where a repair is plain, one click does it."),
       at(Stage::kTune, panels.findings)},
      {tr("Feel it"),
       tr("Press Start (F9), hold Space and move the mouse over the pad: the tool resists as the model says. No device "
          "is needed. F12 or Esc takes the force away; F10 makes this the whole window."),
       at(Stage::kTune, panels.feel)},
      {tr("Hand it to a simulator"),
       tr("What is missing before the model can be delivered, and the bundle for the people who build the simulator. "
          "The guide (F1) tells the rest."),
       at(Stage::kDeliver, panels.readiness)}};
}

StartFeature::StartFeature(Bench& bench) : QObject(&bench.features), bench_(bench) {
  bench_.views.start = new StartView(bench_.recent, bench_.demo);
  bench_.window.setStartScreen(bench_.views.start);
  connectAll();
  addMenu();
}

// What the start page offers, also while something is open.
void StartFeature::addMenu() {
  WindowMenus& menus = bench_.window.menus();
  connect(menus.addAction(MenuSlot::kFileOpen, tr("&Go to the start page")), &QAction::triggered, &bench_.window,
          &MainWindow::showStart);
  connect(menus.addAction(MenuSlot::kFileOpen, tr("New mo&del…")), &QAction::triggered, this, &StartFeature::makeModel);
  connect(menus.addAction(MenuSlot::kFileOpen, tr("Import ta&bles…")), &QAction::triggered, this,
          &StartFeature::chooseTables);
  connect(menus.addAction(MenuSlot::kFileOpen, tr("&Import a model…")), &QAction::triggered, &bench_.files,
          &ModelFiles::chooseImport);
}

void StartFeature::connectAll() {
  const StartView* const view = bench_.views.start;
  connect(view, &StartView::demoRequested, &bench_.demo, &DemoMaker::explore);
  connect(view, &StartView::freshDemoRequested, &bench_.demo, &DemoMaker::makeFresh);
  connect(view, &StartView::newStudyRequested, bench_.study_feature, &StudyFeature::chooseNew);
  connect(view, &StartView::newModelRequested, this, &StartFeature::makeModel);
  connect(view, &StartView::tablesRequested, this, &StartFeature::chooseTables);
  connect(view, &StartView::importRequested, &bench_.files, &ModelFiles::chooseImport);
  connect(view, &StartView::openRequested, &bench_.files, &ModelFiles::choose);
  connect(view, &StartView::recentRequested, &bench_.files, &ModelFiles::open);
  connect(&bench_.demo, &DemoMaker::ready, this, &StartFeature::onDemoReady);
  connect(&bench_.study, &StudyConnection::opened, this, &StartFeature::onStudyOpened);
  connect(&bench_.models, &ModelController::opened, this, &StartFeature::onModelOpened);
  connect(&bench_.demo, &DemoMaker::failed, this, [this](const QString& sentence) {
    bench_.window.banner().showRemedy(sentence, {tr("Choose another folder…"), [this] { chooseDemoFolder(); }});
  });
  connect(&bench_.tables, &TableImport::failed, this, [this](const QString& sentence) {
    bench_.window.banner().showRemedy(tr("The tables were not imported. %1").arg(sentence),
                                      {tr("Choose another folder…"), [this] { chooseTables(); }});
  });
  connect(&bench_.tables, &TableImport::doubted, this,
          [this](const QString& folder, const QString& path, const QString& sentence) {
            bench_.window.banner().showRemedy(
                tr("The tables were not imported. %1").arg(sentence),
                {tr("Import as they are"), [=, this] { bench_.tables.run(folder, path, true); }});
          });
  connect(&bench_.tables, &TableImport::imported, this, [this](const QString& path, const QString& notes) {
    bench_.files.open(path);
    bench_.window.banner().showNote(notes);
  });
}

void StartFeature::chooseDemoFolder() {
  const QString folder =
      file_dialog::getExistingDirectory(&bench_.window, tr("Folder for the demo study"), documentsFolder());
  if (folder.isEmpty()) return;
  bench_.demo.setDocuments(folder);
  bench_.demo.explore();
}

void StartFeature::onDemoReady(const QString& study) {
  demo_study_ = study;
  bench_.files.open(study);
}

// What is explored is the model: a fresh copy of the demo has only the answers yet.
void StartFeature::onStudyOpened() {
  const bool asked = !demo_study_.isEmpty() && QFileInfo(bench_.study.path()) == QFileInfo(demo_study_);
  if (asked && !bench_.study_models.hasModel()) bench_.study_models.buildModel();
}

// The study opens with its people first; what is to be explored is the model.
void StartFeature::onModelOpened() {
  if (demo_study_.isEmpty() || QFileInfo(bench_.models.current()->path) != QFileInfo(demo_study_)) return;
  demo_study_.clear();
  bench_.window.enter(Stage::kUnderstand);
  emit demoShown();
}

void StartFeature::makeModel() {
  if (!bench_.files.makeFromTemplate()) return;
  bench_.window.enter(Stage::kTune);
  bench_.panels.rule_editor->reveal();
  bench_.window.banner().showNote(
      tr("A new model without rules: answer what force the experts feel in each situation."));
}

void StartFeature::chooseTables() {
  const QString folder =
      file_dialog::getExistingDirectory(&bench_.window, tr("Folder with the tables"), documentsFolder());
  if (folder.isEmpty()) return;
  const QString proposal = folder + QLatin1Char('/') + QDir(folder).dirName() + QStringLiteral(".tactus");
  QString path = file_dialog::getSaveFileName(&bench_.window, tr("Make a study of the tables"), proposal,
                                              tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  bench_.tables.run(folder, path, false);
}

void addStart(Bench& bench) { bench.start = new StartFeature(bench); }

void addHelp(Bench& bench) { bench.help = new HelpFeature(bench); }

void addSearch(Bench& bench) { bench.search = new SearchFeature(bench); }

}  // namespace tactus::workbench
