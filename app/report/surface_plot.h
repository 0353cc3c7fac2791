// A surface z(x, y) as an SVG drawing: shaded quads seen obliquely from above, axes, color scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/svg_plot.h"

namespace tactus::report {

/// A surface on a grid. `z[i * y.size() + j]` belongs to (x[i], y[j]). A missing value is a hole in the surface.
struct SurfaceGrid {
  std::vector<double> x;  ///< ascending, inside the x axis, at least 2
  std::vector<double> y;  ///< ascending, inside the y axis, at least 2
  std::vector<std::optional<double>> z;
};

struct SurfaceFrame {
  std::string title;
  std::string description = {};
  double width = 900;
  double height = 540;
  PlotAxis x;              ///< runs to the lower right
  PlotAxis y;              ///< runs to the upper right, into the picture
  PlotAxis z;              ///< upward; also the range of the colors
  bool simulated = false;  ///< writes SIMULATED into the picture
};

/// The drawing, one `<svg>` element.
std::string surfacePlot(const SurfaceFrame& frame, const SurfaceGrid& grid);

}  // namespace tactus::report
