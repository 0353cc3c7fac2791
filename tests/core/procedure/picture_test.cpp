#include <cmath>
#include <gtest/gtest.h>

#include "core/procedure/procedure.h"

namespace tactus::procedure {
namespace {

const std::string kRegion = R"(<path id="region_a" d="M0 0H10V10Z"/>)";

std::string svg(const std::string& inside) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50">)" + inside + "</svg>";
}

std::string refusal(const std::string& inside) {
  const auto read = readPicture(svg(inside), "p.svg", 0, 60, {"a"});
  return read ? "" : read.error().message();
}

TEST(Picture, TheWayIsDividedEvenly) {
  const auto read = readPicture(svg(R"(<path id="way" d="M0 0 L30 0 l0 30"/>)" + kRegion), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->way_mm, (std::vector<double>{0, 30, 60}));
  EXPECT_EQ(read->way[2].x, 30);
  EXPECT_EQ(read->way[2].y, 30);
  EXPECT_EQ(read->width, 100);
  EXPECT_EQ(read->regions.at("a"), "M0 0H10V10Z");
}

TEST(Picture, TheNodesHaveTheirPlaces) {
  const auto read =
      readPicture(svg(R"(<path id="way" data-mm="0 50 60" d="M0,0 10-0 10 10"/>)" + kRegion), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->way_mm, (std::vector<double>{0, 50, 60}));
}

// A circle of radius 10 as four cubics is as long as 2 pi r to 3e-4 of it (kappa 0.5523).
TEST(Picture, CurvesHaveTheirLength) {
  const double k = 5.522847498;
  const auto number = [](double value) { return std::to_string(value) + " "; };
  const std::string d = "M10 0C10 " + number(k) + number(k) + "10 0 10S-10 " + number(k) + "-10 0 " + "-" + number(k) +
                        "-10 0 -10 10 " + "-" + number(k) + "10 0";
  const auto read = readPicture(svg("<path id='way' d='" + d + "'/>" + kRegion), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(read) << read.error().message();
  double length = 0;
  for (std::size_t i = 1; i < read->way.size(); ++i)
    length += std::hypot(read->way[i].x - read->way[i - 1].x, read->way[i].y - read->way[i - 1].y);
  EXPECT_NEAR(length, 20 * 3.14159265, 0.1);
  for (std::size_t i = 1; i < read->way_mm.size(); ++i) EXPECT_GT(read->way_mm[i], read->way_mm[i - 1]);
}

TEST(Picture, RelativeAndAbsoluteNumbersGiveTheSameWay) {
  const auto absolute = readPicture(svg(R"(<path id="way" d="M5 5C5 10 10 10 10 5Q15 0 20 5T30 5H40V20"/>)" + kRegion),
                                    "p.svg", 0, 60, {"a"});
  const auto relative =
      readPicture(svg(R"(<path id="way" d="m5 5c0 5 5 5 5 0q5-5 10 0t10 0h10v15"/>)" + kRegion), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(absolute && relative);
  ASSERT_EQ(absolute->way.size(), relative->way.size());
  for (std::size_t i = 0; i < absolute->way.size(); ++i) {
    EXPECT_NEAR(absolute->way[i].x, relative->way[i].x, 1e-12);
    EXPECT_NEAR(absolute->way[i].y, relative->way[i].y, 1e-12);
  }
}

TEST(Picture, WhatCouldRunOrLoadIsRefused) {
  const std::string way = R"(<path id="way" d="M0 0L1 1"/>)" + kRegion;
  for (const std::string bad :
       {"<script>alert(1)</script>", R"-(<g onload="x()"/>)-", R"(<image href="file:///etc/passwd"/>)",
        R"(<use xlink:href="other.svg#a"/>)", "<foreignObject/>", R"-(<rect style="fill: url(http://x/y)"/>)-",
        "<style>@import 'x.css';</style>", R"-(<a href="javascript:x()"/>)-"}) {
    EXPECT_NE(refusal(way + bad), "") << bad;
  }
  EXPECT_NE(readPicture("<!DOCTYPE svg [<!ENTITY x 'y'>]>" + svg(way), "p.svg", 0, 60, {"a"}).has_value(), true);
  EXPECT_EQ(refusal(way + R"-(<rect fill="url(#shade)"/><use href="#way"/>)-"), "");
}

TEST(Picture, TheWholeBodyMayHaveAnOutline) {
  const std::string way = R"(<path id="way" data-across="4 0 -2" d="M0 0H30V30"/>)" + kRegion;
  const auto without = readPicture(svg(way), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(without) << without.error().message();
  EXPECT_TRUE(without->outline.empty());
  EXPECT_EQ(without->way_across, (std::vector<double>{4, 0, -2}));
  const auto with =
      readPicture(svg(way + R"(<path id="outline" data-breadth="70" data-front="top" d="M10 10H90V120H10Z"/>)"),
                  "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(with) << with.error().message();
  ASSERT_EQ(with->outline.size(), 4);
  EXPECT_EQ(with->outline[2].y, 120);  // beyond the view box, where it is cut
  EXPECT_EQ(with->breadth, 70);
  EXPECT_EQ(with->front, FrontSide::kTop);
  const auto plain = readPicture(svg(way + R"(<path id="outline" d="M10 10H90V40H10Z"/>)"), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(plain) << plain.error().message();
  EXPECT_EQ(plain->breadth, std::nullopt);
  EXPECT_EQ(plain->front, FrontSide::kLeft);
}

TEST(Picture, AnOutlineThatIsNoneIsRefused) {
  const std::string way = R"(<path id="way" d="M0 0L1 1"/>)" + kRegion;
  EXPECT_EQ(refusal(way + R"(<g id="outline"/>)"),
            "p.svg: path 'outline': found an element 'g', wanted a path with its 'd'");
  for (const std::string d : {"M0 0H50", "M200 0H300V50Z", "M1 1H3V3Z"}) {
    EXPECT_EQ(refusal(way + "<path id='outline' d='" + d + "'/>"),
              "p.svg: path 'outline': found a line that encloses less than a hundredth of the picture, wanted the "
              "outline of the whole body");
  }
  for (const std::string breadth : {"0", "-5", "wide", "1e9", ""}) {
    EXPECT_EQ(refusal(way + "<path id='outline' data-breadth='" + breadth + "' d='M0 0H90V40Z'/>"),
              "p.svg: data-breadth of the path 'outline': found '" + breadth +
                  "', wanted how broad the body is at its broadest, in the units of the picture");
  }
  EXPECT_EQ(refusal(way + R"(<path id="outline" data-front="up" d="M0 0H90V40Z"/>)"),
            "p.svg: data-front of the path 'outline': found 'up', wanted 'left', 'right', 'top' or 'bottom'");
  EXPECT_EQ(refusal(R"(<path id="way" data-across="1" d="M0 0L1 1"/>)" + kRegion),
            "p.svg: data-across of the path 'way': found '1', wanted 2 numbers, one for each node of the path");
}

TEST(Picture, TheWayMayEndBeforeTheUniverse) {
  const auto read = readPicture(svg(R"(<path id="way" data-mm="0 50" d="M0 0H10"/>)" + kRegion), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(placeAt(*read, 25).x, 5);
  EXPECT_EQ(placeAt(*read, 60).x, 10);
}

TEST(Picture, TheToolMayHaveAnApproachAndTheQuestionsANearPart) {
  const std::string way = R"(<path id="way" d="M10 10H90"/>)" + kRegion;
  const auto plain = readPicture(svg(way), "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(plain) << plain.error().message();
  EXPECT_TRUE(plain->approach.empty());
  EXPECT_FALSE(plain->near);
  const std::string near = R"(<svg viewBox="0 0 100 50" data-near="5 5 40 30">)";
  const auto read =
      readPicture(near + R"(<path id="approach" d="M0 0L10 10"/>)" + way + "</svg>", "p.svg", 0, 60, {"a"});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->approach.size(), 2U);
  ASSERT_TRUE(read->near);
  EXPECT_EQ(read->near->left, 5);
  EXPECT_EQ(read->near->width, 40);
  EXPECT_EQ(refusal(R"(<path id="approach" d="M0 0L30 10"/>)" + way),
            "p.svg: path 'approach': found a line that ends at 30 10, wanted one that ends where the way begins, 10 "
            "10");
  EXPECT_EQ(readPicture(R"(<svg viewBox="0 0 100 50" data-near="5 5 0 30">)" + way + "</svg>", "p.svg", 0, 60, {"a"})
                .error()
                .message(),
            "p.svg: data-near: found '5 5 0 30', wanted four numbers: left, top, width, height of a part of the "
            "picture");
}

TEST(Picture, WhatIsMissingIsNamed) {
  EXPECT_EQ(refusal(kRegion), "p.svg: path 'way': found no element with this id, wanted a path");
  EXPECT_EQ(refusal(R"(<path id="way" d="M0 0L1 1"/>)"),
            "p.svg: path 'region_a': found no element with this id, wanted a path");
  EXPECT_EQ(refusal(R"-(<g transform="scale(2)"><path id="way" d="M0 0L1 1"/></g>)-" + kRegion),
            "p.svg: path 'way': found a path that is moved by a 'transform', wanted a path whose numbers are those of "
            "the view box");
  EXPECT_EQ(refusal(R"(<path id="way" d="M0 0A5 5 0 0 1 9 9"/>)" + kRegion),
            "p.svg: path 'way': found 'M0 0A5 5 0 0 1 9 9', wanted one line of moves, lines and curves (M, L, H, V, C, "
            "S, Q, T, Z), no arcs");
  EXPECT_EQ(refusal(R"(<path id="way" data-mm="0 61" d="M0 0L1 1"/>)" + kRegion),
            "p.svg: data-mm of the path 'way': found '0 61', wanted 2 rising numbers from 0 to at most 60, one for "
            "each node of the path");
  EXPECT_EQ(readPicture("<html/>", "p.svg", 0, 60, {}).error().message(),
            "p.svg: found no element svg, wanted an SVG picture");
  EXPECT_FALSE(readPicture("", "p.svg", 0, 60, {}));
  EXPECT_FALSE(readPicture("<svg viewBox='0 0 1 1'><path", "p.svg", 0, 60, {}));
}

}  // namespace
}  // namespace tactus::procedure
