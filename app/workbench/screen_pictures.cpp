#include "app/workbench/screen_pictures.h"

#include <QComboBox>
#include <QDialog>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QSize>
#include <QString>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <vector>

#include "app/editing/rule_edits.h"
#include "app/session/simulated_study.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/duel/duel_window.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/help/guide_window.h"
#include "app/workbench/help/tour.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/participant/kit/pages.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/page_screen.h"
#include "app/workbench/participant/screens/sample_screens.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/menus.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/history/carry_dialog.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/pull/pull_card.h"
#include "app/workbench/workbench.h"
#include "core/base/error.h"

namespace tactus::workbench {

// Stage Build: each lab with the demo study.

namespace {

constexpr int kLabPatienceMs = 60'000;

// Until nothing more is computed for the lab in front.
void waitForLab(const LabScreen& screen) {
  QEventLoop loop;
  QTimer look;
  int quiet = 0;  // a result may start further work
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    quiet = screen.isBusy() ? 0 : quiet + 1;
    if (quiet == 5) loop.quit();
  });
  QTimer::singleShot(kLabPatienceMs, &loop, &QEventLoop::quit);
  look.start(20);
  loop.exec();
}

/// `bench` has the demo study open.
base::Result<void> addLabPictures(PictureAlbum& album, Workbench& bench) {
  LabScreen& screen = *bench.views.labs;
  bench.window.enter(Stage::kBuild);
  bench.views.depth->showExample();
  for (QWidget* const lab : screen.labs()) {
    screen.reveal(lab);
    waitForLab(screen);
    if (lab->objectName() == QLatin1String("method")) {
      lab->findChild<PrimaryButton*>()->click();
      waitForLab(screen);
    }
    const QString title = stageName(Stage::kBuild) + QStringLiteral(": ") + lab->windowTitle();
    // Pages inside a lab have pictures of their own.
    auto* const pages = lab->findChild<QTabWidget*>();
    const int count = pages == nullptr ? 1 : pages->count();
    for (int page = 0; page < count; ++page) {
      QString name = lab->objectName();
      if (pages != nullptr) pages->setCurrentIndex(page);
      if (page > 0) name += QStringLiteral("_") + pages->widget(page)->objectName();
      if (name == QLatin1String("experts_words_and_rules")) {
        auto* const band = lab->findChild<QComboBox*>(QStringLiteral("band"));
        band->setCurrentIndex(band->count() - 1);  // own words
        emit band->activated(band->currentIndex());
      }
      waitForLab(screen);
      if (auto added = album.add(stageId(Stage::kBuild), name, title, bench.window); !added) return added;
    }
    if (pages != nullptr) pages->setCurrentIndex(0);
  }
  // What a setting moved: the terms of before, and the price.
  screen.reveal(bench.views.speed);
  bench.labs.speed.setAlpha(0.8);
  waitForLab(screen);
  auto moved =
      album.add(stageId(Stage::kBuild), QStringLiteral("speed_changed"),
                stageName(Stage::kBuild) + QStringLiteral(": ") + bench.views.speed->windowTitle(), bench.window);
  bench.labs.corrections.undo();
  waitForLab(screen);
  return moved;
}

// The nurse's screens, each in its window with the red button.

constexpr double kUsualDotsPerInch = 96;

// A screen says where she is; what lies over one is named by its file.
QString titleOf(const QWidget& screen, const QString& name) {
  return screen.accessibleName().isEmpty() ? QString(name).replace(QLatin1Char('_'), QLatin1Char(' '))
                                           : screen.accessibleName();
}

