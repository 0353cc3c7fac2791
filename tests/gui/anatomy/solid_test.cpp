#include "app/workbench/anatomy/solid.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace tactus::workbench::anatomy {
namespace {

using procedure::Point;

constexpr Frame kAround{-100, -100, 200, 200};
constexpr SolidColors kGray{0xC0C0C0, 0x404040, 1, 1};

std::vector<Point> circle(double radius) {
  std::vector<Point> out;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return out;
}

/// A star around the middle; some corners may lie beyond kAround.
std::vector<Point> star(std::mt19937& random) {
  std::uniform_real_distribution<double> radius(20, 130);
  std::vector<Point> out;
  const int corners = std::uniform_int_distribution(3, 25)(random);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, r = radius(random);
    out.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return out;
}

double highest(const Solid& solid) {
  double out = 0;
  for (const auto& vertex : solid.vertices) out = std::max(out, std::abs(vertex.at.z));
  return out;
}

double volume(const Solid& solid) {
  double out = 0;
  for (const auto& [i, j, k] : solid.triangles) {
    const Spot& a = solid.vertices[i].at;
    const Spot& b = solid.vertices[j].at;
    const Spot& c = solid.vertices[k].at;
    out += (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x)) / 6;
  }
  return out;
}

// u = (r² - x² - y²) / 2 has u_xx + u_yy = -2 and is 0 on the circle: an ellipsoid, 1 / √2 as high as it is wide.
TEST(Solid, ACircleBecomesAFlattenedBall) {
  const Solid ball = solidOf(circle(80), kAround, std::nullopt, 60);
  EXPECT_NEAR(highest(ball), 80 / std::numbers::sqrt2, 0.005 * 80);
  for (const auto& vertex : ball.vertices) {
    const Spot& at = vertex.at;
    EXPECT_NEAR((at.x * at.x + at.y * at.y + 2 * at.z * at.z) / (80 * 80), 1, 0.02);  // a step is 0.03 of the radius
  }
  const double whole = 4.0 / 3 * std::numbers::pi * 80 * 80 * 80 / std::numbers::sqrt2;
  EXPECT_NEAR(volume(ball) / whole, 1, 0.01);
}

// u = r² - y²: a round bar, as broad as it is deep, where it leaves the frame on both sides.
TEST(Solid, AStripThroughTheFrameBecomesARoundBar) {
  const Solid bar = solidOf({{-150, -30}, {150, -30}, {150, 30}, {-150, 30}}, kAround, std::nullopt, 60);
  EXPECT_NEAR(highest(bar), 30, 0.15);
  double left = 0, right = 0;
  for (const auto& vertex : bar.vertices) {
    EXPECT_NEAR(std::hypot(vertex.at.y, vertex.at.z), 30, 0.6) << vertex.at.x;
    left = std::min(left, vertex.at.x);
    right = std::max(right, vertex.at.x);
    // It fades toward the ends alone.
    if (std::abs(vertex.at.x) < 60) {
      EXPECT_EQ(vertex.seen, 1);
    } else if (std::abs(vertex.at.x) == 100) {
      EXPECT_EQ(vertex.seen, 0);
    }
  }
  EXPECT_EQ(left, -100);
  EXPECT_EQ(right, 100);
}

TEST(Solid, TheBreadthIsTheDeclaredOne) { EXPECT_NEAR(highest(solidOf(circle(80), kAround, 155, 40)), 77.5, 1e-9); }

TEST(Solid, AnOutlineAroundTheWholeFrameIsClosedAtIt) {
  const Solid solid = solidOf({{-200, -200}, {200, -200}, {200, 200}, {-200, 200}}, kAround, std::nullopt, 30);
  EXPECT_GT(highest(solid), 50);
  EXPECT_LT(highest(solid), 100);
  for (const auto& vertex : solid.vertices) EXPECT_EQ(vertex.seen, 1);
}

TEST(Solid, WhatEnclosesNothingGivesNothing) {
  EXPECT_TRUE(solidOf({}, kAround, std::nullopt, 30).triangles.empty());
  EXPECT_TRUE(solidOf({{0, 0}, {10, 10}}, kAround, std::nullopt, 30).triangles.empty());
  EXPECT_TRUE(solidOf({{200, 0}, {210, 0}, {205, 9}}, kAround, std::nullopt, 30).triangles.empty());
  EXPECT_TRUE(solidOf({{0, 0}, {50, 0}, {20, 0}}, kAround, std::nullopt, 30).triangles.empty());
}

