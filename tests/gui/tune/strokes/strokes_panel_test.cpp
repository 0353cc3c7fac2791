// The strip of strokes as people use it: the line, a click on a trace, the keys, and the way out where it is empty.
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QWidget>
#include <memory>

#include "tests/gui/tune/strokes/strokes_fixture.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class StrokesPanelTest : public StrokesFixture {
 protected:
  void show() {
    panel.reset(makeStrokesPanel(strokes));
    panel->resize(560, 300);
    panel->show();
  }
  template <class Part>
  Part* part(const char* name) const {
    return panel->findChild<Part*>(QLatin1String(name));
  }
  QString headline() const { return part<QLabel>("strokes_headline")->text(); }

  std::unique_ptr<QWidget> panel;
};

TEST_F(StrokesPanelTest, AClickOnATraceGoesThere) {
  openStudy();
  record();
  show();
  ASSERT_TRUE(isShown());
  harden();
  ASSERT_TRUE(comesTrue([this] { return headline().startsWith(QStringLiteral("Of 2 strokes, 2 would feel")); }))
      << headline().toStdString();
  auto* const traces = part<QWidget>("stroke_traces");
  auto* const replay = part<QPushButton>("strokes_replay");
  EXPECT_FALSE(replay->isEnabled());
  scene.setValue(tests::kDepth, 9);
  QTest::mouseClick(traces, Qt::LeftButton, {}, {20, 20});
  EXPECT_EQ(scene.value(tests::kDepth), strokes.comparison().strokes[0].numbers->largest_at_mm);
  EXPECT_TRUE(replay->isEnabled());
  QSignalSpy asked(&strokes, &StrokesController::replayRequested);
  replay->click();
  EXPECT_EQ(asked.count(), 1);
}

TEST_F(StrokesPanelTest, TheKeysChooseAndGoThere) {
  openStudy();
  record();
  show();
  ASSERT_TRUE(isShown());
  auto* const traces = part<QWidget>("stroke_traces");
  QTest::keyClick(traces, Qt::Key_Right);
  EXPECT_EQ(strokes.chosen(), 0U);
  QTest::keyClick(traces, Qt::Key_End);
  EXPECT_EQ(strokes.chosen(), 1U);
  EXPECT_TRUE(traces->accessibleDescription().contains(QStringLiteral("peak ")));
  scene.setValue(tests::kDepth, 9);
  QTest::keyClick(traces, Qt::Key_Return);
  EXPECT_EQ(scene.value(tests::kDepth), strokes.comparison().strokes[1].numbers->largest_at_mm);
}

TEST_F(StrokesPanelTest, WithoutAStrokeAButtonLeadsToRecording) {
  show();
  auto* const way_out = part<QPushButton>("strokes_way_out");
  ASSERT_TRUE(way_out->isVisible());
  QSignalSpy asked(&strokes, &StrokesController::recordRequested);
  way_out->click();
  EXPECT_EQ(asked.count(), 1);
  openStudy();
  ASSERT_TRUE(comesTrue([this] { return strokes.state() == StrokesController::State::kNoStroke; }));
  way_out->click();
  EXPECT_EQ(asked.count(), 2);
}

}  // namespace
}  // namespace tactus::workbench
