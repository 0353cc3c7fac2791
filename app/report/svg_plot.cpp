#include "app/report/svg_plot.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/report/html.h"
#include "app/report/palette.h"
#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::report {
namespace {

// Ends of an axis that miss a multiple of the step by rounding only still get their tick.
constexpr double kSlack = 1e-9;

std::string inFourDigits(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, 4).ptr;
  return {text.begin(), end};
}

}  // namespace

std::vector<double> niceTicks(double min, double max, int count) {
  TACTUS_CHECK(std::isfinite(min) && std::isfinite(max) && min < max && count >= 2);
  const double raw_step = (max - min) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw_step)));
  constexpr std::array<double, 4> kFactors = {1, 2, 5, 10};
  // The factor next to the wanted step, on a logarithmic scale.
  double step = power;
  for (const double factor : kFactors) {
    if (std::abs(std::log(factor * power / raw_step)) < std::abs(std::log(step / raw_step))) step = factor * power;
  }
  std::vector<double> ticks;
  const auto first = static_cast<long long>(std::ceil(min / step - kSlack));
  const auto last = static_cast<long long>(std::floor(max / step + kSlack));
  for (long long k = first; k <= last; ++k) ticks.push_back(static_cast<double>(k) * step);
  if (ticks.size() < 2) return {min, max};
  return ticks;
}

std::vector<std::string> tickTexts(const std::vector<double>& ticks) {
  double smallest_gap = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const double gap = std::abs(ticks[i] - ticks[i - 1]);
    if (gap > 0) smallest_gap = smallest_gap > 0 ? std::min(smallest_gap, gap) : gap;
  }
  // Numbers too long to read have an exponent.
  const auto longest = [](double value) { return std::abs(value) >= 1e9; };
  if (std::any_of(ticks.begin(), ticks.end(), longest) || smallest_gap < 1e-8) {
    std::vector<std::string> texts;
    for (const double tick : ticks) texts.push_back(inFourDigits(std::abs(tick) < smallest_gap * 0.01 ? 0 : tick));
    return texts;
  }
  // The fewest decimals that show every tick to a hundredth of the gap.
  int decimals = 0;
  const auto exact = [&](double value) {
    const double scale = std::pow(10.0, decimals);
    return std::abs(std::round(value * scale) / scale - value) <= smallest_gap * 0.01;
  };
  while (decimals < 9 && !std::all_of(ticks.begin(), ticks.end(), exact)) ++decimals;
  std::vector<std::string> texts;
  for (const double tick : ticks) texts.push_back(base::formatFixed(tick == 0 ? 0.0 : tick, decimals));
  return texts;
}

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

namespace {

// Sizes in pixels at natural size; they set how airy the plots are.
constexpr double kFontSize = 13;
constexpr double kSmallFontSize = 12;
constexpr double kTopMargin = 10;
constexpr double kRightMargin = 14;
constexpr double kTickLength = 5;
constexpr double kXAxisHeight = 46;  // ticks, their texts and the label
constexpr double kLegendRow = 21;
constexpr double kSwatchWidth = 26;
constexpr double kLegendGap = 14;
constexpr double kPixelsPerTickX = 80;
constexpr double kPixelsPerTickY = 44;

std::string_view dashArray(Dash dash) {
  switch (dash) {
    case Dash::kSolid: return "";
    case Dash::kDashed: return "7 4";
    case Dash::kDotted: return "2.5 2.5";
    case Dash::kDashDot: return "8 3.5 1.5 3.5";
  }
  return "";
}

std::string strokeAttributes(const LineLook& look) {
  std::string out = " fill=\"none\"" + attribute("stroke", look.color) + attribute("stroke-width", look.width);
  out += R"( stroke-linejoin="round")";
  if (look.dash != Dash::kSolid) out += attribute("stroke-dasharray", dashArray(look.dash));
  return out;
}

std::string rectangle(SvgPoint corner, double width, double height, std::string_view color, double opacity) {
  return "<rect" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", width) +
         attribute("height", height) + attribute("fill", color) +
         (opacity < 1 ? attribute("fill-opacity", opacity) : std::string()) + "/>";
}

std::string circle(SvgPoint at, double radius, std::string_view color) {
  return "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + attribute("r", radius) + attribute("fill", color) +
         "/>";
}

int tickCount(double length, double per_tick) { return std::max(2, static_cast<int>(length / per_tick)); }

}  // namespace

SvgPlot::SvgPlot(PlotFrame frame) : frame_(std::move(frame)) {
  TACTUS_CHECK(frame_.x.min < frame_.x.max && frame_.y.min < frame_.y.max);
  inner_height_ = frame_.height - kTopMargin - kXAxisHeight;
  y_ticks_ = frame_.y.ticks.empty() ? niceTicks(frame_.y.min, frame_.y.max, tickCount(inner_height_, kPixelsPerTickY))
                                    : frame_.y.ticks;
  double widest = 0;
  for (const std::string& text : tickTexts(y_ticks_)) widest = std::max(widest, textWidth(text, kFontSize));
  left_ = widest + kTickLength + 4 + (frame_.y.label.empty() ? 4 : kFontSize + 10);
  inner_width_ = frame_.width - left_ - kRightMargin;
  TACTUS_CHECK(inner_width_ > 0 && inner_height_ > 0);
  x_ticks_ = frame_.x.ticks.empty() ? niceTicks(frame_.x.min, frame_.x.max, tickCount(inner_width_, kPixelsPerTickX))
                                    : frame_.x.ticks;
}

