#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/anatomy/anatomy.h"

namespace tactus::workbench::anatomy {
namespace {

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

struct Landmark {
  double depth_mm;
  QPointF at;
};

// Measured along the tube of the drawing by another program, given to 0.1 mm.
TEST(TubeWay, TheLengthFromTheNostrilIsTheDepth) {
  const Landmark table[] = {{0, {0, 0}},         {20, {16.3, -7.8}},    {64, {60, -2.3}},    {70, {65.9, -1.5}},
                            {94, {85.6, 10}},    {115, {90.1, 30.4}},   {120, {90.1, 35.4}}, {150, {90.5, 65.4}},
                            {175, {94.6, 90}},   {200, {102, 113.9}},   {290, {127.5, 200}}, {365, {132.4, 274.6}},
                            {415, {116, 321.5}}, {440, {105.4, 343.9}}, {470, {96.7, 372.5}}};
  const TubeWay way(0);
  for (const Landmark& mark : table) {
    EXPECT_LT(distance(way.placeAt(mark.depth_mm), mark.at), 0.2)
        << mark.depth_mm;  // 0.05 in x, y and depth, and their steps
    // Pieces of half a millimeter on bends of 10 mm and more: 1e-4 of the length.
    EXPECT_NEAR(way.drawnLengthMm(mark.depth_mm), mark.depth_mm, 0.06) << mark.depth_mm;
  }
  EXPECT_NEAR(way.endMm(), 514, 0.5);
}

TEST(TubeWay, ALandmarkKeepsItsDepthAndTheDrawnWayToItGetsShorter) {
  // Soft palate, tip of the epiglottis, cardia: drawn lengths with the neck flexed by 33 and 66 degrees, to 1 mm.
  const struct { double depth_mm, half_mm, chest_mm; } table[] = {{118, 117, 115}, {141, 138, 135}, {436, 427, 419}};
  const TubeWay half(drawnFlexionDeg(Posture::kHalfFlexed));
  const TubeWay chest(drawnFlexionDeg(Posture::kChinOnChest));
  for (const auto& mark : table) {
    EXPECT_NEAR(half.drawnLengthMm(mark.depth_mm), mark.half_mm, 1.5) << mark.depth_mm;
    EXPECT_NEAR(chest.drawnLengthMm(mark.depth_mm), mark.chest_mm, 1.5) << mark.depth_mm;
  }
}

TEST(TubeWay, StaysBetweenItsEnds) {
  const TubeWay way(0);
  EXPECT_EQ(way.placeAt(-1000), QPointF(-70, 52));
  EXPECT_EQ(way.placeAt(1000), QPointF(60, 392));
  const auto points = way.between(70, 115);
  EXPECT_EQ(points.front(), way.placeAt(70));
  EXPECT_EQ(points.back(), way.placeAt(115));
}

TEST(NeckRig, TheTrunkStaysAndTheHeadTurnsByTheWholeAngle) {
  const double flexion = drawnFlexionDeg(Posture::kChinOnChest);
  EXPECT_EQ(posed({80, 260}, Part::kTrunk, flexion), QPointF(80, 260));
  // The floor of the nose, level in the upright head, then points down by 66 degrees: back is up, face down.
  const QPointF front = posed({0, 0}, Part::kHead, flexion);
  const QPointF back = posed({60, 0}, Part::kHead, flexion);
  EXPECT_NEAR(distance(front, back), 60, 1e-9);
  EXPECT_NEAR(std::atan2(front.y() - back.y(), back.x() - front.x()) * 180 / M_PI, 66, 1e-9);
}

// Corners of the drawings, made by another program with the same joints and written with one decimal.
TEST(NeckRig, PointsLieWhereTheDrawingsHaveThem) {
  const struct {
    QPointF upright;
    Part part;
    QPointF half, chest;
  } table[] = {{{85, 56}, Part::kLarynx, {65.4, 69.5}, {50.3, 87.3}},
               {{96.5, 104}, Part::kSoft, {90.5, 109.9}, {85.7, 116.6}},
               {{61, -27}, Part::kHead, {4.6, 16.5}, {-25.3, 77.2}},
               {{-70, 52}, Part::kSoft, {-62.2, 154.1}, {-6.4, 229.0}}};
  for (const auto& corner : table) {
    EXPECT_LT(distance(posed(corner.upright, corner.part, 33), corner.half), 0.08) << corner.half.x();
    EXPECT_LT(distance(posed(corner.upright, corner.part, 66), corner.chest), 0.08) << corner.chest.x();
  }
}

TEST(Region, BeginsWhereTheOneBeforeEnds) {
  EXPECT_FALSE(regionAtDepth(-0.1));
  EXPECT_EQ(regionAtDepth(0), Region::kNasalCavity);
  EXPECT_EQ(regionAtDepth(69.9), Region::kNasalCavity);
  EXPECT_EQ(regionAtDepth(70), Region::kNasopharynx);
  EXPECT_EQ(regionAtDepth(150), Region::kLaryngopharynx);
  EXPECT_EQ(regionAtDepth(600), Region::kStomach);
  for (const Region region : kRegions) EXPECT_EQ(regionWithId(idOf(region)), region);
  EXPECT_FALSE(regionWithId("ear"));
}

TEST(Structure, EveryRegionHasAPlaceForItsName) {
  for (const Region region : kRegions) EXPECT_EQ(structureOf(region).id, idOf(region));
  EXPECT_EQ(structures().size(), 29U);
}

}  // namespace
}  // namespace tactus::workbench::anatomy
