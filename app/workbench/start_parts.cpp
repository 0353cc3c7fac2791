#include "app/workbench/start_parts.h"

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
#include "app/workbench/collect_parts.h"
#include "app/workbench/help/guide_window.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/places.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_files.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/shell/start_view.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/study_models.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {

// What the search (Ctrl+K) finds in stage Agree: the tables and figures of the paper by their numbers, and the labs'
// pages.

class LabScreen;
class MainWindow;

/// Nothing while stage Agree cannot be entered.
QList<SearchEntry> labEntries(MainWindow& window, LabScreen& labs);

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
          {LabSearch::tr("Does a choice of the method matter?"), "method"}};
}

void show(MainWindow& window, LabScreen& labs, const char* lab, const char* page) {
  window.enter(Stage::kAgree);
  for (QWidget* const one : labs.labs()) {
    if (one->objectName() != QLatin1String(lab)) continue;
    labs.reveal(one);
    auto* const pages = one->findChild<QTabWidget*>();
    if (page == nullptr || pages == nullptr) return;
    auto* const named = *page == 0 ? pages->widget(0) : pages->findChild<QWidget*>(QLatin1String(page));
    if (named != nullptr) pages->setCurrentWidget(named);
  }
}

}  // namespace

QList<SearchEntry> labEntries(MainWindow& window, LabScreen& labs) {
  QList<SearchEntry> entries;
  if (!window.canEnter(Stage::kAgree)) return entries;
  for (const LabPlace& place : places()) {
    // "Fig. 7" is found as "figure 7" too.
    const QString kind = place.text.startsWith(LabSearch::tr("Fig."))
                             ? LabSearch::tr("Figure · %1").arg(stageName(Stage::kAgree))
                             : stageName(Stage::kAgree);
    entries << SearchEntry{place.text, kind,
                           [&window, &labs, lab = place.lab, page = place.page] { show(window, labs, lab, page); }};
  }
  return entries;
}

SearchParts::SearchParts(MainWindow& window, LabScreen& labs, const Controllers& controllers, const Places& places)
    : window_(window), on_(controllers), places_(places) {
  sources_ = {[this] { return menuEntries(*window_.menuBar()); },
              [this] { return panelEntries(window_); },
              [this, &labs] { return labEntries(window_, labs); },
              [this] { return experts(); },
              [this] { return terms(); },
              [this] { return findings(); }};
  QAction* const search = window_.menus().addAction(MenuSlot::kHelp, tr("&Search…"), Qt::CTRL | Qt::Key_K);
  connect(search, &QAction::triggered, this, &SearchParts::open);
}

void SearchParts::open() {
  CommandSearch(
      sources_, [this](const QString& typed) { return placesIn(typed); }, &window_)
      .exec();
}

QList<SearchEntry> SearchParts::placesIn(const QString& typed) const {
  if (on_.scene.model() == nullptr) return {};
  const auto place = typedPlace(typed, on_.scene.model()->model, on_.scene.values());
  if (!place) return {};
  return {SearchEntry{tr("Go to %1").arg(place->words.join(QStringLiteral(" · "))), tr("Place: why this force"),
                      [this, point = place->point] {
                        on_.scene.goTo(point);
                        window_.enter(Stage::kUnderstand);
                        places_.rules_here.reveal();
                      }}};
}

void SearchParts::reveal(Panel& panel) const {
  window_.enter(Stage::kTune);
  panel.reveal();
}

// An expert is shown with his own terms, and his rules are in the editor.
QList<SearchEntry> SearchParts::experts() const {
  QList<SearchEntry> entries;
  if (on_.scene.model() == nullptr) return entries;
  for (const fuzzy::Expert& expert : on_.scene.model()->model.experts) {
    entries << SearchEntry{labelOf(expert), tr("Expert: rules"), [this, id = expert.id] {
                             on_.rules.setExpert(id);
                             on_.terms.setExpert(id);
                             reveal(places_.rule_editor);
                           }};
  }
  return entries;
}

