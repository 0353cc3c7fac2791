// The picture of a pack, at the example of the nasogastric tube: three poses of the neck, near and whole.
#include <QImage>
#include <QTest>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/anatomy/body_view.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench::anatomy {
namespace {

const procedure::Procedure& ngt() { return *procedure::defaultProcedure(); }

std::unique_ptr<BodyView> body() {
  std::unique_ptr<BodyView> view(makeBodyView(procedure::defaultProcedure(), nullptr));
  view->resize(400, 500);
  return view;
}

QImage pictureOf(BodyView& view) { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }

/// Where the point of the picture lies in the view, whose frame is `box` extended to its shape.
QPoint pixelOf(const procedure::Point& at, const procedure::Box& box, const QSize& size) {
  const double scale = std::min(size.width() / box.width, size.height() / box.height);
  return {static_cast<int>(size.width() / 2.0 + (at.x - box.left - box.width / 2) * scale),
          static_cast<int>(size.height() / 2.0 + (at.y - box.top - box.height / 2) * scale)};
}

study::ItemCondition neck(const char* word) { return {"neck_flexion", word}; }

// In the oropharynx, beside the way of the tube.
constexpr procedure::Point kBesideTheTube{84, 50};

// Amber below the drawing, which is a light blue there.
bool isLit(const QColor& color) { return color.red() - color.blue() > 80; }

TEST(PictureView, LightsTheRegionAndOnlyIt) {
  const auto view = body();
  const QPoint place = pixelOf(kBesideTheTube, *ngt().pictures[0].near, view->size());
  EXPECT_FALSE(isLit(pictureOf(*view).pixelColor(place)));
  view->lightRegion(QStringLiteral("oropharynx"));
  EXPECT_TRUE(isLit(pictureOf(*view).pixelColor(place)));
  view->lightRegion(QStringLiteral("nasopharynx"));
  EXPECT_FALSE(isLit(pictureOf(*view).pixelColor(place)));
}

TEST(PictureView, LightsAPartOfARegion) {
  const auto view = body();
  const QPoint place = pixelOf(kBesideTheTube, *ngt().pictures[0].near, view->size());
  view->light(LitRange{125, 145, {}});  // depth 135 is at y 50
  EXPECT_TRUE(isLit(pictureOf(*view).pixelColor(place)));
  view->light(LitRange{140, 160, {}});
  EXPECT_FALSE(isLit(pictureOf(*view).pixelColor(place)));
}

TEST(PictureView, TheTipIsWhereTheDepthSaysInEveryPose) {
  constexpr QColor kTool(0x0B, 0x65, 0x9E);
  for (const procedure::Picture& picture : ngt().pictures) {
    const auto view = body();
    view->setPose(picture.pose);
    EXPECT_EQ(view->pose(), picture.pose);
    view->setDepth(118);
    const QPoint tip = pixelOf(procedure::placeAt(picture, 118), *picture.near, view->size());
    const QImage drawn = pictureOf(*view);
    EXPECT_EQ(drawn.pixelColor(tip), kTool) << picture.file;
    EXPECT_EQ(drawn.pixelColor(tip + QPoint(3, 0)), kTool) << picture.file;
    EXPECT_EQ(drawn.pixelColor(tip - QPoint(3, 0)), kTool) << picture.file;
  }
}

// The esophagus and the stomach lie outside the near part.
TEST(PictureView, ShowsTheWholeBodyForWhatLiesFar) {
  const procedure::Picture& picture = ngt().pictures[0];
  const auto view = body();
  view->setDepth(430);
  const procedure::Box whole{picture.left, picture.top, picture.width, picture.height};
  const QPoint tip = pixelOf(procedure::placeAt(picture, 430), whole, view->size());
  bool found = false;
  const QImage drawn = pictureOf(*view);
  for (int dy = -12; dy <= 12; ++dy) found = found || drawn.pixelColor(tip + QPoint(0, dy)) == QColor(0x0B, 0x65, 0x9E);
  EXPECT_TRUE(found) << "the frame has a margin of 3 %";
  view->setDepth(std::nullopt);
  const QImage near = pictureOf(*view);
  view->lightRegion(QStringLiteral("stomach"));
  view->lightRegion({});
  EXPECT_EQ(pictureOf(*view), near);
}

TEST(PictureView, TurnsGentlyWhileItIsSeenAndAtOnceOtherwise) {
  const auto view = body();
  view->setDepth(118);
  view->setPose(neck("large"), true);
  const QImage large = pictureOf(*view);
  view->setPose(neck("small"));
  const QImage small = pictureOf(*view);
  EXPECT_NE(large, small);
  view->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(view.get()));
  view->setPose(neck("large"), true);
  EXPECT_NE(pictureOf(*view), large);
  EXPECT_TRUE(QTest::qWaitFor([&] { return pictureOf(*view) == large; }, 10'000));
}

TEST(PictureView, MirrorsThePicture) {
  const auto view = body();
  view->setDepth(60);
  const QImage right_handed = pictureOf(*view);
  view->setMirrored(true);
  const QImage mirrored = pictureOf(*view).mirrored(true, false);
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

TEST(InsetView, ShowsTheStomachOnThePatientsLeft) {
  constexpr QColor kStomach(0xE8, 0xA5, 0x96);
  InsetView view(QByteArray::fromStdString(ngt().files.at("pictures/front.svg")));
  view.resize(560, 392);  // twice as wide as the drawing: it stays in the middle
  const QImage picture = view.grab().toImage();
  // The drawing is seen from the front, so the patient's left is on the right; 1 px is 1 mm, the middle is x = 0.
  EXPECT_EQ(picture.pixelColor(280 + 80, 300), kStomach);
  EXPECT_NE(picture.pixelColor(280 - 80, 300), kStomach);
}

}  // namespace
}  // namespace tactus::workbench::anatomy
