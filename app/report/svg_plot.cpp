#include "app/report/svg_plot.h"

#include <algorithm>
#include <cmath>

#include "app/report/markup.h"
#include "app/report/palette.h"
#include "app/report/ticks.h"
#include "core/base/check.h"

namespace tactus::report {

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
    case Dash::kSolid:
      return "";
    case Dash::kDashed:
      return "7 4";
    case Dash::kDotted:
      return "2.5 2.5";
    case Dash::kDashDot:
      return "8 3.5 1.5 3.5";
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
