#include "app/workbench/help/tour.h"

#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/features/features.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/workbench.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

TEST(TourCardPlace, IsBesideWhatItSpeaksOf) {
  const QSize window(1000, 600);
  const QSize card(200, 100);
  EXPECT_EQ(cardPlace(window, {0, 50, 400, 400}, card), QRect(408, 50, 200, 100));
  EXPECT_EQ(cardPlace(window, {500, 50, 500, 400}, card), QRect(292, 50, 200, 100));
  EXPECT_EQ(cardPlace(window, {0, 8, 1000, 300}, card), QRect(8, 316, 200, 100));
  EXPECT_EQ(cardPlace(window, {0, 560, 1000, 40}, card), QRect(8, 452, 200, 100));
  // No room beside it: in its corner, where it hides least.
  EXPECT_EQ(cardPlace(window, {0, 0, 1000, 600}, card), QRect(792, 492, 200, 100));
}

class TourTest : public tests::ShownBench {
 protected:
  TourTest() : ShownBench(Stage::kUnderstand) {}
  Tour& tour() { return bench.help->tour(); }
  QRect inWindow(const QWidget& widget) { return {widget.mapTo(&bench.window, QPoint(0, 0)), widget.size()}; }
};

TEST_F(TourTest, EachStepShowsItsPanelAndStaysInTheWindow) {
  bench.help->startTour();
  ASSERT_TRUE(tour().isRunning());
  for (int step = 0; step < tour().steps(); ++step) {
    ASSERT_EQ(tour().step(), step);
    QCoreApplication::processEvents();
    EXPECT_TRUE(tour().card().isVisible());
    EXPECT_TRUE(tour().frame().isVisible()) << step;
    EXPECT_TRUE(bench.window.rect().contains(inWindow(tour().card()))) << step;
    tour().goTo(step + 1);
  }
  EXPECT_FALSE(tour().isRunning());
  EXPECT_FALSE(tour().card().isVisible());
  EXPECT_EQ(bench.window.stage(), Stage::kDeliver);
}

TEST_F(TourTest, KeysGoThroughIt) {
  bench.help->startTour();
  QTest::keyClick(&tour().card(), Qt::Key_Right);
  QTest::keyClick(&tour().card(), Qt::Key_Right);
  EXPECT_EQ(tour().step(), 2);
  QTest::keyClick(&tour().card(), Qt::Key_Left);
  EXPECT_EQ(tour().step(), 1);
  QTest::keyClick(&tour().card(), Qt::Key_Escape);
  EXPECT_FALSE(tour().isRunning());
}

}  // namespace
}  // namespace tactus::workbench