QList<SearchEntry> SearchParts::terms() const {
  QList<SearchEntry> entries;
  if (on_.scene.model() == nullptr) return entries;
  const auto add = [&](const fuzzy::Variable& variable) {
    for (const fuzzy::Term& term : variable.terms) {
      entries << SearchEntry{labelOf(term), tr("Term of %1").arg(labelOf(variable)), [this, id = variable.id] {
                               on_.terms.setVariable(id);
                               reveal(places_.membership_editor);
                             }};
    }
  };
  const fuzzy::ForceModel& model = on_.scene.model()->model;
  for (const fuzzy::Variable& input : model.inputs) add(input);
  add(model.output);
  return entries;
}

QList<SearchEntry> SearchParts::findings() const {
  QList<SearchEntry> entries;
  const auto shown = on_.findings.shared();
  for (std::size_t i = 0; i < shown->size(); ++i) {
    entries << SearchEntry{(*shown)[i].kind + QStringLiteral(": ") + (*shown)[i].sentence, tr("Finding"),
                           [this, i, shown] {
                             reveal(places_.findings);
                             // Another list has come meanwhile: its findings have other numbers.
                             if (on_.findings.shared() == shown) on_.findings.choose(i);
                           }};
  }
  return entries;
}

HelpParts::HelpParts(MainWindow& window, const ModelController& models, StartParts& start, const ToldPanels& panels)
    : window_(window), models_(models), start_(start), guide_(new GuideWindow(&window)), tour_(window, steps(panels)) {
  WindowMenus& menus = window_.menus();
  QAction* const guide = menus.addAction(MenuSlot::kHelp, tr("Read the &guide"), QKeySequence(Qt::Key_F1));
  QAction* const tour = menus.addAction(MenuSlot::kHelp, tr("Take the five-minute &tour"));
  connect(guide, &QAction::triggered, guide_, &GuideWindow::open);
  connect(tour, &QAction::triggered, this, &HelpParts::startTour);
  connect(&start_, &StartParts::guideRequested, guide_, &GuideWindow::open);
  connect(&start_, &StartParts::tourRequested, this, &HelpParts::startTour);
  connect(&start_, &StartParts::demoShown, this, [this] {
    if (std::exchange(tour_waits_, false)) tour_.start();
  });
  connect(&window_, &MainWindow::closing, &tour_, &Tour::end);
}

void HelpParts::startTour() {
  tour_waits_ = models_.current() == nullptr;
  if (tour_waits_) {
    start_.exploreDemo();
  } else {
    tour_.start();
  }
}

std::vector<TourStep> HelpParts::steps(const ToldPanels& panels) {
  const auto at = [this](Stage stage, Panel& panel) {
    return [this, stage, &panel]() -> QWidget* {
      window_.enter(stage);
      panel.reveal();
      return &panel;
    };
  };
  const auto strip = [this]() -> QWidget* {
    window_.enter(Stage::kUnderstand);
    return &window_.strip();
  };
  return {
      {tr("The force on the way of the tube"),
       tr("Each thin line is one nurse, the thick one is their mean. Move the mouse over the curves to read them; turn "
          "the wheel to come closer. A gap is a place for which no nurse gave a rule."),
       at(Stage::kUnderstand, panels.curves)},
      {tr("One place for everything"),
       tr("Lubrication, neck, depth and speed: this is the situation that all panels speak of. Type a number, or click "
          "into the curves."),
       strip},
      {tr("Why this force"),
       tr("The rules that speak at this place, the strongest first, and what each of them pulls the force to."),
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
       tr("Press Start (F9), hold Space and move the mouse over the pad: the tube resists as the model says. No device "
          "is needed. F12 or Esc takes the force away; F10 makes this the whole window."),
       at(Stage::kTune, panels.feel)},
      {tr("Hand it to a simulator"),
       tr("What is missing before the model can be delivered, and the bundle for the people who build the simulator. "
          "The guide (F1) tells the rest."),
       at(Stage::kDeliver, panels.readiness)}};
}

StartParts::StartParts(MainWindow& window, ModelFiles& files, CollectParts& collect, ModelController& models,
                       const RecentFiles& recent, Panel& rule_editor, const StudyConnection& study,
                       StudyModels& study_models)
    : window_(window),
      files_(files),
      collect_(collect),
      models_(models),
      rule_editor_(rule_editor),
      study_(study),
      study_models_(study_models),
      demo_(documentsFolder()),
      view_(new StartView(recent, demo_)) {
  window_.setStartScreen(view_);
  connectAll();
}

