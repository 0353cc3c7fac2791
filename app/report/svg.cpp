#include "app/report/svg.h"

#include <cmath>

#include "app/report/markup.h"
#include "app/report/palette.h"
#include "core/base/text.h"

namespace tactus::report {

std::string coordinate(double value) {
  const double rounded = std::round(value * 100) / 100;
  return base::formatNumber(rounded == 0 ? 0.0 : rounded);
}

std::string attribute(std::string_view name, std::string_view value) {
  std::string out = " ";
  out += name;
  out += "=\"";
  out += base::xmlEscaped(value);
  out += '"';
  return out;
}

std::string attribute(std::string_view name, double value) { return attribute(name, coordinate(value)); }

std::string pathData(const std::vector<SvgPoint>& points, bool closed) {
  std::string out;
  char command = 'M';
  for (const SvgPoint& point : points) {
    out += command;
    out += coordinate(point.x);
    out += ' ';
    out += coordinate(point.y);
    command = 'L';
  }
  if (closed) out += 'Z';
  return out;
}

std::string svgText(SvgPoint at, std::string_view text, const TextStyle& style) {
  std::string out = "<text";
  out += attribute("x", at.x);
  out += attribute("y", at.y);
  if (style.anchor == TextAnchor::kMiddle) out += attribute("text-anchor", "middle");
  if (style.anchor == TextAnchor::kEnd) out += attribute("text-anchor", "end");
  out += attribute("fill", style.color.empty() ? kInk : style.color);
  out += attribute("font-size", style.size);
  if (style.bold) out += attribute("font-weight", "600");
  if (style.halo) out += R"( stroke="#fff" stroke-width="3" stroke-linejoin="round" paint-order="stroke")";
  if (style.rotation_deg != 0) {
    out += attribute("transform", "rotate(" + coordinate(style.rotation_deg) + ' ' + coordinate(at.x) + ' ' +
                                      coordinate(at.y) + ')');
  }
  out += '>';
  out += base::xmlEscaped(text);
  out += "</text>";
  return out;
}

std::string svgLine(SvgPoint from, SvgPoint to, std::string_view color, double width) {
  return "<path" + attribute("d", pathData({from, to})) + attribute("stroke", color) +
         attribute("stroke-width", width) + " fill=\"none\"/>";
}

std::string simulatedMark(SvgPoint end) {
  return svgText(end, "SIMULATED", {.anchor = TextAnchor::kEnd, .color = "#8A4B00", .size = 10.5, .bold = true});
}

double textWidth(std::string_view text, double size) {
  double ems = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80) continue;  // a further byte of a UTF-8 character
    const std::string_view narrow = "iljtfrI.,:;|()' ";
    const std::string_view wide = "mwMWGOQ@%";
    ems += narrow.find(c) != std::string_view::npos ? 0.34 : wide.find(c) != std::string_view::npos ? 0.84 : 0.56;
  }
  return ems * size;
}

std::string svgStart(double width, double height, std::string_view title, std::string_view description) {
  std::string out = R"(<svg xmlns="http://www.w3.org/2000/svg" role="img")";
  out += attribute("viewBox", "0 0 " + coordinate(width) + ' ' + coordinate(height));
  out += attribute("width", width);
  out += attribute("height", height);
  out += R"( font-family="'Segoe UI','Helvetica Neue',Arial,'Liberation Sans',sans-serif" font-size="13">)";
  out += "<title>" + base::xmlEscaped(title) + "</title>";
  if (!description.empty()) out += "<desc>" + base::xmlEscaped(description) + "</desc>";
  return out;
}

}  // namespace tactus::report
