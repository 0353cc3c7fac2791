#include "app/report/surface_plot.h"

#include <algorithm>

#include "app/figures/surface_view.h"
#include "app/report/palette.h"
#include "app/report/svg_plot.h"
#include "core/base/check.h"

namespace tactus::report {

namespace {

using figures::BoxPoint;
using figures::kBox;

// Margins in pixels: texts of the axes left and below, color scale on the right.
constexpr double kLeft = 66, kRight = 104, kTop = 14, kBottom = 50;
constexpr double kScaleWidth = 16;
constexpr double kEdgeTick = 6;
// Mesh lines on the surface, about this many along each input.
constexpr std::size_t kMeshX = 30, kMeshY = 12;

double share(const PlotAxis& axis, double value) { return (value - axis.min) / (axis.max - axis.min); }

/// The box, as large as the drawing allows. The angles are the default ones: neither the rise with the second input nor
/// the profile along the first one hides the other.
class View {
 public:
  explicit View(const SurfaceFrame& frame) {
    const auto extent = seen_.extent();
    const double width = frame.width - kLeft - kRight;
    const double height = frame.height - kTop - kBottom;
    scale_ = std::min(width / extent.x, height / extent.y);
    middle_ = {kLeft + width / 2, kTop + height / 2};
  }

  SvgPoint operator()(const BoxPoint& point) const {
    const auto at = seen_(point);
    return {middle_.x + scale_ * at.x, middle_.y - scale_ * at.y};
  }
  const figures::SurfaceView& seen() const { return seen_; }

 private:
  figures::SurfaceView seen_;
  double scale_ = 1;
  SvgPoint middle_;
};

std::string edge(const View& view, BoxPoint from, BoxPoint to, std::string_view color = kGrid, double width = 1) {
  return svgLine(view(from), view(to), color, width);
}

std::vector<double> ticksOf(const PlotAxis& axis, int count) {
  return axis.ticks.empty() ? niceTicks(axis.min, axis.max, count) : axis.ticks;
}

/// Floor, the two walls behind the surface and their grid.
std::string box(const View& view, const SurfaceFrame& frame) {
  std::string out =
      "<path" + attribute("d", pathData({view({0, 0, 0}), view({1, 0, 0}), view({1, 1, 0}), view({0, 1, 0})}, true)) +
      " fill=\"#F6F8FA\"/>";
  for (const double tick : ticksOf(frame.x, 6)) {
    const double x = share(frame.x, tick);
    out += edge(view, {x, 0, 0}, {x, 1, 0}) + edge(view, {x, 1, 0}, {x, 1, 1});
  }
  for (const double tick : ticksOf(frame.y, 4)) {
    const double y = share(frame.y, tick);
    out += edge(view, {0, y, 0}, {1, y, 0}) + edge(view, {0, y, 0}, {0, y, 1});
  }
  for (const double tick : ticksOf(frame.z, 5)) {
    const double z = share(frame.z, tick);
    out += edge(view, {0, 0, z}, {0, 1, z}) + edge(view, {0, 1, z}, {1, 1, z});
  }
  out += edge(view, {0, 1, 0}, {0, 1, 1}, "#C6CDD5");
  return out;
}

std::string axes(const View& view, const SurfaceFrame& frame) {
  std::string out;
  const auto tick_mark = [&](BoxPoint at, SvgPoint direction, const std::string& text, TextAnchor anchor) {
    const SvgPoint from = view(at);
    const SvgPoint to = {from.x + direction.x * kEdgeTick, from.y + direction.y * kEdgeTick};
    out += svgLine(from, to, kMuted, 1);
    out += svgText({to.x + direction.x * 4, to.y + direction.y * 4 + (direction.y > 0 ? 9 : 4.5)}, text,
                   {.anchor = anchor, .color = kMuted});
  };
  const auto texts = [](const std::vector<double>& ticks) { return tickTexts(ticks); };
  const std::vector<double> x_ticks = ticksOf(frame.x, 6);
  for (std::size_t i = 0; i < x_ticks.size(); ++i) {
    tick_mark({share(frame.x, x_ticks[i]), 0, 0}, {-0.5, 0.85}, texts(x_ticks)[i], TextAnchor::kEnd);
  }
  const std::vector<double> y_ticks = ticksOf(frame.y, 4);
  for (std::size_t i = 0; i < y_ticks.size(); ++i) {
    tick_mark({1, share(frame.y, y_ticks[i]), 0}, {0.85, 0.5}, texts(y_ticks)[i], TextAnchor::kStart);
  }
  const std::vector<double> z_ticks = ticksOf(frame.z, 5);
  for (std::size_t i = 0; i < z_ticks.size(); ++i) {
    tick_mark({0, 0, share(frame.z, z_ticks[i])}, {-1, 0}, texts(z_ticks)[i], TextAnchor::kEnd);
  }
  out += edge(view, {0, 0, 0}, {1, 0, 0}, kMuted) + edge(view, {1, 0, 0}, {1, 1, 0}, kMuted) +
         edge(view, {0, 0, 0}, {0, 0, 1}, kMuted);
  const SvgPoint x_middle = view({0.5, 0, 0});
  out += svgText({x_middle.x - 46, x_middle.y + 46}, frame.x.label, {.anchor = TextAnchor::kMiddle});
  const SvgPoint y_middle = view({1, 0.5, 0});
  out += svgText({y_middle.x + 40, y_middle.y + 30}, frame.y.label, {.anchor = TextAnchor::kStart});
  const SvgPoint z_middle = view({0, 0, 0.5});
  out += svgText({z_middle.x - 46, z_middle.y}, frame.z.label, {.anchor = TextAnchor::kMiddle, .rotation_deg = -90});
  return out;
}

/// The bar that says which color means which value.
std::string colorScale(const SurfaceFrame& frame) {
  constexpr int kSteps = 48;
  const double left = frame.width - kRight + 52;
  const double top = kTop + 34;
  const double height = std::min(220.0, frame.height - kTop - kBottom - 60);
  std::string out = svgText({left + kScaleWidth / 2, top - 14}, frame.z.label, {.anchor = TextAnchor::kMiddle});
  for (int i = 0; i < kSteps; ++i) {
    out += "<rect" + attribute("x", left) + attribute("y", top + height * (kSteps - 1 - i) / kSteps) +
           attribute("width", kScaleWidth) + attribute("height", height / kSteps + 0.5) +
           attribute("fill", scaleColor((i + 0.5) / kSteps)) + "/>";
  }
  const std::vector<double> ticks = ticksOf(frame.z, 5);
  const std::vector<std::string> texts = tickTexts(ticks);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double y = top + height * (1 - share(frame.z, ticks[i]));
    out += svgLine({left + kScaleWidth, y}, {left + kScaleWidth + 4, y}, kMuted, 1);
    out += svgText({left + kScaleWidth + 7, y + 4.5}, texts[i], {.color = kMuted});
  }
  return out;
}

}  // namespace

