#include <QTransform>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/plot/label_layout.h"
#include "app/workbench/understand/map/surface_picture.h"

namespace tactus::workbench {
namespace {

const fuzzy::Variable kAxisDepth = {"depth", "Insertion depth", "mm", 0, 600, {}};
const fuzzy::Variable kAxisSpeed = {"speed", "Insertion speed", "mm/s", 0, 400, {}};
const fuzzy::Variable kAxisForce = {"force", "Insertion force", "N", 0, 1.1, {}};

SurfaceAxes axesAt(double azimuth, double elevation, const QRectF& bounds, bool depth_on_y = false) {
  const SurfaceProjection seen({azimuth, elevation}, bounds.adjusted(50, 45, -30, -50));
  return depth_on_y ? surfaceAxes(seen, kAxisSpeed, kAxisDepth, kAxisForce, theme::smallFont(), bounds)
                    : surfaceAxes(seen, kAxisDepth, kAxisSpeed, kAxisForce, theme::smallFont(), bounds);
}

std::vector<SurfaceText> allTexts(const SurfaceAxes& axes) {
  std::vector<SurfaceText> texts = axes.numbers;
  texts.insert(texts.end(), axes.names.begin(), axes.names.end());
  texts.insert(texts.end(), axes.landmarks.begin(), axes.landmarks.end());
  return texts;
}

bool has(const std::vector<SurfaceText>& texts, const char* text) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const SurfaceText& other) { return other.text == QLatin1String(text); });
}

// Independent of the code: the polygons of Qt.
bool polygonsOverlap(const TurnedBox& one, const TurnedBox& other) {
  const auto shape = [](const TurnedBox& box) {
    QTransform turn;
    turn.translate(box.middle.x(), box.middle.y());
    turn.rotate(box.angle_deg);
    const QSizeF size = box.size - QSizeF(0.1, 0.1);
    return turn.map(QPolygonF(QRectF(-size.width() / 2, -size.height() / 2, size.width(), size.height())));
  };
  return shape(one).intersects(shape(other));
}

TEST(SurfaceAxes, NoTextOverlapsAnotherFromAnyAngle) {
  for (const QRectF bounds : {QRectF(0, 0, 420, 300), QRectF(0, 0, 900, 500)}) {
    for (int azimuth = -180; azimuth < 180; azimuth += 24) {
      for (int elevation = -90; elevation <= 90; elevation += 20) {
        const auto texts = allTexts(axesAt(azimuth, elevation, bounds, azimuth % 48 == 0));
        for (std::size_t i = 0; i < texts.size(); ++i) {
          for (const QPointF& corner : texts[i].box.corners()) ASSERT_TRUE(bounds.contains(corner));
          for (std::size_t j = 0; j < i; ++j) {
            ASSERT_FALSE(polygonsOverlap(texts[i].box, texts[j].box))
                << texts[i].text.toStdString() << " and " << texts[j].text.toStdString() << " at " << azimuth << ", "
                << elevation;
          }
        }
      }
    }
  }
}

TEST(SurfaceAxes, TheStandardViewNamesEverything) {
  const SurfaceAngles standard;
  const SurfaceAxes axes = axesAt(standard.azimuth_deg, standard.elevation_deg, QRectF(0, 0, 700, 450));
  for (const char* name : {"Insertion depth (mm)", "Insertion speed (mm/s)", "Insertion force (N)"}) {
    EXPECT_TRUE(has(axes.names, name)) << name;
  }
  for (const char* number : {"0", "600", "400", "1.1"}) EXPECT_TRUE(has(axes.numbers, number)) << number;
  for (const char* landmark : {"Turbinate", "Bend", "Epiglottis", "Arytenoids", "Upper sphincter", "Lower sphincter"}) {
    EXPECT_TRUE(has(axes.landmarks, landmark)) << landmark;
  }
  EXPECT_EQ(axes.landmark_bars.size(), 6);
}

