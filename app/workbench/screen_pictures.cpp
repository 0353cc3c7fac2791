#include "app/workbench/screen_pictures.h"

#include <QComboBox>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QMenuBar>
#include <QSettings>
#include <QSize>
#include <QString>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "app/session/simulated_nurse.h"
#include "app/session/simulated_study.h"
#include "app/session/study_protocol.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/collect/collect_view.h"
#include "app/workbench/collect/monitor_window.h"
#include "app/workbench/collect/protocol_view.h"
#include "app/workbench/collect/study_home.h"
#include "app/workbench/collect/withdrawal_dialog.h"
#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/features/features.h"
#include "app/workbench/help/guide_window.h"
#include "app/workbench/help/tour.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/depth/depth_lab_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/closing_screens.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/screens/sample_screens.h"
#include "app/workbench/session/nurse_view.h"
#include "app/workbench/shell/command_search.h"
#include "app/workbench/shell/help_menu.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/pull/pull_card.h"
#include "app/workbench/workbench.h"
#include "core/base/error.h"
#include "core/store/persons.h"
#include "core/store/research_key.h"
#include "core/store/sessions.h"

namespace tactus::workbench {

// Pictures of stage Collect, for --screens: of the demo study and of one with sessions in progress.

class PictureAlbum;
struct Workbench;

/// `bench` has the demo study open; another study, in `folder`, is open afterwards.
base::Result<void> addCollectPictures(PictureAlbum& album, Workbench& bench, const QString& folder);

namespace {

using base::Result;

const QString kArea = QStringLiteral("collect");
constexpr std::int64_t kBegin = 1'763'971'200'000;  // 2025-11-24 08:00 UTC: the same in each picture
constexpr const char* kChinese = "zh-Hant";

/// A participant of the pictures and how many steps of a session they have done.
struct Guest {
  const char* code;
  const char* language;
  int steps;
};

// Each step is one record, done as the screens do it.
Result<void> doSteps(session::Session& session, int steps, const session::NurseTraits& traits) {
  session::SimulatedNurse nurse(traits, session.record().seed);
  for (int i = 0; i < steps && session.part() != session::SessionPart::kFinished; ++i) {
    if (auto ok = nurse.doNext(session); !ok) return ok;
  }
  return {};
}

Result<void> addGuest(store::StudyFile& file, study::RecordIds& ids, const Guest& guest, int day,
                      const session::NurseTraits& traits) {
  const study::Person person{ids.next(), guest.code, false};
  if (auto ok = store::append(file, person); !ok) return ok;
  if (guest.steps == 0) return {};
  const auto seed = static_cast<std::uint64_t>(day) + 1;
  TACTUS_TRY(const auto start, session::startUnderProtocol(file, person.id, guest.language, seed));
  const study::Moment when{kBegin + day * std::int64_t{86'400'000}, 0};
  auto session = session::Session::begin(file, start, {[when] { return when; }, study::RecordIds(seed)});
  if (!session) return tl::unexpected(session.error());
  return doSteps(*session, guest.steps, traits);
}

// Everybody in it is another way along.
Result<void> makeStudy(const QString& path) {
  study::RecordIds ids(11);
  TACTUS_TRY(auto file, store::StudyFile::create(path.toStdString(), {ids.next(), "Ward 7", kBegin, "pictures"}));
  session::StudyProtocol protocol;
  protocol.languages = {"en", kChinese};
  protocol.consent_version = "2025-11";
  protocol.consent = {{"en", "This study is run by the School of Nursing. Questions: ask the researcher."},
                      {kChinese, "本研究由護理學院主持。如有疑問，請洽研究人員。"}};
  protocol.device = {"touch", 0.26, 2, 0.88};
  session::SessionTools tools{[] { return study::Moment{kBegin, 0}; }, study::RecordIds(12)};
  if (auto set = session::setProtocol(file, protocol, "lee", {}, tools); !set) return tl::unexpected(set.error());
  if (auto set = store::setResearchKey(file, "pictures", kBegin); !set) return set;
  const Guest guests[] = {{"amber-crow", kChinese, 400},
                          {"blue-fox", "en", 27},
                          {"calm-heron", kChinese, 60},
                          {"dusty-lark", "en", 9},
                          {"early-finch", "en", 0}};
  const session::NurseTraits traits = session::simulatedNurseCalled("S1", session::kDefaultSeed);
  int day = 0;
  for (const Guest& guest : guests) {
    if (auto ok = addGuest(file, ids, guest, day++, traits); !ok) return ok;
  }
  return file.close();
}

// A session at the forces, as the monitor sees it.
Result<void> addMonitor(PictureAlbum& album, Workbench& bench) {
  SessionProxy proxy(bench.study);
  const auto* const row = &bench.collect.overview().rows.at(1);
  std::optional<study::RecordId> session;
  bench.study.read(bench.study, [&session, person = row->person](const store::StudyFile& file) {
    const auto sessions = store::sessions(file, person);
    return [&session, found = sessions && !sessions->empty() ? std::optional(sessions->back().id) : std::nullopt] {
      session = found;
    };
  });
  waitFor([&] { return session.has_value(); });
  if (!session) return {};
  proxy.resume(*session);
  waitFor([&] { return proxy.snapshot() != nullptr; });
  std::int64_t now_ms = kBegin + 1'234'000;
  MonitorController monitor(proxy, bench.study, [&now_ms] { return now_ms += 8'000; });
  for (int i = 0; i < 3 && proxy.snapshot() && proxy.snapshot()->part == session::SessionPart::kForce; ++i) {
    experiments::ForceAnswer answer{study::ForceJudgement::Kind::kTerm, i == 0 ? "very_small" : "small"};
    answer.forward_mm = 40;
    answer.forward_speed_mm_s = 60;
    answer.delivered_share = i == 1 ? 0.82 : 1.0;
    const std::size_t lines = monitor.lines().size();
    if (!proxy.judge(proxy.snapshot()->step, answer)) break;
    waitFor([&] { return monitor.lines().size() > lines; });
  }
  monitor.note(MonitorWindow::tr("Grip changed"));
  ParticipantState state;
  state.code = row->code;
  state.screen = ParticipantScreen::kForce;
  state.device = DeviceStep::kReady;
  state.force.phase = ForceState::Phase::kFeel;
  const auto snapshot = proxy.snapshot();
  NurseView view = nurseView(state, snapshot && snapshot->force ? &*snapshot->force : nullptr);
  monitor.show(view);
  std::vector<haptics::Sample> samples(12'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = static_cast<double>(i) * 1e-3;
    const double wanted_n = std::fmod(time_s, 6) < 3 ? (time_s < 6 ? 0.6 : 0.7) : 0;
    samples[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;
    samples[i].source_force_n = wanted_n;
    samples[i].force_n = wanted_n * (1 - std::exp(-std::fmod(time_s, 6) / 0.08));
  }
  monitor.add(samples);
  MonitorWindow window(monitor);
  window.show();
  if (auto ok = album.add(kArea, QStringLiteral("monitor"), window.windowTitle(), window); !ok) return ok;
  view.called = view.force_off = true;
  monitor.show(view);
  auto added = album.add(kArea, QStringLiteral("monitor_called"), window.windowTitle(), window);
  window.hide();
  proxy.leave();
  waitFor([&] { return !proxy.isSaving(); });
  return added;
}

}  // namespace

Result<void> addCollectPictures(PictureAlbum& album, Workbench& bench, const QString& folder) {
  const auto home = [&](const char* screen) {
    bench.window.banner().hide();
    return album.add(kArea, QLatin1String(screen), stageName(Stage::kCollect), bench.window);
  };
  const auto settled = [&] {
    return !bench.study.isOpening() && bench.collect.isCurrent() && bench.protocol.isReady();
  };
  bench.window.enter(Stage::kCollect);
  if (auto ok = home("home_simulated"); !ok) return ok;

  const QString path = folder + QStringLiteral("/ward-7.tactus");
  if (auto made = makeStudy(path); !made) return made;
  bench.files.open(path);
  waitFor([&] { return bench.study.path() == path && settled() && bench.collect.overview().rows.size() == 5; });
  bench.window.enter(Stage::kCollect);
  StudyHome& list = bench.views.collect->home();
  list.select(bench.collect.overview().rows.at(1).person);
  if (auto ok = home("home"); !ok) return ok;
  bench.views.collect->showProtocol();
  if (auto ok = home("protocol"); !ok) return ok;
  bench.views.collect->protocolPage().showSection(2);
  if (auto ok = home("protocol_forces"); !ok) return ok;
  bench.views.collect->protocolPage().showSection(4);
  if (auto ok = home("protocol_consent"); !ok) return ok;
  bench.protocol.set("force.ladder.highest_n", QStringLiteral("2.4"));
  bench.views.collect->protocolPage().showSection(2);
  if (auto ok = home("protocol_refused"); !ok) return ok;
  bench.protocol.discard();
  bench.views.collect->showHome();
  WithdrawalDialog dialog(bench.collect, bench.collect.overview().rows.at(1).person, &bench.window);
  dialog.show();
  waitFor([&] { return dialog.isCounted(); });
  if (auto ok = album.add(kArea, QStringLiteral("withdrawal"), dialog.windowTitle(), dialog); !ok) return ok;
  dialog.hide();
  if (auto ok = addMonitor(album, bench); !ok) return ok;

  const QString empty = folder + QStringLiteral("/new-study.tactus");
  bench.study.create(empty);
  waitFor([&] { return bench.study.path() == empty && settled(); });
  bench.window.enter(Stage::kCollect);
  return home("home_empty");
}

// Pictures of stage Build, for --screens: each lab with the demo study.

class PictureAlbum;
struct Workbench;

/// `bench` has the demo study open.
base::Result<void> addLabPictures(PictureAlbum& album, Workbench& bench);

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

}  // namespace

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
  return {};
}

// Pictures of the nurse's screens, each in its window with the red button.

class PictureAlbum;

/// Adds every screen in each of its states, with its longest values. `language`: `en`, `zh-Hant`, `zh-Hans`; English
/// for others. `size`: of the window, px.
base::Result<void> addParticipantPictures(PictureAlbum& album, const QString& language, const QSize& size);

namespace {

constexpr double kUsualDotsPerInch = 96;

// A screen says where she is; what lies over one is named by its file.
QString titleOf(const QWidget& screen, const QString& name) {
  return screen.accessibleName().isEmpty() ? QString(name).replace(QLatin1Char('_'), QLatin1Char(' '))
                                           : screen.accessibleName();
}

}  // namespace

base::Result<void> addParticipantPictures(PictureAlbum& album, const QString& language, const QSize& size) {
  nurse::Look look;
  if (const auto known = nurse::languageWithId(language)) look.setLanguage(*known);
  look.setScreen(kUsualDotsPerInch, size);
  for (const nurse::SampleScreen& sample : nurse::sampleScreens()) {
    ParticipantWindow window(look, [] {});
    window.resize(size);
    window.setArmed(nurse::isWithDevice(sample.name));
    QWidget* const screen = sample.make(look).release();
    if (qobject_cast<nurse::PanelCard*>(screen) != nullptr) {
      window.setScreen(new nurse::RestScreen(look));
      window.cover(screen);
    } else {
      window.setScreen(screen);
    }
    window.show();
    const QString title = titleOf(*screen, sample.name);
    if (auto added = album.add(QStringLiteral("take_part"), sample.name, title, window); !added) return added;
    window.leave();
  }
  return {};
}

namespace {

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

}  // namespace

base::Result<void> writeScreenPictures(const PictureSettings& wanted) {
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
  }
  if (auto added = addPull(album, bench); !added) return added;
  if (auto added = addBundle(album, bench, folder.filePath(QStringLiteral("ngt-demo-bundle"))); !added) return added;
  if (auto added = addLabPictures(album, bench); !added) return added;
  if (auto added = addCollectPictures(album, bench, folder.path()); !added) return added;
  if (auto added = addHelp(album, bench); !added) return added;
  bench.window.enterLayout(feelLayout());
  if (auto added =
          album.add(QStringLiteral("feel"), QStringLiteral("layout"), bench.panels.feel->windowTitle(), bench.window);
      !added) {
    return added;
  }
  bench.window.leaveLayout();
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
  if (auto added = addParticipantPictures(album, wanted.language, wanted.size); !added) return added;
  return album.finish();
}

}  // namespace tactus::workbench