// Each edge of a triangle runs once the other way, so nothing is open and all faces look outward.
TEST(Solid, AnyOutlineGivesAClosedSurface) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    const std::vector<Point> outline = star(random);
    const int cells = std::uniform_int_distribution(8, 40)(random);
    const Solid solid = solidOf(outline, kAround, round % 2 == 0 ? std::nullopt : std::optional(90.0), cells);
    ASSERT_FALSE(solid.triangles.empty()) << round;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : solid.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_LT(t[i], solid.vertices.size());
        ASSERT_NE(t[i], t[(i + 1) % 3]) << round;
        ++edges[{t[i], t[(i + 1) % 3]}];
      }
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1) << round;
      ASSERT_TRUE(edges.contains({edge.second, edge.first})) << round;
    }
    EXPECT_GT(volume(solid), 0) << round;
    for (const auto& vertex : solid.vertices) {
      const Spot& n = vertex.normal;
      EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1, 1e-9);
      EXPECT_LE(std::abs(vertex.at.x), 100 + 1e-9);
      EXPECT_LE(std::abs(vertex.at.y), 100 + 1e-9);
      EXPECT_TRUE(std::isfinite(vertex.at.z));
    }
  }
}

procedure::Picture picture() {
  const auto read = procedure::readPicture(
      R"(<svg viewBox="0 0 100 50"><path id="way" data-mm="0 20 60" data-across="8 8 0" d="M0 10H50V40"/>)"
      R"(<path id="region_a" d="M0 0H9V9Z"/></svg>)",
      "p.svg", 0, 60, {"a"});
  EXPECT_TRUE(read) << read.error().message();
  return *read;
}

TEST(Solid, TheWayIsWhereThePictureHasIt) {
  const procedure::Picture of = picture();
  for (double mm = -5; mm <= 65; mm += 2.5) {
    const Point flat = procedure::placeAt(of, mm);
    const Spot spot = wayAt(of, mm);
    EXPECT_EQ(spot.x, flat.x);
    EXPECT_EQ(spot.y, flat.y);
    EXPECT_NEAR(spot.z, mm <= 20 ? 8 : mm >= 60 ? 0 : 8 * (60 - mm) / 40, 1e-12) << mm;
    // From the side it is that of the picture, moved and made larger.
    const Spot seen = Projection({}, {50, 25, 0}, 3, 400, 300)(spot);
    EXPECT_NEAR(seen.x, 400 + 3 * (flat.x - 50), 1e-9);
    EXPECT_NEAR(seen.y, 300 + 3 * (flat.y - 25), 1e-9);
  }
  const auto between = wayBetween(of, 10, 30);
  ASSERT_EQ(between.size(), 3);
  EXPECT_EQ(between[1].x, 50);
  EXPECT_EQ(between[1].y, 10);
}

TEST(Projection, ShowsTheFront) {
  const Spot nose{-10, 2, 0}, side{0, 2, 7};  // of a body that looks to the left
  const Projection left(frontTurn(procedure::FrontSide::kLeft), {}, 1, 0, 0);
  EXPECT_NEAR(left(nose).x, 0, 1e-12);
  EXPECT_NEAR(left(nose).y, 2, 1e-12);
  EXPECT_NEAR(left(nose).z, 10, 1e-12);  // toward the viewer
  EXPECT_NEAR(left(side).x, 7, 1e-12);
  const Projection right(frontTurn(procedure::FrontSide::kRight), {}, 1, 0, 0);
  EXPECT_NEAR(right(nose).z, -10, 1e-12);
  EXPECT_NEAR(right(side).x, -7, 1e-12);
  const Projection top(frontTurn(procedure::FrontSide::kTop), {}, 1, 0, 0);
  EXPECT_NEAR(top({3, -10, 7}).x, 3, 1e-12);
  EXPECT_NEAR(top({3, -10, 7}).y, 7, 1e-12);
  EXPECT_NEAR(top({3, -10, 7}).z, 10, 1e-12);
  const Projection bottom(frontTurn(procedure::FrontSide::kBottom), {}, 1, 0, 0);
  EXPECT_NEAR(bottom({3, -10, 7}).z, -10, 1e-12);
}

