#include "app/workbench/anatomy/anatomy_view.h"

#include <QImage>
#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/anatomy/anatomy_drawing.h"
#include "app/workbench/anatomy/inset_view.h"

namespace tactus::workbench::anatomy {
namespace {

QImage pictureOf(AnatomyView& view) { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

QPoint pixelOf(const QPointF& at, const QRectF& frame, const QSize& size) {
  return {static_cast<int>((at.x() - frame.x()) / frame.width() * size.width()),
          static_cast<int>((at.y() - frame.y()) / frame.height() * size.height())};
}

// In the oropharynx, beside the way of the tube.
constexpr QPointF kBesideTheTube(84, 50);

// Amber below the drawing, which is a light blue there.
bool isLit(const QColor& color) { return color.red() - color.blue() > 80; }

TEST(AnatomyView, LightsTheRegionAndOnlyIt) {
  AnatomyView view;
  view.resize(400, 500);
  const QPoint place =
      pixelOf(kBesideTheTube, frameOf(Framing::kHeadAndNeck, Posture::kUpright, view.size()), view.size());
  EXPECT_FALSE(isLit(pictureOf(view).pixelColor(place)));
  view.light(Region::kOropharynx, {});
  EXPECT_TRUE(isLit(pictureOf(view).pixelColor(place)));
  view.light(Region::kNasopharynx, {});
  EXPECT_FALSE(isLit(pictureOf(view).pixelColor(place)));
}

TEST(AnatomyView, LightsAPartOfARegion) {
  AnatomyView view;
  view.resize(400, 500);
  const QPoint place =
      pixelOf(kBesideTheTube, frameOf(Framing::kHeadAndNeck, Posture::kUpright, view.size()), view.size());
  view.light(LitRange{125, 145, {}});  // depth 135 is at y 50
  EXPECT_TRUE(isLit(pictureOf(view).pixelColor(place)));
  view.light(LitRange{140, 160, {}});
  EXPECT_FALSE(isLit(pictureOf(view).pixelColor(place)));
}

TEST(AnatomyView, TheTipIsWhereTheDepthSaysInEveryPosture) {
  constexpr QColor kTube(0x0B, 0x65, 0x9E);
  for (const Posture posture : {Posture::kUpright, Posture::kHalfFlexed, Posture::kChinOnChest}) {
    AnatomyView view;
    view.resize(400, 500);
    view.setPosture(posture);
    view.setDepth(118);
    const TubeWay way(drawnFlexionDeg(posture));
    const QPoint tip = pixelOf(way.placeAt(118), frameOf(Framing::kHeadAndNeck, posture, view.size()), view.size());
    const QImage picture = pictureOf(view);
    EXPECT_EQ(picture.pixelColor(tip), kTube);
    EXPECT_EQ(picture.pixelColor(tip + QPoint(5, 0)), kTube) << "10 px wide";
    EXPECT_EQ(picture.pixelColor(tip - QPoint(5, 0)), kTube) << "10 px wide";
  }
}

TEST(AnatomyView, MirrorsThePicture) {
  AnatomyView view;
  view.resize(400, 500);
  view.setDepth(60);
  const QImage right_handed = pictureOf(view);
  view.setMirrored(true);
  const QImage mirrored = pictureOf(view).mirrored(true, false);
  int different = 0;
  for (int y = 10; y < 490; ++y) {
    for (int x = 10; x < 390; ++x) {
      const QColor a = right_handed.pixelColor(x, y);
      const QColor b = mirrored.pixelColor(x, y);
      // Smoothed edges fall on other sides of a pixel.
      if (std::abs(a.red() - b.red()) > 60 || std::abs(a.blue() - b.blue()) > 60) ++different;
    }
  }
  EXPECT_LT(different, 400);
}

TEST(AnatomyView, TheFrameHoldsTheWholePartInEveryShape) {
  for (const QSizeF size : {QSizeF(400, 500), QSizeF(900, 300), QSizeF(200, 700)}) {
    const QRectF frame = frameOf(Framing::kHeadAndNeck, Posture::kUpright, size);
    EXPECT_TRUE(frame.contains(QRectF(-42, -66, 200, 250)));
    EXPECT_NEAR(frame.width() / frame.height(), size.width() / size.height(), 1e-9);
  }
}

TEST(AnatomyView, TheThroatFillsItsFrameInEveryPosture) {
  for (const Posture posture : {Posture::kUpright, Posture::kHalfFlexed, Posture::kChinOnChest}) {
    const QRectF frame = frameOf(Framing::kThroat, posture, {400, 300});
    const TubeWay way(drawnFlexionDeg(posture));
    for (const double depth_mm : {0.0, 35.0, 92.0, 132.0, 175.0, 200.0})
      EXPECT_TRUE(frame.contains(way.placeAt(depth_mm))) << depth_mm << ' ' << static_cast<int>(posture);
    EXPECT_LT(frame.height(), 215);  // mm; head and neck take 250
  }
}

TEST(AnatomyDrawing, KeepsItsPixmaps) {
  AnatomyDrawing drawing;
  const QPixmap first = drawing.pixmap(Posture::kUpright, Framing::kWhole, {200, 300}, 2);
  EXPECT_EQ(first.size(), QSize(400, 600));
  EXPECT_EQ(drawing.pixmap(Posture::kUpright, Framing::kWhole, {200, 300}, 2).cacheKey(), first.cacheKey());
  EXPECT_NE(drawing.pixmap(Posture::kHalfFlexed, Framing::kWhole, {200, 300}, 2).cacheKey(), first.cacheKey());
}

TEST(AnatomyDrawing, TheTubeRunsThroughTheRegions) {
  const TubeWay way(0);
  for (const Region region : kRegions) {
    const double inside_mm = beginMm(region) + 15;
    EXPECT_TRUE(outlineOf(region, Posture::kUpright).contains(way.placeAt(inside_mm))) << idOf(region);
  }
}

TEST(InsetView, ShowsTheStomachOnThePatientsLeft) {
  constexpr QColor kStomach(0xE8, 0xA5, 0x96);
  InsetView view(Inset::kFront);
  view.resize(560, 392);  // twice as wide as the drawing: it stays in the middle
  const QImage picture = view.grab().toImage();
  // The drawing is seen from the front, so the patient's left is on the right; 1 px is 1 mm, the middle is x = 0.
  EXPECT_EQ(picture.pixelColor(280 + 80, 300), kStomach);
  EXPECT_NE(picture.pixelColor(280 - 80, 300), kStomach);
}

}  // namespace
}  // namespace tactus::workbench::anatomy