/// Every screen in each of its states, with its longest values.
base::Result<void> addParticipantPictures(PictureAlbum& album, const PictureSettings& settings) {
  const QSize& size = settings.size;
  nurse::Look look;
  look.setAbout(settings.pack);
  look.setLanguage(nurse::Language{settings.language});
  look.setScreen(kUsualDotsPerInch, size);
  for (const nurse::SampleScreen& sample : nurse::sampleScreens(look)) {
    ParticipantWindow window(look, [] {});
    window.resize(size);
    window.setArmed(sample.armed);
    QWidget* const screen = sample.make(look).release();
    if (sample.screen) {
      window.setScreen(screen);
    } else {
      auto* const below = new nurse::PageScreen(look);
      ParticipantState rests;
      rests.page = restPage(false);
      below->setState(rests);
      window.setScreen(below);
      window.cover(screen);
    }
    window.show();
    const QString title = titleOf(*screen, sample.name);
    if (auto added = album.add(QStringLiteral("take_part"), sample.name, title, window); !added) return added;
    window.leave();
  }
  return {};
}

base::Result<void> makeStudyOfPictures(const QString& wanted, const QString& path) {
  if (!wanted.isEmpty()) {
    QFile file(wanted);
    if (file.copy(path) && QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner)) return {};
    return base::fail(base::ErrorCode::kIo, wanted.toStdString(), file.errorString().toStdString(), "a study file");
  }
  TACTUS_TRY(auto made, session::makeSimulatedNgtStudy(path.toStdString()));
  return made.close();
}

/// Until the study is open and its model is built, or the reason why it cannot be.
base::Result<void> openStudy(Workbench& bench, const QString& path) {
  QEventLoop loop;
  base::Result<void> opened;
  const auto fail = [&](const QString& file, const QString& sentence) {
    opened = base::fail(base::ErrorCode::kIo, file.toStdString(), sentence.toStdString(), "the demo study");
    loop.quit();
  };
  QObject::connect(&bench.study, &StudyConnection::failed, &loop, fail);
  QObject::connect(&bench.study_models, &StudyModels::failed, &loop, fail);
  QObject::connect(&bench.study, &StudyConnection::opened, &loop, [&bench] { bench.study_models.buildModel(); });
  QObject::connect(&bench.study_models, &StudyModels::said, &loop, &QEventLoop::quit);
  QObject::connect(&bench.study_models, &StudyModels::backOffered, &loop, &QEventLoop::quit);
  bench.files.open(path);
  loop.exec();
  return opened;
}

/// The layout of `stage`, and each of its panels behind a tab.
base::Result<void> addStage(PictureAlbum& album, Workbench& bench, Stage stage) {
  bench.window.enter(stage);
  PanelArea& panels = bench.window.panels();
  if (auto added = album.add(stageId(stage), QStringLiteral("overview"), stageName(stage), bench.window); !added) {
    return added;
  }
  QList<Panel*> behind;
  for (Panel* panel : panels.panels()) {
    if (panels.isBehind(*panel)) behind << panel;
  }
  for (Panel* panel : behind) {
    panels.resetLayout();
    panel->reveal();
    const QString title = stageName(stage) + QStringLiteral(": ") + panel->windowTitle();
    if (auto added = album.add(stageId(stage), panel->objectName(), title, bench.window); !added) return added;
  }
  return {};
}

/// The edits of a tuned model on the one that was built anew with another setting. Leaves the model as it was.
base::Result<void> addCarry(PictureAlbum& album, Workbench& bench) {
  EditController& edits = bench.edits;
  const editing::StateId untouched = edits.history().current();
  const fuzzy::Expert& first = edits.model().experts.front();
  const fuzzy::Variable& speed = edits.model().inputs.back();
  edits.apply(editing::moveEdge(edits.model(), {editing::listOf(first, speed.id), speed.terms[0].id},
                                editing::Side::kRight, (speed.max - speed.min) / 50, {true, {}}));
  for (const std::size_t rule : {3, 28}) {
    edits.apply(editing::setConsequent(edits.model(), edits.model().experts[0].id, rule, "very_large"));
  }
  edits.apply(editing::setExpertWeight(edits.model(), edits.model().experts.back().id, 0.5));
  edits.snapshot(CarryDialog::tr("my tuned version"));
  const editing::StateId tuned = edits.history().current();
  elicitation::BuildSettings settings;
  settings.speed.alpha = 0.8;
  bench.study_models.buildModelWith(settings);
  waitFor([&] { return edits.history().current() != tuned && !bench.study.isBusy(); });
  bench.window.enter(Stage::kTune);
  const QString area = stageId(Stage::kTune);
  if (auto ok = album.add(area, QStringLiteral("built_anew"), stageName(Stage::kTune), bench.window); !ok) return ok;
  CarryDialog& dialog = *bench.views.carry;
  dialog.bringUp(tuned);
  waitFor([&] { return !bench.carry.list().isBusy() && !bench.carry.sum().isBusy() && bench.carry.together(); });
  if (auto ok = album.add(area, QStringLiteral("carry"), dialog.windowTitle(), dialog); !ok) return ok;
  dialog.hide();
  bench.window.banner().hide();
  edits.returnTo(untouched);
  return {};
}