TEST(Projection, KeepsLengthsAndSides) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-50, 50), degrees(-720, 720);
  for (int round = 0; round < 200; ++round) {
    const Projection turned({degrees(random), degrees(random)}, {}, 1, 0, 0);
    const Spot a{any(random), any(random), any(random)};
    const Spot t = turned.turned(a);
    EXPECT_NEAR(std::hypot(t.x, t.y, t.z), std::hypot(a.x, a.y, a.z), 1e-9);
    const Spot x = turned.turned({1, 0, 0}), y = turned.turned({0, 1, 0}), z = turned.turned({0, 0, 1});
    EXPECT_NEAR(x.y * y.z - x.z * y.y, z.x, 1e-9);  // x × y = z: turned, not mirrored
  }
}

TEST(SolidDrawing, AWholeTurnChangesNoPixel) {
  const Solid ball = solidOf(circle(80), kAround, std::nullopt, 40);
  Canvas once(120, 120), again(120, 120);
  drawSolid(once, ball, Projection({33, 20}, {}, 0.5, 60, 60), kGray);
  drawSolid(again, ball, Projection({33 + 360, 20 - 720}, {}, 0.5, 60, 60), kGray);
  EXPECT_EQ(once.pixels, again.pixels);
}

TEST(SolidDrawing, FillsWhatTheOutlineEncloses) {
  const Solid ball = solidOf(circle(80), kAround, std::nullopt, 60);
  Canvas canvas(200, 200);
  const auto contour = drawSolid(canvas, ball, Projection({}, {}, 1, 100, 100), kGray);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const double distance = std::hypot(x + 0.5 - 100, y + 0.5 - 100);
      const std::uint32_t pixel = canvas.pixels[static_cast<std::size_t>(200 * y + x)];
      if (distance < 78.5) {
        EXPECT_EQ(pixel >> 24U, 255U) << x << " " << y;
      } else if (distance > 81) {
        EXPECT_EQ(pixel, 0U) << x << " " << y;
      }
    }
  }
  ASSERT_GT(contour.size(), 100);
  for (const ContourLine& piece : contour) EXPECT_NEAR(std::hypot(piece.x1 - 100, piece.y1 - 100), 80, 1.5);
  // The light comes from the upper left.
  EXPECT_GT(canvas.pixels[200 * 60 + 60] & 0xFFU, canvas.pixels[200 * 140 + 140] & 0xFFU);
}

TEST(SolidDrawing, BeyondTheCanvasNothingIsDrawn) {
  const Solid ball = solidOf(circle(80), kAround, std::nullopt, 20);
  Canvas canvas(10, 10);
  drawSolid(canvas, ball, Projection({}, {}, 1, 500, 500), kGray);
  EXPECT_EQ(*std::max_element(canvas.pixels.begin(), canvas.pixels.end()), 0U);
  drawSolid(canvas, ball, Projection({}, {}, 20, 5, 5), kGray);
  EXPECT_EQ(*std::min_element(canvas.pixels.begin(), canvas.pixels.end()) >> 24U, 255U);
}

// Half opaque gray over half opaque gray: 3/4 opaque.
TEST(SolidDrawing, WhatIsDrawnLaterLiesOver) {
  const Solid ball = solidOf(circle(80), kAround, std::nullopt, 20);
  Canvas canvas(20, 20);
  const SolidColors half{0x808080, 0x808080, 0.5, 0.5};
  const Projection projection({}, {}, 1, 10, 10);
  drawSolid(canvas, ball, projection, half);
  EXPECT_NEAR(canvas.pixels[210] >> 24U, 127.5, 3);  // 64 steps of opacity
  drawSolid(canvas, ball, projection, half);
  EXPECT_NEAR(canvas.pixels[210] >> 24U, 191, 4);
}

// Each channel by itself: half of the color, then half of what was there as well.
TEST(SolidDrawing, KeepsTheColorOfWhatLiesUnder) {
  const Solid ball = solidOf(circle(80), kAround, std::nullopt, 20);
  Canvas canvas(20, 20);
  const SolidColors half{0x8040C0, 0x8040C0, 0.5, 0.5};
  const Projection projection({}, {}, 1, 10, 10);
  for (const double share : {0.5, 0.75, 0.875}) {
    drawSolid(canvas, ball, projection, half);
    const std::uint32_t pixel = canvas.pixels[210];
    EXPECT_NEAR((pixel >> 16U) & 0xFFU, share * 0x80, 4);
    EXPECT_NEAR((pixel >> 8U) & 0xFFU, share * 0x40, 4);
    EXPECT_NEAR(pixel & 0xFFU, share * 0xC0, 4);
  }
}

}  // namespace
}  // namespace tactus::workbench::anatomy
