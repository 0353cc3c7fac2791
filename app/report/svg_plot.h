// Plots as SVG drawings: axes, lines with gaps, areas, scatter, bars, bands, legend.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactus::report {

// Round numbers for the axes of a plot.

/// Ticks inside [min, max] at multiples of 1, 2 or 5 times a power of ten: about `count` of them, at least 2, because
/// one tick gives no scale. min < max, both finite.
std::vector<double> niceTicks(double min, double max, int count);

/// The texts of `ticks`, all with the same number of decimals: the fewest that make them distinct.
std::vector<std::string> tickTexts(const std::vector<double>& ticks);

// Small pieces of SVG: coordinates, paths, text.

/// A point on the drawing, in user units (pixels at natural size), y downward.
struct SvgPoint {
  double x = 0;
  double y = 0;
};

/// `value` with at most two decimals and no trailing zeros.
std::string coordinate(double value);

/// `name="value"` with a space before it, the value escaped.
std::string attribute(std::string_view name, std::string_view value);
std::string attribute(std::string_view name, double value);

/// Path data of a polyline, `M` and `L`; `closed` adds `Z`.
std::string pathData(const std::vector<SvgPoint>& points, bool closed = false);

enum class TextAnchor { kStart, kMiddle, kEnd };

/// The style of a text.
struct TextStyle {
  TextAnchor anchor = TextAnchor::kStart;
  std::string_view color = {};  ///< empty: ink
  double size = 13;
  bool bold = false;
  bool halo = false;        ///< a white outline, for text over lines
  double rotation_deg = 0;  ///< about its anchor, clockwise
};

std::string svgText(SvgPoint at, std::string_view text, const TextStyle& style);
std::string svgLine(SvgPoint from, SvgPoint to, std::string_view color, double width);

/// The word SIMULATED with its right end at `end`, in a color that stands out on screen and paper.
std::string simulatedMark(SvgPoint end);

/// Approximate width of `text` at a font size, in the same unit. Slightly too large, for a wide sans-serif font.
double textWidth(std::string_view text, double size);

/// Start tag of a drawing with title and description for screen readers. The caller adds `</svg>`.
std::string svgStart(double width, double height, std::string_view title, std::string_view description);

/// A point of a series; a point without a value is a gap in the line.
struct SeriesPoint {
  double x = 0;
  std::optional<double> y;
};
using Series = std::vector<SeriesPoint>;

/// One axis, from `min` to `max` (min < max).
struct PlotAxis {
  std::string label;  ///< with the unit, e.g. `Depth (mm)`
  double min = 0;
  double max = 1;
  std::vector<double> ticks = {};  ///< empty: round numbers, as many as the length allows
};

/// The common parts of every plot. Sizes in pixels at natural size; the drawing scales.
struct PlotFrame {
  std::string title;             ///< for screen readers; not drawn
  std::string description = {};  ///< for screen readers
  double width = 440;
  double height = 280;  ///< without the legend, whose rows are added above
  PlotAxis x;
  PlotAxis y;
  bool simulated = false;  ///< writes SIMULATED into the picture
};

enum class Dash { kSolid, kDashed, kDotted, kDashDot };

/// The style of a line.
struct LineLook {
  std::string_view color;
  double width = 2;
  Dash dash = Dash::kSolid;
};

/// Collects elements and returns the drawing. Elements are drawn in the order of the calls, bands first, and clipped at
/// the axes. Elements with a name appear in the legend above the plot, in the same order.
class SvgPlot {
 public:
  explicit SvgPlot(PlotFrame frame);

  /// A line through `points`. Each part between gaps is a subpath; a single point is a dot.
  SvgPlot& line(const Series& points, const LineLook& look, std::string_view name = {});
  /// The area between `points` and y = 0.
  SvgPlot& area(const Series& points, std::string_view color, double opacity, std::string_view name = {});
  /// The area between two series with the same places; a gap in one of them is a gap.
  SvgPlot& between(const Series& low, const Series& high, std::string_view color, double opacity,
                   std::string_view name = {});
  SvgPlot& scatter(const Series& points, std::string_view color, double radius, std::string_view name = {});
  /// Bars from 0: bar i from edges[i] to edges[i + 1], edges.size() = heights.size() + 1.
  SvgPlot& bars(const std::vector<double>& edges, const std::vector<double>& heights, std::string_view color,
                std::string_view name = {});
  /// A vertical line across the plot, with a text at its upper end.
  SvgPlot& verticalRule(double x, const LineLook& look, std::string_view text = {});
  /// A shaded range of the x axis, with `text` at its upper end if it fits, otherwise `short_text`.
  SvgPlot& band(double x0, double x1, std::string_view color, double opacity, std::string_view text,
                std::string_view short_text = {});
  /// A text at a point of the plot.
  SvgPlot& label(double x, double y, std::string_view text, std::string_view color,
                 TextAnchor anchor = TextAnchor::kMiddle);

  /// The drawing, one `<svg>` element.
  std::string svg() const;

 private:
  struct LegendEntry {
    std::string name;
    std::string swatch;  ///< with its left end at (0, 0)
  };

  SvgPoint place(double x, double y) const;
  /// The points in drawing coordinates, split at missing values.
  std::vector<std::vector<SvgPoint>> stretches(const Series& points) const;
  void addLegend(std::string_view name, std::string swatch);
  std::string axes() const;
  std::string legend() const;
  /// The start of each legend entry, in rows as wide as the plot; y counts rows.
  std::vector<SvgPoint> legendPlaces() const;
  double legendHeight() const;

  PlotFrame frame_;
  std::vector<double> x_ticks_, y_ticks_;
  double left_ = 0;         ///< left margin for the texts of the y axis
  double inner_width_ = 0;  ///< width of the plot area; contents are drawn with its upper left corner at (0, 0)
  double inner_height_ = 0;
  std::string bands_;
  std::string content_;
  std::string texts_;
  std::vector<LegendEntry> legend_;
};

}  // namespace tactus::report