SvgPoint SvgPlot::place(double x, double y) const {
  return {(x - frame_.x.min) / (frame_.x.max - frame_.x.min) * inner_width_,
          (frame_.y.max - y) / (frame_.y.max - frame_.y.min) * inner_height_};
}

std::vector<std::vector<SvgPoint>> SvgPlot::stretches(const Series& points) const {
  std::vector<std::vector<SvgPoint>> out;
  bool in_gap = true;
  for (const SeriesPoint& point : points) {
    const bool has_value = point.y && std::isfinite(*point.y);
    if (has_value && in_gap) out.emplace_back();
    if (has_value) out.back().push_back(place(point.x, *point.y));
    in_gap = !has_value;
  }
  return out;
}

SvgPlot& SvgPlot::line(const Series& points, const LineLook& look, std::string_view name) {
  std::string data;
  for (const auto& stretch : stretches(points)) {
    if (stretch.size() == 1) {
      content_ += circle(stretch.front(), look.width, look.color);
    } else {
      data += pathData(stretch);
    }
  }
  if (!data.empty()) content_ += "<path" + attribute("d", data) + strokeAttributes(look) + "/>";
  addLegend(name, "<path" + attribute("d", pathData({{0, 0}, {kSwatchWidth, 0}})) + strokeAttributes(look) + "/>");
  return *this;
}

SvgPlot& SvgPlot::area(const Series& points, std::string_view color, double opacity, std::string_view name) {
  std::string data;
  const double base_y = place(0, std::clamp(0.0, frame_.y.min, frame_.y.max)).y;
  for (auto& stretch : stretches(points)) {
    if (stretch.size() < 2) continue;
    stretch.push_back({stretch.back().x, base_y});
    stretch.push_back({stretch.front().x, base_y});
    data += pathData(stretch, true);
  }
  content_ += "<path" + attribute("d", data) + attribute("fill", color) + attribute("fill-opacity", opacity) + "/>";
  addLegend(name, rectangle({4, -6}, kSwatchWidth - 8, 12, color, opacity));
  return *this;
}

SvgPlot& SvgPlot::between(const Series& low, const Series& high, std::string_view color, double opacity,
                          std::string_view name) {
  TACTUS_CHECK(low.size() == high.size());
  std::string data;
  std::vector<SvgPoint> lower;
  std::vector<SvgPoint> upper;
  const auto close = [&] {
    if (lower.size() > 1) {
      lower.insert(lower.end(), upper.rbegin(), upper.rend());
      data += pathData(lower, true);
    }
    lower.clear();
    upper.clear();
  };
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (!low[i].y || !high[i].y) {
      close();
      continue;
    }
    lower.push_back(place(low[i].x, *low[i].y));
    upper.push_back(place(high[i].x, *high[i].y));
  }
  close();
  content_ += "<path" + attribute("d", data) + attribute("fill", color) + attribute("fill-opacity", opacity) + "/>";
  addLegend(name, rectangle({4, -6}, kSwatchWidth - 8, 12, color, opacity));
  return *this;
}

SvgPlot& SvgPlot::scatter(const Series& points, std::string_view color, double radius, std::string_view name) {
  for (const SeriesPoint& point : points) {
    if (point.y && std::isfinite(*point.y)) content_ += circle(place(point.x, *point.y), radius, color);
  }
  addLegend(name, circle({kSwatchWidth / 2, 0}, radius + 1, color));
  return *this;
}

SvgPlot& SvgPlot::bars(const std::vector<double>& edges, const std::vector<double>& heights, std::string_view color,
                       std::string_view name) {
  TACTUS_CHECK(edges.size() == heights.size() + 1);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!(heights[i] > 0)) continue;
    const SvgPoint corner = place(edges[i], heights[i]);
    const SvgPoint foot = place(edges[i + 1], 0);
    // A hairline of white between neighbors, so that bars can be counted.
    content_ += rectangle(corner, std::max(0.5, foot.x - corner.x - 0.6), foot.y - corner.y, color, 1);
  }
  addLegend(name, rectangle({4, -6}, kSwatchWidth - 8, 12, color, 1));
  return *this;
}

SvgPlot& SvgPlot::verticalRule(double x, const LineLook& look, std::string_view text) {
  const SvgPoint top = place(x, frame_.y.max);
  content_ += "<path" + attribute("d", pathData({top, place(x, frame_.y.min)})) + strokeAttributes(look) + "/>";
  if (!text.empty()) {
    // The text stands on the side where there is room.
    const bool right = top.x + textWidth(text, kSmallFontSize) + 8 < inner_width_;
    texts_ += svgText({top.x + (right ? 4 : -4), kSmallFontSize + 1}, text,
                      {.anchor = right ? TextAnchor::kStart : TextAnchor::kEnd,
                       .color = look.color,
                       .size = kSmallFontSize,
                       .halo = true});
  }
  return *this;
}

