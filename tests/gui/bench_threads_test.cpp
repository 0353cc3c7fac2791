// The controllers with all their threads: the servo on the virtual device in real time, the lint in the background, and
// edits all the while. Built with the thread sanitizer it shows every race of our own code.
#include <QCoreApplication>
#include <QSettings>
#include <QTest>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/device/device_search.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_panel.h"
#include "app/workbench/workbench.h"

#include "tests/gui/bench_gestures.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/shown_bench.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;
constexpr int kGesturesOfThreads = 150;  // a second or two

int threadGestures() {
  const char* const wanted = std::getenv("TACTUS_THREAD_GESTURES");
  return wanted == nullptr ? kGesturesOfThreads : std::atoi(wanted);
}

TEST(BenchThreads, EditsWhileTheServoRunsAndTheLintWorks) {
  auto model = support::s4AsPrinted();
  model.experts.push_back(support::s4Shifted().experts[0]);
  model.experts[1].id = "S5";
  const tests::ModelFolder folder;
  const QString path = folder.write(model);
  tests::BenchControllers bench;
  FindingsController& findings = bench.findings;
  DeviceSession device_session;
  FeelController feel{bench.scene, device_session};
  DeviceSearch search;
  bench.models.open(path);
  tests::BenchGestures hand(7, tests::BenchReach(bench));
  findings.setWatched(true);
  search.search();
  feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(feel.isRunning());
  feel.session().setHeld(true);

  base::Random random(3);
  std::size_t runs = 1;
  const int count = threadGestures();
  for (int k = 0; k < count; ++k) {
    const std::string what = hand.play();
    ASSERT_EQ(hand.check(false), "") << "gesture " << k << ", " << what;
    feel.session().setTarget(random.uniform(0, 120));
    if (k % 10 == 0) feel.setPosed(k % 20 == 0);
    if (k % 7 == 0) feel.session().setHeld(k % 14 == 0);
    if (k % 11 == 0 && findings.isCurrent() && !findings.findings().empty()) {
      findings.choose(static_cast<std::size_t>(random.below(static_cast<int>(findings.findings().size()))));
    }
    if (k % 13 == 0 && !findings.fixes().empty()) findings.apply(0);
    if (k % 17 == 0) findings.setWatched(k % 34 != 0);
    if (k % 40 == 39) {
      feel.newPlacement();
      feel.stop();
      feel.start(QStringLiteral("virtual"));
      ++runs;
    }
    QCoreApplication::processEvents();
    if (feel.state() == FeelController::State::kTripped) feel.session().rearm();
  }
  bench.edits.commit();
  findings.setWatched(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return findings.isCurrent(); }, kPatience));
  EXPECT_EQ(*findings.lintedModel(), bench.edits.model());
  // The last edit is in the force.
  const auto last = feel.latest().orders;
  feel.newPlacement();
  ASSERT_TRUE(QTest::qWaitFor([&] { return feel.latest().orders > last; }, kPatience));
  EXPECT_GT(feel.session().statistics().ticks, 0U);
  EXPECT_GT(runs, 1U);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !search.isSearching(); }, kPatience));
  feel.stop();
}

TEST(BenchThreads, EverythingEndsInTheMiddleOfItsWork) {
  const tests::ModelFolder folder;
  const QString path = folder.write(support::s4AsPrinted());
  for (int i = 0; i < 5; ++i) {
    ModelController models;
    SceneController scene(models);
    DeviceSession device_session;
    FeelController feel{scene, device_session};
    EditController edits(models);
    FindingsController findings(edits, scene);
    models.open(path);
    findings.setWatched(true);
    feel.start(QStringLiteral("virtual"));
    if (i % 2 == 0) QCoreApplication::processEvents();
  }
}

// A view in sight keeps the map's worker going, and tells the map when it is hidden.
TEST(BenchThreads, ViewsAreOutOfSightBeforeWhatTheyUseGoes) {
  const tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  auto bench = std::make_unique<Workbench>(settings, folder.path(QStringLiteral("autosave")));
  bench->window.resize(1280, 720);
  bench->window.show();
  bench->models.open(folder.write(support::s4AsPrinted()));
  bench->window.enter(Stage::kUnderstand);
  tests::settle(bench->window);
  bench->panels.map->reveal();
  tests::settle(bench->window);
  const MapPanel& map = *bench->views.map;
  ASSERT_TRUE(map.isVisible());
  const auto* forces = bench->features.findChild<ForceMapController*>();
  ASSERT_NE(forces, nullptr);
  bool was_seen = true;
  QObject::connect(forces, &QObject::destroyed, [&] { was_seen = map.isVisible(); });
  bench.reset();
  EXPECT_FALSE(was_seen);
}

}  // namespace
}  // namespace tactus::workbench
