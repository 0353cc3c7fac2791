#include <gtest/gtest.h>

#include "app/workbench/tune/terms/term_grip.h"

namespace tactus::workbench {
namespace {

using fuzzy::Shape;
using fuzzy::Term;
using Part = Grip::Part;

// 100 px for 10 mm, 100 px for a membership of 1: 1 mm is 10 px.
const PlotFrame kFrame{QRectF(20, 30, 100, 100), 0, 10, 1};

const std::vector<Term> kTerms = {{"near", "Near", Shape::kTrapezoid, {0, 0, 4, 6}},
                                  {"far", "Far", Shape::kTrapezoid, {4, 6, 10, 10}}};

std::optional<Grip> at(double x_mm, double membership, std::optional<std::size_t> preferred = {},
                       const std::vector<Term>& terms = kTerms, QPointF off = {}) {
  return gripAt(kFrame, terms, kFrame.pixelOf(x_mm, membership) + off, preferred);
}

TEST(GripFinder, PixelsAndValuesAgree) {
  EXPECT_EQ(kFrame.pixelOf(4, 1), QPointF(60, 30));
  EXPECT_EQ(kFrame.pixelOf(10, 0), QPointF(120, 130));
  EXPECT_EQ(kFrame.valueAt(60), 4);
}

TEST(GripFinder, TakesTheVertexWithinReach) {
  EXPECT_EQ(at(4, 1), (Grip{0, Part::kVertex, 2, false}));
  EXPECT_EQ(at(4, 0), (Grip{1, Part::kVertex, 0, false}));
  EXPECT_EQ(at(4, 1, {}, kTerms, {6, -6}), (Grip{0, Part::kVertex, 2, false}));
}

TEST(GripFinder, TakesTheEdgeBetweenItsVertices) {
  EXPECT_EQ(at(4.5, 0.25), (Grip{1, Part::kLeftEdge, 0, false}));
  EXPECT_EQ(at(4.5, 0.75), (Grip{0, Part::kRightEdge, 0, false}));
}

TEST(GripFinder, TakesTheTermInsideItsShape) {
  EXPECT_EQ(at(2, 0.5), (Grip{0, Part::kTerm, 0, false}));
  EXPECT_EQ(at(8, 0.9), (Grip{1, Part::kTerm, 0, false}));
  EXPECT_EQ(at(5, 0.9), std::nullopt);
}

TEST(GripFinder, OfVerticesOnEachOtherTheOneThatIsFreeToMove) {
  const std::vector<Term> triangle_like = {{"t", "T", Shape::kTrapezoid, {2, 5, 5, 8}}};
  EXPECT_EQ(at(5, 1, {}, triangle_like, {-3, 0}), (Grip{0, Part::kVertex, 1, false}));
  EXPECT_EQ(at(5, 1, {}, triangle_like, {3, 0}), (Grip{0, Part::kVertex, 2, false}));
}

TEST(GripFinder, WhatIsSelectedGoesFirst) {
  const std::vector<Term> touching = {{"a", "A", Shape::kTrapezoid, {0, 0, 5, 5}},
                                      {"b", "B", Shape::kTrapezoid, {5, 5, 10, 10}}};
  EXPECT_EQ(at(5, 1, 0, touching)->term, 0U);
  EXPECT_EQ(at(5, 1, 1, touching)->term, 1U);
  EXPECT_EQ(at(5, 1, {}, touching, {-2, 0})->term, 0U);
  EXPECT_EQ(at(5, 1, {}, touching, {2, 0})->term, 1U);
}

TEST(GripFinder, AGaussianHasAPeakAndTwoFlanks) {
  const std::vector<Term> gaussian = {{"g", "G", Shape::kGaussian, {5, 2}}};
  EXPECT_EQ(at(5, 1, {}, gaussian), (Grip{0, Part::kVertex, 0, false}));
  EXPECT_EQ(at(7, 0.6065, {}, gaussian), (Grip{0, Part::kVertex, 1, false}));  // exp(-1/2) one sigma beside the mean
  EXPECT_EQ(at(3, 0.6065, {}, gaussian), (Grip{0, Part::kVertex, 1, true}));
  EXPECT_EQ(at(5, 0.4, {}, gaussian), (Grip{0, Part::kTerm, 0, false}));
}

}  // namespace
}  // namespace tactus::workbench
