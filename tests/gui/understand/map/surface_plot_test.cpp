#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/understand/map/map_panel.h"
#include "app/workbench/understand/map/map_view_panel.h"

#include "tests/gui/patience.h"
#include "tests/gui/quiet.h"
#include "tests/gui/understand/map/sample_maps.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

const fuzzy::Variable kX = {"lubrication", "X", "1", 0, 1, {}};
const fuzzy::Variable kY = {"speed", "Y", "1", 0, 1, {}};
const fuzzy::Variable kForce = {"force", "Force", "N", 0, 1, {}};

class SurfacePlotTest : public testing::Test {
 protected:
  void SetUp() override {
    plot.resize(640, 420);
    plot.setAxes(kX, kY, kForce);
    plot.show();
  }

  bool rest() {
    return QTest::qWaitFor([this] { return plot.isRested(); }, kPatience);
  }

  SurfaceFrame frame() const { return {kX, kY, kForce, plot.look(), plot.size()}; }
  QPoint at(const BoxPoint& point) const { return frame().projection()(point).toPoint(); }

  SurfacePlot plot;
};

TEST_F(SurfacePlotTest, TheNearHidesTheFarFromEveryAngle) {
  // A high ridge across the middle of x; on both sides a low plain.
  const ForceMap map = tests::sampleMap(201, [](double x, double) { return std::abs(x - 0.5) < 0.06 ? 0.95 : 0.05; });
  plot.setMap(&map);
  for (const double azimuth : {90.0, -90.0, 60.0, -120.0}) {
    SurfaceLook look;
    look.angles = {azimuth, 25};
    plot.setLook(look);
    ASSERT_TRUE(rest());
    const QImage image = plot.grab().toImage();
    const bool from_high_x = azimuth > 0;
    // The foot of the ridge on the near side is seen, that on the far side is not: the flank stands in front of it, the
    // color of which is that of its middle, as green as the ramp gets.
    const QRgb near_plain = image.pixel(at({from_high_x ? 0.8 : 0.2, 0.5, 0.05}));
    const QRgb far_foot = image.pixel(at({from_high_x ? 0.42 : 0.58, 0.5, 0.05}));
    EXPECT_LT(qGreen(near_plain), 85) << azimuth;
    EXPECT_GT(qGreen(far_foot), qGreen(near_plain) + 20) << azimuth;
  }
}

TEST_F(SurfacePlotTest, AFlatSurfaceHasTheColorOfItsForceAndHolesShowTheGround) {
  const ForceMap map =
      tests::sampleMap(201, [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.2 ? -1 : 0.5; });
  plot.setMap(&map);
  SurfaceLook look;
  look.angles = {0, 90};
  plot.setLook(look);
  ASSERT_TRUE(rest());
  const QImage image = plot.grab().toImage();
  // From straight above: the light stands 0.663 toward the viewer, 0.58 + 0.46 * 0.663 = 0.885 of the color. The middle
  // between two mesh lines, which are an 25th apart.
  const QColor expected = forceColor(0.5);
  const QColor seen = image.pixelColor(at({0.18, 0.18, 0.5}));
  EXPECT_NEAR(seen.red(), expected.red() * 0.885, 4);
  EXPECT_NEAR(seen.green(), expected.green() * 0.885, 4);
  EXPECT_NEAR(seen.blue(), expected.blue() * 0.885, 4);
  // The hole: ground and hatching, both nearly gray.
  const QColor hole = image.pixelColor(at({0.5, 0.52, 0.5}));
  EXPECT_LT(std::abs(hole.red() - hole.blue()), 24);
}