std::string surfacePlot(const SurfaceFrame& frame, const SurfaceGrid& grid) {
  const std::size_t rows = grid.x.size();
  const std::size_t columns = grid.y.size();
  TACTUS_CHECK(rows >= 2 && columns >= 2 && grid.z.size() == rows * columns);
  const View view(frame);
  std::string out = svgStart(frame.width, frame.height, frame.title, frame.description);
  out += box(view, frame) + "<g stroke-linejoin=\"round\">";
  const std::size_t mesh_x = std::max<std::size_t>(1, (rows - 1) / kMeshX);
  const std::size_t mesh_y = std::max<std::size_t>(1, (columns - 1) / kMeshY);
  const auto value = [&](std::size_t i, std::size_t j) { return grid.z[i * columns + j]; };
  const auto corner = [&](std::size_t i, std::size_t j) {
    return BoxPoint{share(frame.x, grid.x[i]), share(frame.y, grid.y[j]), share(frame.z, *value(i, j))};
  };
  // Painter's order: the viewer stands at large x and small y, so the farthest quads come first.
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = columns - 1; j-- > 0;) {
      if (!value(i, j) || !value(i + 1, j) || !value(i, j + 1) || !value(i + 1, j + 1)) continue;
      const BoxPoint a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
      const double rise_x = (b.z + c.z - a.z - d.z) / 2 * kBox.z / ((b.x - a.x) * kBox.x);
      const double rise_y = (c.z + d.z - a.z - b.z) / 2 * kBox.z / ((d.y - a.y) * kBox.y);
      const std::string color =
          scaleColor((a.z + b.z + c.z + d.z) / 4, brightness(figures::normalOf(rise_x, rise_y), view.seen()));
      // The outline in the same color closes the hairlines between neighbors.
      out += "<path" + attribute("d", pathData({view(a), view(b), view(c), view(d)}, true)) + attribute("fill", color) +
             attribute("stroke", color) + " stroke-width=\"0.6\"/>";
      std::string mesh;
      if (i % mesh_x == 0) mesh += pathData({view(a), view(d)});
      if (j % mesh_y == 0) mesh += pathData({view(a), view(b)});
      if (i + 2 == rows) mesh += pathData({view(b), view(c)});
      if (!mesh.empty()) {
        out +=
            "<path" + attribute("d", mesh) + R"( fill="none" stroke="#000" stroke-opacity="0.28" stroke-width="0.7"/>)";
      }
    }
  }
  out += "</g>" + axes(view, frame) + colorScale(frame);
  if (frame.simulated) out += simulatedMark({frame.width - 2, frame.height - 7});
  return out + "</svg>";
}

}  // namespace tactus::report