/// The recorded strokes after an edit where they all pass, which is taken back.
base::Result<void> addStrokes(PictureAlbum& album, Workbench& bench) {
  const fuzzy::ForceModel& model = bench.edits.model();
  const fuzzy::Expert& expert = model.experts[0];
  std::vector<std::size_t> at_the_nose;
  for (std::size_t rule = 0; rule < expert.rules.size(); ++rule) {
    for (const fuzzy::Condition& condition : expert.rules[rule].conditions) {
      if (condition.term == "nasal_cavity") at_the_nose.push_back(rule);
    }
  }
  bench.panels.strokes->reveal();
  auto edit = editing::setConsequent(model, expert.id, at_the_nose, model.output.terms.back().id);
  if (!bench.edits.apply(std::move(edit))) return {};
  waitFor([&strokes = bench.strokes] {
    return strokes.state() == StrokesController::State::kShown && strokes.comparison().summary.felt > 0;
  });
  const QString title = stageName(Stage::kTune) + QStringLiteral(": ") + bench.panels.strokes->windowTitle();
  auto added = album.add(stageId(Stage::kTune), QStringLiteral("strokes_after_edit"), title, bench.window);
  bench.edits.undo();
  return added;
}

/// Contracts that the procedure suggests, checked; taken back.
base::Result<void> addContractPictures(PictureAlbum& album, Workbench& bench) {
  const editing::StateId before = bench.edits.history().current();
  bench.panels.contracts->reveal();
  for (const fuzzy::Contract& one : offeredContracts(bench.edits.model())) bench.contracts.add(one);
  waitFor([&bench] { return bench.contracts.isCurrent() && !bench.contracts.isBusy(); });
  const QString title = stageName(Stage::kTune) + QStringLiteral(": ") + bench.panels.contracts->windowTitle();
  auto added = album.add(stageId(Stage::kTune), QStringLiteral("contracts_checked"), title, bench.window);
  bench.edits.returnTo(before);
  bench.panels.membership_editor->reveal();
  return added;
}

/// The result of a bundle.
base::Result<void> addBundle(PictureAlbum& album, Workbench& bench, const QString& folder) {
  QEventLoop loop;
  QObject::connect(&bench.bundles, &BundleMaker::changed, &loop, [&] {
    if (bench.bundles.doing() == BundleMaker::Doing::kNothing) loop.quit();
  });
  bench.bundles.make(folder);
  loop.exec();
  bench.window.enter(Stage::kDeliver);
  return album.add(stageId(Stage::kDeliver), QStringLiteral("bundle_made"),
                   BundleMaker::tr("%1: a bundle").arg(stageName(Stage::kDeliver)), bench.window);
}

