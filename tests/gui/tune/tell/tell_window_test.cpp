// The stroke that tells in the window: found from the comparison, played, felt blind, kept for the panel Strokes.
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "app/replay/stroke_file.h"
#include "app/workbench/feel/duel/duel_window.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/history/history_panel.h"

#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class TellWindowTest : public tests::ShownBench {
 protected:
  TellWindowTest() : ShownBench(Stage::kTune) {}

  void openStudy() {
    tests::makeStudyFile(study_path);
    bench.study.open(study_path);
    ASSERT_TRUE(QTest::qWaitFor([this] { return bench.study.isOpen(); }, kPatience));
    // Without the hole of these experts: a tube that is pushed into one keeps its last force, which is no comparison.
    fuzzy::ForceModel model = tests::twoExperts();
    for (fuzzy::Variable& input : model.inputs) {
      if (input.id == "depth") input.terms[0].points = {0, 0, 4, 7};
    }
    bench.models.open(folder.write(model));
    bench.study_models.putModel();
    ASSERT_TRUE(
        QTest::qWaitFor([this] { return bench.study_models.keepsModel() && !bench.study.isBusy(); }, kPatience));
    bench.window.enter(Stage::kTune);
  }
  /// Near and slow says high in B.
  void find() {
    fuzzy::ForceModel harder = bench.edits.model();
    harder.experts[0].rules[0].then = "high";
    ASSERT_TRUE(bench.edits.apply(editing::finished(harder, "Near and slow: High")));
    bench.compare.choose(CompareSide::kA, {CompareChoice::Kind::kPrevious, 0, {}});
    bench.compare.choose(CompareSide::kB, {CompareChoice::Kind::kOpen, 0, {}});
    emit bench.views.history->tellRequested();
    ASSERT_TRUE(QTest::qWaitFor([this] { return bench.tell.told() != nullptr && !bench.tell.isBusy(); }, kPatience));
    tests::settle(window());
  }
  QDialog& window() { return *bench.window.findChild<QDialog*>(QStringLiteral("tell_window")); }
  QPushButton& button(const char* name) { return *window().findChild<QPushButton*>(QLatin1String(name)); }

  QString study_path = folder.path(QStringLiteral("told.tactus"));
};

TEST_F(TellWindowTest, ShowsWhatWasFound) {
  find();
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(window().findChild<QLabel*>(QStringLiteral("tell_verdict"))->text(), bench.tell.verdict());
  EXPECT_EQ(window().findChild<QLabel*>(QStringLiteral("tell_bound"))->text(), bench.tell.bound());
  EXPECT_FALSE(button("tell_cancel").isVisible());
  EXPECT_TRUE(button("tell_play").isEnabled());
  // Asked for the same pair again, it is there at once.
  window().hide();
  emit bench.views.history->tellRequested();
  EXPECT_TRUE(window().isVisible());
  EXPECT_FALSE(bench.tell.isBusy());
}

TEST_F(TellWindowTest, AGhostHandPlaysItInThePanelFeel) {
  find();
  const std::vector<double> before = bench.scene.values();
  button("tell_play").click();
  EXPECT_FALSE(window().isVisible());
  ASSERT_TRUE(QTest::qWaitFor([this] { return bench.feel.isReplay(); }, kPatience));
  EXPECT_TRUE(bench.panels.feel->isVisible());
  EXPECT_EQ(bench.compare.shown(), CompareSide::kB);
  double deepest_mm = 0;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        deepest_mm = std::max(deepest_mm, bench.scene.value(tests::kDepth));
        return !bench.feel.isRunning();
      },
      kPatience));
  EXPECT_GT(deepest_mm, 5) << "the operating point followed the stroke";
  EXPECT_TRUE(QTest::qWaitFor([this] { return window().isVisible(); }, kPatience));
}

TEST_F(TellWindowTest, TheDuelTakesItsWayAndConditions) {
  find();
  const contracts::Stroke& stroke = bench.tell.told()->found.stroke;
  button("tell_duel").click();
  auto* const duel = bench.window.findChild<DuelWindow*>();
  ASSERT_TRUE(duel->isVisible());
  const auto boxes = duel->findChildren<NumberBox*>();
  ASSERT_GE(boxes.size(), 3);
  EXPECT_EQ(boxes[0]->value(), stroke.from_mm);
  EXPECT_EQ(boxes[1]->value(), stroke.to_mm);
  EXPECT_GE(boxes[2]->value(), 5);
  EXPECT_LE(boxes[2]->value(), stroke.peak_mm_s);
  duel->hide();
  // About another pair the duel would lie.
  bench.edits.undo();
  tests::settle(window());
  EXPECT_FALSE(button("tell_duel").isEnabled());
}

TEST_F(TellWindowTest, KeptInTheStudyThePanelStrokesRunsItAsCalculated) {
  openStudy();
  find();
  button("tell_keep").click();
  ASSERT_TRUE(QTest::qWaitFor(
      [this] {
        const auto& all = bench.study.recordings();
        return !all.empty() && all.back().finished && !bench.study.isBusy();
      },
      kPatience));
  const store::FeelSummary& kept = bench.study.recordings().back();
  EXPECT_TRUE(kept.start.setting.simulated);
  EXPECT_EQ(kept.start.setting.device, "calculated stroke, no hand");
  window().hide();
  bench.panels.strokes->reveal();
  ASSERT_TRUE(QTest::qWaitFor(
      [this] { return bench.strokes.state() == StrokesController::State::kShown && !bench.strokes.isOld(); },
      kPatience))
      << bench.strokes.leftOut().join(QLatin1Char(' ')).toStdString();
  ASSERT_EQ(bench.strokes.comparison().strokes.size(), 1U);
  EXPECT_EQ(bench.strokes.nameOf(0), QStringLiteral("calculated stroke, recording 1"));
  EXPECT_TRUE(bench.strokes.caption().contains(QStringLiteral("SIMULATED"))) << bench.strokes.caption().toStdString();
  // It was made on the edit that it tells: the edit is felt.
  EXPECT_EQ(bench.strokes.comparison().summary.felt, 1U);
}

}  // namespace
}  // namespace tactus::workbench
