#include "app/workbench/labs/speed/speed_lab_view.h"

#include <QLabel>
#include <QSlider>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <semaphore>
#include <stop_token>

#include "app/workbench/base/theme.h"
#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/speed/cluster_page.h"
#include "app/workbench/labs/speed/speed_lab.h"
#include "app/workbench/labs/speed/trace_row.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class SpeedLabViewTest : public testing::Test {
 protected:
  void SetUp() override {
    study.open(tests::demoStudyIn(folder));
    screen.addLab(QStringLiteral("Speed"), view, &corrections);
    screen.resize(1100, 640);
    screen.show();
    ASSERT_TRUE(comesTrue([this] { return lab.result() != nullptr; }));
  }
  std::size_t samplesOf(std::size_t subject) const { return lab.result()->subjects[subject]->speeds.samples; }
  void drag(QWidget& row, QPointF from, double by) {
    QTest::mousePress(&row, Qt::LeftButton, {}, from.toPoint());
    // QTest::mouseMove tells no button.
    const QPointF to = from + QPointF(by, 0);
    QMouseEvent move(QEvent::MouseMove, to, row.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&row, &move);
    QTest::mouseRelease(&row, Qt::LeftButton, {}, to.toPoint());
  }

  QTemporaryDir folder;
  StudyConnection study;
  LabData data{study};
  Corrections corrections{data};
  LabModel model{data};
  SettingsPrice price{data};
  SpeedLab lab{data};
  LabScreen screen{data};
  SpeedLabView* view = new SpeedLabView(lab, model, corrections, price);
};

TEST_F(SpeedLabViewTest, ADraggedMarkIsACorrectionAndCtrlZBringsTheOldOneBack) {
  view->pages().setCurrentWidget(&view->strokes());
  TraceRow& row = *view->strokes().rows().front();  // S1, fast
  ASSERT_TRUE(comesTrue([&] { return row.accessibleName().contains(QStringLiteral("S1")) && row.hasStrokes(); }));
  const std::size_t before = samplesOf(0);
  drag(row, row.markPlace(1, true), 12);
  ASSERT_TRUE(comesTrue([&] { return lab.result() && samplesOf(0) != before; }));
  EXPECT_LT(samplesOf(0), before);
  EXPECT_TRUE(corrections.canUndo());
  QTest::keyClick(&screen, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(comesTrue([&] { return samplesOf(0) == before; }));
  EXPECT_FALSE(corrections.canUndo());
}

TEST_F(SpeedLabViewTest, OneClickOnAStrokeTellsWhatItMoves) {
  view->pages().setCurrentWidget(&view->strokes());
  TraceRow& row = *view->strokes().rows().front();  // S1, fast
  ASSERT_TRUE(comesTrue([&] { return row.accessibleName().contains(QStringLiteral("S1")) && row.hasStrokes(); }));
  const QPointF inside = (row.markPlace(2, true) + row.markPlace(2, false)) / 2;
  QTest::mouseClick(&row, Qt::LeftButton, {}, inside.toPoint());
  const StrokeInfluence& influence = view->strokes().influence();
  ASSERT_TRUE(influence.asked());
  EXPECT_EQ(*influence.asked(), (elicitation::StrokeKey{"S1", "fast", 3}));
  ASSERT_TRUE(comesTrue([&] { return influence.sentence().contains(QStringLiteral(" rms")); }));
  EXPECT_TRUE(influence.sentence().contains(QStringLiteral("S1")));
  EXPECT_FALSE(corrections.canUndo()) << "a click corrects nothing";
}

// Two heads side by side must not touch at 1280 px, whatever the codes of the participants are.
TEST_F(SpeedLabViewTest, ALongCodeMakesRoomForTheWarningsBesideIt) {
  SpeedSubject subject = *lab.result()->subjects.front();
  subject.speeds.participant = "earnest-sailboat-of-the-surgical-ward";
  subject.speeds.diagnostics.warnings = {"The levels are hardly apart."};
  ClusterPlot plot;
  plot.show(subject, lab.result()->speed, 0, {});
  EXPECT_LE(plot.minimumSizeHint().width(), 200);
}

TEST_F(SpeedLabViewTest, PlotsSideBySideHaveARoomBetweenThem) {
  std::vector<QRect> places;
  ASSERT_TRUE(comesTrue([&] {
    places.clear();
    for (const ClusterPlot* plot : view->findChildren<ClusterPlot*>()) {
      if (plot->isVisible()) places.push_back(plot->geometry());
    }
    return places.size() == 4;
  }));
  EXPECT_GE(places[1].left() - places[0].right(), theme::kGrid);
  EXPECT_GE(places[2].top() - places[0].bottom(), theme::kGrid / 2);
}

TEST_F(SpeedLabViewTest, ACancelIsSaidByTheLabWhoseWorkItEnded) {
  auto* const work =
      new Computed<LabInputs, int>([this] { return data.inputs(); },
                                   [](const LabInputs&, const RunOf<int>& run) -> Computed<LabInputs, int>::Answer {
                                     std::binary_semaphore stopped{0};
                                     const std::stop_callback on_stop(run.stop, [&stopped] { stopped.release(); });
                                     stopped.acquire();
                                     return nullptr;
                                   },
                                   &screen);
  QObject seen;
  auto* const other = new QWidget;
  screen.addLab(QStringLiteral("Other"), other, nullptr);
  screen.watch(*work, QStringLiteral("Working"));
  const auto says = [this] {
    const auto labels = screen.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
      return label->isVisible() && label->text().startsWith(QStringLiteral("Canceled"));
    });
  };
  work->hold(seen);
  screen.reveal(other);
  work->cancel();
  EXPECT_TRUE(says());
  work->hold(seen, false);
  screen.reveal(view);
  EXPECT_FALSE(says()) << "what is seen is complete";
  work->hold(seen);
  screen.reveal(other);
  EXPECT_TRUE(says());
}

