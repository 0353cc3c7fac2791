// Small pieces of SVG: coordinates, paths, text.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tactus::report {

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

}  // namespace tactus::report