TEST(SurfaceAxes, EachAxisHasItsNameUnlessItPointsAtTheViewer) {
  const QRectF bounds(0, 0, 600, 420);
  for (int azimuth = -170; azimuth < 180; azimuth += 20) {
    EXPECT_EQ(axesAt(azimuth, 30, bounds).names.size(), 3U) << azimuth;
  }
  // From the front y points at the viewer, from above the force.
  const SurfaceAxes front = axesAt(0, 0, bounds);
  EXPECT_FALSE(has(front.names, "Insertion speed (mm/s)"));
  EXPECT_EQ(front.names.size(), 2U);
  EXPECT_FALSE(has(axesAt(30, 90, bounds).names, "Insertion force (N)"));
}

TEST(SurfaceAxes, NamesAreNeverUpsideDown) {
  for (int azimuth = -180; azimuth < 180; azimuth += 15) {
    for (const SurfaceText& name : axesAt(azimuth, 35, QRectF(0, 0, 600, 420)).names) {
      EXPECT_GE(name.box.angle_deg, -90.1);
      EXPECT_LE(name.box.angle_deg, 90);
    }
  }
}

TEST(SurfaceAxes, LandmarksFollowTheDepthToTheOtherAxis) {
  EXPECT_EQ(axesAt(32, 30, QRectF(0, 0, 700, 450), true).landmark_bars.size(), 6);
  const SurfaceProjection seen({32, 30}, QRectF(50, 50, 500, 300));
  EXPECT_TRUE(surfaceAxes(seen, kAxisSpeed, kAxisSpeed, kAxisForce, theme::smallFont(), QRectF(0, 0, 600, 400))
                  .landmarks.empty());
}

TEST(SurfaceAxes, TheWallsAreBehind) {
  // The viewer at high x and low y, above: the walls are at low x, high y and the floor.
  const BoxPoint far = farCorner(SurfaceProjection({32, 30}, QRectF(0, 0, 100, 100)));
  EXPECT_EQ(far.x, 0);
  EXPECT_EQ(far.y, 1);
  EXPECT_EQ(far.z, 0);
  EXPECT_EQ(farCorner(SurfaceProjection({32, -30}, QRectF(0, 0, 100, 100))).z, 1);
}

TEST(UniverseTicks, AreRoundAndHaveBothEnds) {
  EXPECT_EQ(universeTicks(0, 600, 6), (std::vector<double>{0, 100, 200, 300, 400, 500, 600}));
  EXPECT_EQ(universeTicks(0, 400, 1), (std::vector<double>{0, 400}));
  // 1 is too near to 1.1.
  const std::vector<double> force = universeTicks(0, 1.1, 5);
  ASSERT_EQ(force.size(), 6U);
  EXPECT_NEAR(force[4], 0.8, 1e-12);
  EXPECT_EQ(force[5], 1.1);
}

TEST(LabelBoard, TurnedBoxesOverlapWhereTheirShapesDo) {
  // Two thin bars that cross, and the same ones beside each other; their bounding rectangles overlap in both cases.
  const TurnedBox bar{{0, 0}, {100, 4}, 45};
  EXPECT_TRUE(overlap(bar, {{0, 0}, {100, 4}, -45}));
  EXPECT_FALSE(overlap(bar, {{10, -10}, {100, 4}, 45}));
  EXPECT_TRUE(overlap(bar, {{30, 30}, {2, 2}, 0}));
  EXPECT_FALSE(overlap(bar, {{30, -30}, {2, 2}, 0}));
  LabelBoard board(QRectF(0, 0, 100, 100));
  EXPECT_FALSE(board.place({{5, 5}, {20, 4}, 0}));  // beyond the edge
  EXPECT_TRUE(board.place({{50, 50}, {20, 4}, 0}));
  EXPECT_FALSE(board.place({{55, 51}, {20, 4}, 0}));
}

}  // namespace
}  // namespace tactus::workbench