SvgPlot& SvgPlot::band(double x0, double x1, std::string_view color, double opacity, std::string_view text,
                       std::string_view short_text) {
  const SvgPoint from = place(std::max(x0, frame_.x.min), frame_.y.max);
  const SvgPoint to = place(std::min(x1, frame_.x.max), frame_.y.min);
  const double width = to.x - from.x;
  if (opacity > 0) bands_ += rectangle(from, width, inner_height_, color, opacity);
  const bool fits = textWidth(text, kSmallFontSize) + 6 <= width;
  const std::string_view shown = fits ? text : short_text;
  if (!shown.empty()) {
    texts_ += svgText({from.x + width / 2, kSmallFontSize + 3}, shown,
                      {.anchor = TextAnchor::kMiddle, .color = kMuted, .size = kSmallFontSize});
  }
  return *this;
}

SvgPlot& SvgPlot::label(double x, double y, std::string_view text, std::string_view color, TextAnchor anchor) {
  texts_ += svgText(place(x, y), text,
                    {.anchor = anchor, .color = color, .size = kSmallFontSize, .bold = true, .halo = true});
  return *this;
}

void SvgPlot::addLegend(std::string_view name, std::string swatch) {
  if (!name.empty()) legend_.push_back({std::string(name), std::move(swatch)});
}

std::vector<SvgPoint> SvgPlot::legendPlaces() const {
  std::vector<SvgPoint> places;
  SvgPoint at;
  for (const LegendEntry& entry : legend_) {
    const double width = kSwatchWidth + 6 + textWidth(entry.name, kFontSize);
    if (at.x > 0 && at.x + width > inner_width_) at = {0, at.y + 1};
    places.push_back(at);
    at.x += width + kLegendGap;
  }
  return places;
}

double SvgPlot::legendHeight() const { return legend_.empty() ? 0 : (legendPlaces().back().y + 1) * kLegendRow + 4; }

std::string SvgPlot::legend() const {
  std::string out;
  const std::vector<SvgPoint> places = legendPlaces();
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    const double x = left_ + places[i].x;
    const double middle = 4 + (places[i].y + 0.5) * kLegendRow;
    out += "<g" + attribute("transform", "translate(" + coordinate(x) + ' ' + coordinate(middle) + ')') + '>' +
           legend_[i].swatch + "</g>";
    out += svgText({x + kSwatchWidth + 6, middle + 4.5}, legend_[i].name, {});
  }
  return out;
}

std::string SvgPlot::axes() const {
  std::string out;
  const std::vector<std::string> x_texts = tickTexts(x_ticks_);
  for (std::size_t i = 0; i < x_ticks_.size(); ++i) {
    const double x = place(x_ticks_[i], 0).x;
    out += svgLine({x, inner_height_}, {x, inner_height_ + kTickLength}, kMuted, 1);
    out += svgText({x, inner_height_ + kTickLength + 14}, x_texts[i], {.anchor = TextAnchor::kMiddle, .color = kMuted});
  }
  const std::vector<std::string> y_texts = tickTexts(y_ticks_);
  for (std::size_t i = 0; i < y_ticks_.size(); ++i) {
    const double y = place(0, y_ticks_[i]).y;
    out += svgLine({-kTickLength, y}, {0, y}, kMuted, 1);
    out += svgText({-kTickLength - 4, y + 4.5}, y_texts[i], {.anchor = TextAnchor::kEnd, .color = kMuted});
  }
  out += "<path" + attribute("d", pathData({{0, 0}, {0, inner_height_}, {inner_width_, inner_height_}})) +
         strokeAttributes({.color = kMuted, .width = 1}) + "/>";
  const double foot = inner_height_ + kXAxisHeight - 7;
  out += svgText({inner_width_ / 2, foot}, frame_.x.label, {.anchor = TextAnchor::kMiddle});
  if (frame_.simulated) out += simulatedMark({inner_width_ + kRightMargin - 2, foot});
  if (!frame_.y.label.empty()) {
    out += svgText({-left_ + kFontSize, inner_height_ / 2}, frame_.y.label,
                   {.anchor = TextAnchor::kMiddle, .rotation_deg = -90});
  }
  return out;
}

std::string SvgPlot::svg() const {
  const double top = kTopMargin + legendHeight();
  std::string grid;
  for (const double tick : y_ticks_) {
    grid += svgLine(place(frame_.x.min, tick), place(frame_.x.max, tick), kGrid, 1);
  }
  std::string out = svgStart(frame_.width, frame_.height + legendHeight(), frame_.title, frame_.description);
  out += legend();
  out += "<g" + attribute("transform", "translate(" + coordinate(left_) + ' ' + coordinate(top) + ')') + '>';
  out += bands_ + grid;
  // A drawing within the drawing cuts its content off at the axes.
  out += "<svg" + attribute("width", inner_width_) + attribute("height", inner_height_) + '>' + content_ + "</svg>";
  out += axes() + texts_ + "</g></svg>";
  return out;
}

}  // namespace tactus::report