/// A force that is pulled, with the edits to choose from.
base::Result<void> addPull(PictureAlbum& album, Workbench& bench) {
  constexpr double kDown = 0.05;  // N
  bench.window.enter(Stage::kTune);
  QEventLoop loop;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &loop, [&] {
    if (bench.pull.answer() != nullptr && !bench.pull.isSearching()) loop.quit();
  });
  constexpr double kDeep = 200;  // mm, of the demo's x axis
  const std::vector<double> before = bench.scene.values();
  bench.scene.setValue(bench.scene.xInput(), kDeep);
  constexpr double kPinned = 130;  // mm
  std::vector<double> pinned = before;
  pinned[bench.scene.xInput()] = kPinned;
  bench.pull.togglePin(pinned);
  emit bench.views.curves->pullAsked();
  bench.pull.setExpert(bench.scene.model()->model.experts.size() - 1);
  PullWish wish = bench.pull.wish();
  wish.force_n -= kDown;
  bench.pull.setWish(wish);
  look.start(20);
  loop.exec();
  auto added = album.add(stageId(Stage::kTune), QStringLiteral("pull"),
                         PullCard::tr("%1: a force that is pulled").arg(stageName(Stage::kTune)), bench.window);
  bench.pull.cancel();
  bench.pull.clearPins();
  bench.scene.goTo(before);
  return added;
}

/// Each step of the tour, the guide, and the search.
base::Result<void> addHelp(PictureAlbum& album, Workbench& bench) {
  const QString help = QStringLiteral("help");
  Tour& tour = bench.help->tour();
  for (int step = 0; step < tour.steps(); ++step) {
    tour.goTo(step);
    const QString screen = QStringLiteral("tour_%1").arg(step + 1);
    if (auto added =
            album.add(help, screen, TourCard::tr("Tour, step %1 of %2").arg(step + 1).arg(tour.steps()), bench.window);
        !added) {
      return added;
    }
  }
  tour.end();
  GuideWindow& guide = bench.help->guide();
  guide.show();
  if (auto added = album.add(help, QStringLiteral("guide"), guide.windowTitle(), guide); !added) return added;
  guide.hide();
  CommandSearch search(
      bench.search->sources(), [&bench](const QString& typed) { return bench.search->placesIn(typed); }, &bench.window);
  search.show();
  return album.add(help, QStringLiteral("search"), search.windowTitle(), search);
}

/// A simulator on the curves, as one that sends `felt` stands there.
base::Result<void> addSimulator(PictureAlbum& album, Bench& bench) {
  constexpr double kAtMm = 155;
  const OpenModel& open = *bench.scene.model();
  const auto way = fuzzy::wayOf(open.model.inputs);
  if (!way) return {};
  std::vector<double> point(bench.scene.values().begin(), bench.scene.values().end());
  point[*way] = kAtMm;
  const QString name = QCoreApplication::translate("LinkFeature", "From the simulator");
  bench.views.curves->setSimulators({{name, kAtMm, open.compiled.evaluate(point).force_n}});
  bench.panels.curves->reveal();
  auto added = album.add(stageId(Stage::kUnderstand), QStringLiteral("simulator"), name, bench.window);
  bench.views.curves->setSimulators({});
  return added;
}

/// The Feel layout, and in it the body in three dimensions with the tip on its way.
base::Result<void> addFeelLayout(PictureAlbum& album, Bench& bench) {
  constexpr double kOnTheWayMm = 130;
  const QString area = QStringLiteral("feel");
  const QString title = bench.panels.feel->windowTitle();
  bench.window.enterLayout(feelLayout());
  if (auto added = album.add(area, QStringLiteral("layout"), title, bench.window); !added) return added;
  bench.feel.start(QStringLiteral("virtual"));
  waitFor([&feel = bench.feel] { return feel.isRunning(); });
  bench.feel.newPlacementAt(kOnTheWayMm);
  waitFor([&feel = bench.feel] { return feel.depthMm() > kOnTheWayMm / 2; });
  bench.feel.stop();
  bench.views.feel->setSolid(true);
  auto added = album.add(area, QStringLiteral("solid"), title, bench.window);
  bench.views.feel->setSolid(false);
  bench.window.leaveLayout();
  return added;
}

