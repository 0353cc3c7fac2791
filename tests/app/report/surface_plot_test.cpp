#include "app/report/surface_plot.h"

#include <gtest/gtest.h>

#include "tests/support/well_formed.h"

namespace tactus::report {
namespace {

SurfaceFrame surfaceFrame() {
  return {.title = "Surface",
          .x = {.label = "x", .min = 0, .max = 3},
          .y = {.label = "y", .min = 0, .max = 2},
          .z = {.label = "z", .min = 0, .max = 1}};
}

SurfaceGrid grid() {
  SurfaceGrid out{.x = {0, 1, 2, 3}, .y = {0, 1, 2}, .z = {}};
  for (std::size_t i = 0; i < 12; ++i) out.z.push_back(0.05 * static_cast<double>(i));
  return out;
}

std::size_t quadsIn(const std::string& svg) { return support::countOf(svg, "stroke-width=\"0.6\"/>"); }

TEST(SurfacePlot, DrawsEveryQuad) {
  const std::string svg = surfacePlot(surfaceFrame(), grid());
  EXPECT_EQ(support::markupFault(svg), "");
  EXPECT_EQ(quadsIn(svg), 6U);  // 3 by 2
}

TEST(SurfacePlot, AHoleLeavesOutTheQuadsAroundIt) {
  SurfaceGrid holed = grid();
  holed.z[1 * 3 + 1] = std::nullopt;  // x = 1, y = 1 touches four of the six
  EXPECT_EQ(quadsIn(surfacePlot(surfaceFrame(), holed)), 2U);
}

}  // namespace
}  // namespace tactus::report
