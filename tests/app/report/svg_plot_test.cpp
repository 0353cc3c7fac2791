#include "app/report/svg_plot.h"

#include <gtest/gtest.h>

#include "app/report/palette.h"

#include "tests/support/well_formed.h"

namespace tactus::report {
namespace {

using support::countOf;
using support::markupFault;

PlotFrame frame() {
  return {.title = "Force & depth",
          .description = "a < b",
          .x = {.label = "x", .min = 0, .max = 10},
          .y = {.label = "y (N)"}};
}

/// The data of the paths drawn in `color`.
std::string pathsIn(const std::string& svg, const std::string& color) {
  std::string data;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    const std::string tag = svg.substr(at, svg.find("/>", at) - at);
    if (tag.find("stroke=\"" + color + '"') == std::string::npos) continue;
    const std::size_t begin = tag.find(" d=\"") + 4;
    data += tag.substr(begin, tag.find('"', begin) - begin);
  }
  return data;
}

TEST(SvgPlot, SaysThatItsDataAreSimulated) {
  PlotFrame marked = frame();
  EXPECT_EQ(countOf(SvgPlot(marked).svg(), "SIMULATED"), 0U);
  marked.simulated = true;
  const std::string svg = SvgPlot(marked).line({{0, 0.1}, {10, 0.9}}, {.color = kBlue}).svg();
  EXPECT_EQ(countOf(svg, ">SIMULATED</text>"), 1U);
  EXPECT_EQ(markupFault(svg), "");
}

// From (0, .2) over (10, .4) along the lower series and back along the upper one; a gap in either is a gap.
TEST(SvgPlot, FillsBetweenTwoSeries) {
  PlotFrame plain{.title = "",
                  .width = 400,
                  .height = 256,
                  .x = {.label = "", .min = 0, .max = 10},
                  .y = {.label = "", .min = 0, .max = 1}};
  const auto paths = [&](const Series& low, const Series& high) {
    const std::string svg = SvgPlot(plain).between(low, high, "#123456", 0.5).svg();
    const std::size_t fill = svg.find(" fill=\"#123456\"");
    const std::size_t begin = svg.rfind(" d=\"", fill) + 4;
    return svg.substr(begin, svg.find('"', begin) - begin);
  };
  const std::string whole = paths({{0, 0.2}, {10, 0.4}}, {{0, 0.6}, {10, 0.8}});
  EXPECT_EQ(countOf(whole, "M"), 1U);
  EXPECT_EQ(countOf(whole, "L"), 3U);
  EXPECT_EQ(countOf(whole, "Z"), 1U);
  const std::string gap =
      paths({{0, 0.2}, {2, 0.2}, {4, {}}, {6, 0.2}, {8, 0.2}}, {{0, 0.6}, {2, 0.6}, {4, 0.6}, {6, 0.6}, {8, 0.6}});
  EXPECT_EQ(countOf(gap, "Z"), 2U);
}

TEST(SvgPlot, IsWellFormedAndSaysWhatItShows) {
  const std::string svg = SvgPlot(frame()).line({{0, 0.1}, {10, 0.9}}, {.color = kBlue}, "S1 < S2").svg();
  EXPECT_EQ(markupFault(svg), "");
  EXPECT_NE(svg.find("<title>Force &amp; depth</title><desc>a &lt; b</desc>"), std::string::npos);
  EXPECT_NE(svg.find(">S1 &lt; S2</text>"), std::string::npos);
  EXPECT_NE(svg.find("viewBox=\"0 0 440 "), std::string::npos);
}

TEST(SvgPlot, AGapEndsTheSubpath) {
  const Series series = {{0, 0.1}, {2, 0.2}, {4, std::nullopt}, {6, 0.3}, {8, 0.4}};
  const std::string svg = SvgPlot(frame()).line(series, {.color = "#123456"}).svg();
  const std::string data = pathsIn(svg, "#123456");
  EXPECT_EQ(countOf(data, "M"), 2U);
  EXPECT_EQ(countOf(data, "L"), 2U);
}

TEST(SvgPlot, APointBetweenGapsIsADot) {
  const std::string svg =
      SvgPlot(frame()).line({{0, std::nullopt}, {2, 0.5}, {4, std::nullopt}}, {.color = "#123456"}).svg();
  EXPECT_EQ(countOf(svg, "<circle"), 1U);
  EXPECT_EQ(pathsIn(svg, "#123456"), "");
}

TEST(SvgPlot, AreasBarsScatterAndBandsAreWellFormed) {
  SvgPlot plot(frame());
  plot.band(0, 4, kSky, 0.5, "A long name of a region", "LN").band(4, 10, kSky, 0, "Short");
  plot.area({{0, 0.0}, {5, 1.0}, {6, std::nullopt}, {7, 0.2}, {8, 0.3}}, kGreen, 0.2, "area");
  plot.bars({0, 1, 2, 3}, {0.5, 0, 0.25}, kOrange, "bars").scatter({{1, 0.2}, {2, std::nullopt}}, kPurple, 3, "dots");
  plot.verticalRule(5, {.color = kInk, .dash = Dash::kDotted}, "here").label(3, 0.5, "label", kInk);
  const std::string svg = plot.svg();
  EXPECT_EQ(markupFault(svg), "");
  EXPECT_EQ(countOf(svg, "fill=\"#E69F00\""), 3U);  // two bars above 0 and the swatch
  EXPECT_NE(svg.find(">Short</text>"), std::string::npos);
}

TEST(SvgPlot, ABandWithoutRoomShowsItsShortName) {
  SvgPlot plot(frame());
  plot.band(0, 0.5, kSky, 0.5, "Laryngopharynx", "LP");
  EXPECT_NE(plot.svg().find(">LP</text>"), std::string::npos);
  EXPECT_EQ(plot.svg().find("Laryngopharynx"), std::string::npos);
}

}  // namespace
}  // namespace tactus::report
