// One edit compiles its model once, and history, plots, findings, study and servo share what came out.
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/membership_edits.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/ghost_controller.h"

#include "tests/gui/bench_controllers.h"
#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"

// The linker sends every call of fuzzy::compile here (--wrap, see CMakeLists.txt).
namespace tactus::fuzzy {
base::Result<CompiledModel> realCompile(const ForceModel& model) asm(
    "__real__ZN6tactus5fuzzy7compileERKNS0_10ForceModelE");
base::Result<CompiledModel> countedCompile(const ForceModel& model) asm(
    "__wrap__ZN6tactus5fuzzy7compileERKNS0_10ForceModelE");
}  // namespace tactus::fuzzy

namespace {

std::mutex mutex;
bool counting = false;
std::vector<tactus::fuzzy::ForceModel> compiled;

void count(bool on) {
  const std::lock_guard lock(mutex);
  counting = on;
  compiled.clear();
}

}  // namespace

namespace tactus::fuzzy {
base::Result<CompiledModel> countedCompile(const ForceModel& model) {
  {
    const std::lock_guard lock(mutex);
    if (counting) ::compiled.push_back(model);
  }
  return realCompile(model);
}
}  // namespace tactus::fuzzy

namespace tactus::workbench {
namespace {

using tests::kDepth;
using tests::kPatience;

class OneCompilation : public testing::Test {
 protected:
  OneCompilation() { bench.models.open(folder.write(tests::twoExperts())); }
  ~OneCompilation() override { count(false); }

  static base::Result<editing::Edit> farSays(fuzzy::ForceModel model, const char* term) {
    model.experts[0].rules[2].then = term;
    return editing::finished(std::move(model), std::string("far is ") + term);
  }

  /// Everything that follows an edit, at once or in the background.
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return bench.findings.isCurrent(); }, kPatience));
    QCoreApplication::processEvents();
    time.advance(feel, 50);
    EXPECT_NE(ghost.curves(), nullptr);
    EXPECT_FALSE(ghost.differenceText().isEmpty());
    EXPECT_FALSE(bench.edits.effectOf(bench.edits.history().current()).isEmpty());
  }

  static std::ptrdiff_t compilationsOf(const fuzzy::ForceModel& model) {
    const std::lock_guard lock(mutex);
    return std::count_if(::compiled.begin(), ::compiled.end(),
                         [&](const auto& one) { return editing::sameBits(one, model); });
  }

  tests::ModelFolder folder;
  tests::SteppedFeel time;
  tests::BenchControllers bench;
  DeviceSession device_session{time.settings()};
  FeelController feel{bench.scene, device_session};
  GhostController ghost{bench.edits, bench.scene};
};

TEST_F(OneCompilation, OfAnEditThatIsShownFeltLintedAndCompared) {
  feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(feel.isRunning());
  const fuzzy::ForceModel before = bench.edits.model();
  count(true);
  ASSERT_TRUE(bench.edits.apply(farSays(before, "low")));
  settle();
  EXPECT_TRUE(feel.editLatency()) << "it was felt";
  EXPECT_EQ(compilationsOf(bench.edits.model()), 1);
  EXPECT_EQ(compilationsOf(before), 0);
}

TEST_F(OneCompilation, UndoOfTheLastEditCompilesNothing) {
  feel.start(QStringLiteral("virtual"));
  const fuzzy::ForceModel before = bench.edits.model();
  ASSERT_TRUE(bench.edits.apply(farSays(before, "low")));
  settle();
  const fuzzy::ForceModel after = bench.edits.model();
  count(true);
  bench.edits.undo();
  time.advance(feel, 50);
  bench.edits.redo();
  time.advance(feel, 50);
  EXPECT_EQ(compilationsOf(before), 0);
  EXPECT_EQ(compilationsOf(after), 0);
}

TEST_F(OneCompilation, HistoryPlotsAndGhostHoldTheSameModel) {
  const auto opened = bench.models.current()->shared;
  EXPECT_EQ(bench.edits.history().ready(), opened);
  ASSERT_TRUE(bench.edits.apply(farSays(bench.edits.model(), "low")));
  EXPECT_EQ(bench.models.current()->shared, bench.edits.history().ready());
  EXPECT_EQ(bench.scene.shared()->shared, bench.edits.history().ready());
  ASSERT_NE(ghost.before(), nullptr);
  EXPECT_EQ(ghost.before()->shared, opened);
}

TEST_F(OneCompilation, TheCostIsMeasuredOnceForEachShapeOfAModel) {
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(feel.costMeasurements(), 1);
  fuzzy::ForceModel model = bench.scene.model()->model;
  for (int i = 0; i < 10; ++i) {
    model.inputs[kDepth].terms[0].points[3] = 5 + 0.01 * i;
    ASSERT_TRUE(bench.models.edit(model));
    time.advance(feel, 3);
  }
  bench.scene.setValue(0, 30);
  feel.stop();
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(feel.costMeasurements(), 1);
  model.experts[0].rules.pop_back();
  ASSERT_TRUE(bench.models.edit(model));
  EXPECT_EQ(feel.costMeasurements(), 2);
}

}  // namespace
}  // namespace tactus::workbench