TEST_F(SurfacePlotTest, MouseAndKeysTurnAndGoBack) {
  const SurfaceLook standard;
  QTest::mousePress(&plot, Qt::LeftButton, {}, QPoint(300, 200));
  QTest::mouseMove(&plot, QPoint(350, 220));
  QTest::mouseRelease(&plot, Qt::LeftButton, {}, QPoint(350, 220));
  // What is dragged to the right goes to the right: the viewer goes 50 * 0.4 degrees to the left.
  EXPECT_NEAR(plot.look().angles.azimuth_deg, standard.angles.azimuth_deg - 20, 1e-9);
  EXPECT_NEAR(plot.look().angles.elevation_deg, standard.angles.elevation_deg + 8, 1e-9);
  QTest::mouseMove(&plot, QPoint(100, 100));
  EXPECT_NEAR(plot.look().angles.azimuth_deg, standard.angles.azimuth_deg - 20, 1e-9);
  QTest::keyClick(&plot, Qt::Key_Left);
  QTest::keyClick(&plot, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(plot.look().angles.azimuth_deg, standard.angles.azimuth_deg - 18, 1e-9);
  EXPECT_NEAR(plot.look().angles.elevation_deg, standard.angles.elevation_deg + 23, 1e-9);
  for (int i = 0; i < 20; ++i) QTest::keyClick(&plot, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_EQ(plot.look().angles.elevation_deg, 90);
  QTest::keyClick(&plot, Qt::Key_Home);
  EXPECT_EQ(plot.look(), standard);
  QTest::keyClick(&plot, Qt::Key_Right);
  QTest::mouseDClick(&plot, Qt::LeftButton, {}, QPoint(300, 200));
  EXPECT_EQ(plot.look(), standard);
}

TEST_F(SurfacePlotTest, TheWheelZoomsAroundTheMouse) {
  const QPoint mouse = at({0.3, 0.6, 0.2});
  QWheelEvent turn(mouse, plot.mapToGlobal(mouse), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                   false);
  QCoreApplication::sendEvent(&plot, &turn);
  EXPECT_NEAR(plot.look().zoom, 1.15, 1e-9);
  // The place under the mouse has not moved by more than what rounding to pixels takes.
  EXPECT_LE((at({0.3, 0.6, 0.2}) - mouse).manhattanLength(), 2);
  for (int i = 0; i < 50; ++i) QTest::keyClick(&plot, Qt::Key_Plus);
  EXPECT_EQ(plot.look().zoom, 4);
}

TEST_F(SurfacePlotTest, RefinesWhenItRestsAndNotWhileHidden) {
  const ForceMap map = tests::sampleMap(201, [](double x, double y) { return x * y; });
  plot.setMap(&map);
  ASSERT_TRUE(rest());
  EXPECT_EQ(plot.cellsShown(), 200U);
  QTest::keyClick(&plot, Qt::Key_Right);
  EXPECT_FALSE(plot.isRested());
  plot.grab();
  EXPECT_LE(plot.cellsShown(), 200U);
  plot.hide();
  ASSERT_TRUE(QTest::qWaitFor([this] { return tests::isQuiet(plot); }, kPatience));
  EXPECT_FALSE(plot.isRested());
  plot.show();
  EXPECT_TRUE(rest());
}

TEST_F(SurfacePlotTest, AnotherLookIsThatOfAFreshStart) {
  const ForceMap map = tests::sampleMap(51, [](double x, double y) { return x * y > 0.4 ? -1 : x * y; });
  plot.setMap(&map);
  ASSERT_TRUE(rest());
  // The frame of the focus goes from one window to the other.
  const auto seen = [](SurfacePlot& shown) {
    shown.clearFocus();
    return shown.grab().toImage();
  };
  const QImage light = seen(plot);
  const auto change = [this](theme::Look look) {
    theme::changeLook(*qApp, look);
    return QTest::qWaitFor([this] { return !plot.isRested(); }, kPatience) && rest();
  };
  ASSERT_TRUE(change(theme::Look::kDark));
  const QImage dark = seen(plot);
  SurfacePlot fresh;
  fresh.resize(plot.size());
  fresh.setAxes(kX, kY, kForce);
  fresh.show();
  fresh.setMap(&map);
  EXPECT_TRUE(QTest::qWaitFor([&] { return fresh.isRested(); }, kPatience));
  EXPECT_EQ(seen(fresh), dark);
  EXPECT_NE(dark, light);
  ASSERT_TRUE(change(theme::Look::kLight));
  EXPECT_EQ(seen(plot), light);
}

TEST_F(SurfacePlotTest, TheOperatingPointIsMarkedWhereItStands) {
  const ForceMap map = tests::sampleMap(51, [](double, double) { return 0.2; });
  plot.setMap(&map);
  plot.setPoint(0.5, 0.5, 0.2, QStringLiteral("here"));
  ASSERT_TRUE(rest());
  const QColor dot = plot.grab().toImage().pixelColor(at({0.5, 0.5, 0.2}));
  EXPECT_EQ(dot.rgb(), theme::accent().rgb());
}

}  // namespace
}  // namespace tactus::workbench