/// What a blind duel of one nurse and the mean takes.
base::Result<void> addDuelPicture(PictureAlbum& album, Bench& bench) {
  CompareChoice nurse;
  nurse.kind = CompareChoice::Kind::kExpert;
  nurse.expert = bench.edits.model().experts.front().id;
  bench.compare.choose(CompareSide::kA, nurse);
  bench.compare.choose(CompareSide::kB, {});
  emit bench.views.history->feelBlindRequested();
  auto* const duel = bench.window.findChild<DuelWindow*>();
  if (auto added = album.add(QStringLiteral("feel"), QStringLiteral("blind-duel"), duel->windowTitle(), *duel); !added)
    return added;
  for (QPushButton* button : duel->findChildren<QPushButton*>()) {
    if (button->isVisible() && button->text() == DuelWindow::tr("Begin")) button->click();
  }
  auto added = album.add(QStringLiteral("feel"), QStringLiteral("blind-duel-trial"), duel->windowTitle(), *duel);
  bench.duel.stop();
  duel->hide();
  return added;
}

/// The stroke that tells that nurse from the mean.
base::Result<void> addTellPicture(PictureAlbum& album, Bench& bench) {
  emit bench.views.history->tellRequested();
  waitFor([&bench] { return bench.tell.told() != nullptr && !bench.tell.isBusy(); });
  auto* const tell = bench.window.findChild<QDialog*>(QStringLiteral("tell_window"));
  auto added = album.add(stageId(Stage::kTune), QStringLiteral("tell"), tell->windowTitle(), *tell);
  tell->hide();
  return added;
}

}  // namespace

base::Result<void> writeScreenPictures(const PictureSettings& wanted) {
  if (wanted.pack != nullptr) {
    PictureAlbum album(wanted);
    if (auto added = addParticipantPictures(album, wanted); !added) return added;
    return album.finish();
  }
  const QTemporaryDir folder;
  const QString study =
      folder.filePath(wanted.study.isEmpty() ? QStringLiteral("ngt-demo.tactus") : QFileInfo(wanted.study).fileName());
  if (auto made = makeStudyOfPictures(wanted.study, study); !made) return made;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  Workbench bench(settings, folder.filePath(QStringLiteral("autosave")));
  bench.window.resize(wanted.size);
  bench.window.show();

  PictureAlbum album(wanted);
  if (auto added =
          album.add(QStringLiteral("start"), QStringLiteral("start"), bench.window.windowTitle(), bench.window);
      !added) {
    return added;
  }
  if (auto opened = openStudy(bench, study); !opened) return opened;
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kDeliver}) {
    if (auto added = addStage(album, bench, stage); !added) return added;
    if (stage == Stage::kUnderstand) {
      if (auto added = addSimulator(album, bench); !added) return added;
    }
    if (stage != Stage::kTune) continue;
    if (auto added = addStrokes(album, bench); !added) return added;
    if (auto added = addContractPictures(album, bench); !added) return added;
  }
  if (auto added = addPull(album, bench); !added) return added;
  if (auto added = addBundle(album, bench, folder.filePath(QStringLiteral("ngt-demo-bundle"))); !added) return added;
  if (auto added = addLabPictures(album, bench); !added) return added;
  if (auto added = addCarry(album, bench); !added) return added;
  if (auto added = addCollectPictures(album, bench, folder.path()); !added) return added;
  if (auto added = addHelp(album, bench); !added) return added;
  if (auto added = addFeelLayout(album, bench); !added) return added;
  if (auto added = addDuelPicture(album, bench); !added) return added;
  if (auto added = addTellPicture(album, bench); !added) return added;
  ShortcutSheet sheet(*bench.window.menuBar(), &bench.window);
  sheet.show();
  if (auto added = album.add(QStringLiteral("help"), QStringLiteral("shortcuts"), sheet.windowTitle(), sheet); !added) {
    return added;
  }
  sheet.hide();
  LinkDialog& link = *bench.views.link;
  link.show();
  if (auto added = album.add(QStringLiteral("deliver"), QStringLiteral("serve"), link.windowTitle(), link); !added) {
    return added;
  }
  link.hide();
  if (auto added = addParticipantPictures(album, wanted); !added) return added;
  return album.finish();
}

}  // namespace tactus::workbench