void StartParts::connectAll() {
  connect(view_, &StartView::demoRequested, this, &StartParts::exploreDemo);
  connect(view_, &StartView::freshDemoRequested, &demo_, &DemoMaker::makeFresh);
  connect(view_, &StartView::tourRequested, this, &StartParts::tourRequested);
  connect(view_, &StartView::guideRequested, this, &StartParts::guideRequested);
  connect(view_, &StartView::newStudyRequested, &collect_, &CollectParts::makeStudy);
  connect(view_, &StartView::newModelRequested, this, &StartParts::makeModel);
  connect(view_, &StartView::tablesRequested, this, &StartParts::chooseTables);
  connect(view_, &StartView::importRequested, &files_, &ModelFiles::chooseImport);
  connect(view_, &StartView::openRequested, &files_, &ModelFiles::choose);
  connect(view_, &StartView::recentRequested, &files_, &ModelFiles::open);
  connect(&demo_, &DemoMaker::ready, this, &StartParts::onDemoReady);
  connect(&study_, &StudyConnection::opened, this, &StartParts::onStudyOpened);
  connect(&models_, &ModelController::opened, this, &StartParts::onModelOpened);
  connect(&demo_, &DemoMaker::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(sentence, {tr("Choose another folder…"), [this] { chooseDemoFolder(); }});
  });
  connect(&tables_, &TableImport::failed, this, [this](const QString& sentence) {
    window_.banner().showRemedy(tr("The tables were not imported. %1").arg(sentence),
                                {tr("Choose another folder…"), [this] { chooseTables(); }});
  });
  connect(&tables_, &TableImport::doubted, this,
          [this](const QString& folder, const QString& path, const QString& sentence) {
            window_.banner().showRemedy(tr("The tables were not imported. %1").arg(sentence),
                                        {tr("Import as they are"), [=, this] { tables_.run(folder, path, true); }});
          });
  connect(&tables_, &TableImport::imported, this, [this](const QString& path, const QString& notes) {
    files_.open(path);
    window_.banner().showNote(notes);
  });
}

void StartParts::exploreDemo() { demo_.explore(); }

void StartParts::chooseDemoFolder() {
  const QString folder =
      file_dialog::getExistingDirectory(&window_, tr("Folder for the demo study"), documentsFolder());
  if (folder.isEmpty()) return;
  demo_.setDocuments(folder);
  demo_.explore();
}

void StartParts::onDemoReady(const QString& study) {
  demo_study_ = study;
  files_.open(study);
}

// What is explored is the model: a fresh copy of the demo has only the answers yet.
void StartParts::onStudyOpened() {
  const bool asked = !demo_study_.isEmpty() && QFileInfo(study_.path()) == QFileInfo(demo_study_);
  if (asked && !study_models_.hasModel()) study_models_.buildModel();
}

// The study opens with its people first; what is to be explored is the model.
void StartParts::onModelOpened() {
  if (demo_study_.isEmpty() || QFileInfo(models_.current()->path) != QFileInfo(demo_study_)) return;
  demo_study_.clear();
  window_.enter(Stage::kUnderstand);
  emit demoShown();
}

void StartParts::makeModel() {
  if (!files_.makeFromTemplate()) return;
  window_.enter(Stage::kTune);
  rule_editor_.reveal();
  window_.banner().showNote(tr("A new model without rules: answer what force the experts feel in each situation."));
}

void StartParts::chooseTables() {
  const QString folder = file_dialog::getExistingDirectory(&window_, tr("Folder with the tables"), documentsFolder());
  if (folder.isEmpty()) return;
  const QString proposal = folder + QLatin1Char('/') + QDir(folder).dirName() + QStringLiteral(".tactus");
  QString path = file_dialog::getSaveFileName(&window_, tr("Make a study of the tables"), proposal,
                                              tr("Studies (*.tactus)"), nullptr, QFileDialog::DontConfirmOverwrite);
  if (path.isEmpty()) return;
  if (!isStudyPath(path)) path += QStringLiteral(".tactus");
  tables_.run(folder, path, false);
}

}  // namespace tactus::workbench