// 20,000 samples at 10 mm/s on some hundred pixels, and one of them at 90 mm/s.
TEST_F(SpeedLabViewTest, ASpikeOfOneSampleIsSeen) {
  auto set = std::make_shared<StrokeSet>();
  StrokeTrace& stroke = set->strokes.emplace_back();
  for (int i = 0; i < 20'000; ++i) {
    stroke.time_s.push_back(i * 1e-3);
    stroke.speed_time_s.push_back(i * 1e-3);
    stroke.speed_mm_s.push_back(i == 12'345 ? 90.0F : 10.0F);
  }
  stroke.record.number = 1;
  stroke.record.last = stroke.time_s.size();
  TraceRow row;
  row.resize(640, 130);
  row.show(QStringLiteral("S1"), Qt::red, set, 100);
  const QImage picture = row.grab().toImage();
  // Red where a rejected stroke would be gray: the record has no verdict, so its line is muted ink over the window.
  int highest = picture.height();
  for (int y = 0; y < picture.height(); ++y) {
    const int x = static_cast<int>(row.markPlace(0, true).x() +
                                   (row.markPlace(0, false).x() - row.markPlace(0, true).x()) * 12'345 / 20'000);
    for (int near = x - 2; near <= x + 2; ++near) {
      const QColor there = picture.pixelColor(near, y);
      const QColor beside = picture.pixelColor(near + 40, y);
      if (there != beside) highest = std::min(highest, y);
    }
  }
  EXPECT_LT(highest, picture.height() / 3);
}

TEST_F(SpeedLabViewTest, ASliderMovesTheTermsAndAHiddenLabComputesNothing) {
  const auto before = lab.result()->averaged;
  const auto sliders = view->findChildren<QSlider*>();
  const auto alpha = std::find_if(sliders.begin(), sliders.end(), [](const QSlider* one) {
    return one->accessibleName().contains(QStringLiteral("α"));
  });
  ASSERT_NE(alpha, sliders.end());
  (*alpha)->setValue((*alpha)->maximum());
  EXPECT_EQ(lab.settings().alpha, 1);
  ASSERT_TRUE(comesTrue([&] { return lab.result()->averaged != before; }));
  EXPECT_EQ(lab.result()->averaged[0].q, lab.result()->averaged[1].p);
  screen.hide();
  lab.setAlpha(0.8);
  EXPECT_FALSE(lab.work().isBusy());
  screen.show();
  EXPECT_TRUE(comesTrue([&] { return lab.result()->averaged[0].q < lab.result()->averaged[1].p; }));
}

}  // namespace
}  // namespace tactus::workbench
