#include "tests/bench/chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/report/palette.h"
#include "app/report/svg_plot.h"

#include "tests/bench/contenders.h"

namespace tactus::bench {
namespace {

using report::SvgPoint;

// Sizes in pixels.
constexpr double kLeft = 78;
constexpr double kTop = 14;
constexpr double kWidth = 470;
constexpr double kHeight = 340;
constexpr double kLegendLeft = kLeft + kWidth + 22;
constexpr double kLegendRow = 22;
constexpr double kLegendWidth = 250;
constexpr double kBottom = 52;

/// Errors below this are drawn here: an error of 0 has no logarithm.
constexpr double kSmallestError = 1e-17;

/// A logarithmic axis over whole powers of ten.
struct LogAxis {
  int first = 0;
  int last = 1;

  static LogAxis around(double min, double max) {
    const LogAxis axis{static_cast<int>(std::floor(std::log10(min))), static_cast<int>(std::ceil(std::log10(max)))};
    return {axis.first, std::max(axis.last, axis.first + 1)};
  }
  double share(double value) const { return (std::log10(value) - first) / (last - first); }
};

/// What belongs together in the chart: one method on one model, with its settings.
struct ChartSeries {
  std::string name;
  std::vector<const ContenderResult*> results;
};

double drawnError(const ContenderResult& result) { return std::max(result.exact.largest_n, kSmallestError); }

std::string timeTick(int power) {
  static const std::array<std::string, 3> kUnits = {" ns", " µs", " ms"};
  const auto unit = static_cast<std::size_t>(std::clamp(power / 3, 0, 2));
  const int rest = power - 3 * static_cast<int>(unit);
  if (rest < 0) return "0." + std::string(static_cast<std::size_t>(-rest - 1), '0') + '1' + kUnits[unit];
  return '1' + std::string(static_cast<std::size_t>(rest), '0') + kUnits[unit];
}

class Chart {
 public:
  Chart(LogAxis time, LogAxis error) : time_(time), error_(error) {}

  std::string axes() const {
    std::string out;
    for (int power = time_.first; power <= time_.last; ++power) {
      const double x = kLeft + time_.share(std::pow(10.0, power)) * kWidth;
      out += report::svgLine({x, kTop}, {x, kTop + kHeight}, report::kGrid, 1);
      out += report::svgText({x, kTop + kHeight + 18}, timeTick(power),
                             {.anchor = report::TextAnchor::kMiddle, .color = report::kMuted, .size = 12});
    }
    for (int power = error_.first; power <= error_.last; ++power) {
      const double y = kTop + (1 - error_.share(std::pow(10.0, power))) * kHeight;
      out += report::svgLine({kLeft, y}, {kLeft + kWidth, y}, report::kGrid, 1);
      if (power % 2 == 0) {
        out += report::svgText({kLeft - 6, y + 4}, "1e" + std::to_string(power),
                               {.anchor = report::TextAnchor::kEnd, .color = report::kMuted, .size = 12});
      }
    }
    out += report::svgText({kLeft + kWidth / 2, kTop + kHeight + 42}, "Time of one evaluation",
                           {.anchor = report::TextAnchor::kMiddle});
    out += report::svgText({18, kTop + kHeight / 2}, "Largest error (N)",
                           {.anchor = report::TextAnchor::kMiddle, .rotation_deg = -90});
    return out;
  }

  std::string series(const ChartSeries& series, std::size_t index) const {
    const std::string_view color = report::seriesColor(index);
    // Colors come round again; hollow marks tell the second round from the first.
    const bool hollow = index >= report::kSeriesColors;
    std::vector<SvgPoint> points;
    for (const auto* result : series.results) points.push_back(place(*result));
    std::string out;
    if (points.size() > 1) {
      out += "<path" + report::attribute("d", report::pathData(points)) + report::attribute("stroke", color) +
             R"( fill="none" stroke-width="1.5"/>)";
    }
    for (const SvgPoint& point : points) out += mark(point, color, hollow);
    const double y = kTop + 10 + static_cast<double>(index) * kLegendRow;
    return out + mark({kLegendLeft, y}, color, hollow) + report::svgText({kLegendLeft + 12, y + 4.5}, series.name, {});
  }

 private:
  SvgPoint place(const ContenderResult& result) const {
    return {kLeft + time_.share(result.timing.median_ns) * kWidth,
            kTop + (1 - error_.share(drawnError(result))) * kHeight};
  }

  static std::string mark(SvgPoint at, std::string_view color, bool hollow) {
    return "<circle" + report::attribute("cx", at.x) + report::attribute("cy", at.y) + report::attribute("r", 4.5) +
           report::attribute("fill", hollow ? std::string_view("#FFFFFF") : color) +
           report::attribute("stroke", color) + R"( stroke-width="2"/>)";
  }

  LogAxis time_;
  LogAxis error_;
};

/// The chart shows one implication, the fastest instruction set, and fuzzylite on one set of points. The C source would
/// cover our own evaluators.
bool isShown(const ContenderResult& result) {
  if (result.family.starts_with("C source")) return false;
  if (result.family.starts_with("exact, one point, ")) return false;
  if (result.model.find("scale") != std::string::npos) return false;
  return result.family != "fuzzylite" || result.model.find("scene") == std::string::npos;
}

std::vector<ChartSeries> seriesOf(const Results& results) {
  std::vector<ChartSeries> out;
  for (const auto& result : results.contenders) {
    if (!isShown(result)) continue;
    const std::string name = result.family + (result.model.find("four") == std::string::npos ? "" : ", four experts");
    const bool same = !out.empty() && out.back().name == name;
    if (!same) out.push_back({name, {}});
    out.back().results.push_back(&result);
  }
  return out;
}

}  // namespace

std::string chartSvg(const Results& results) {
  const std::vector<ChartSeries> all = seriesOf(results);
  double min_ns = HUGE_VAL, max_ns = 0, min_n = HUGE_VAL, max_n = 0;
  for (const auto& series : all) {
    for (const auto* result : series.results) {
      min_ns = std::min(min_ns, result->timing.median_ns), max_ns = std::max(max_ns, result->timing.median_ns);
      min_n = std::min(min_n, drawnError(*result)), max_n = std::max(max_n, drawnError(*result));
    }
  }
  const Chart chart(LogAxis::around(min_ns, max_ns), LogAxis::around(min_n, max_n));
  const double height = std::max(kTop + kHeight + kBottom, kTop + 20 + static_cast<double>(all.size()) * kLegendRow);
  std::string out = report::svgStart(kLegendLeft + kLegendWidth, height, "Run time against error",
                                     "Time of one evaluation and largest error against exact rational arithmetic, both "
                                     "logarithmic; down and to the left is better.");
  // Pages are not always white.
  out += R"(<rect width="100%" height="100%" fill="#FFFFFF"/>)";
  out += chart.axes();
  for (std::size_t i = 0; i < all.size(); ++i) out += chart.series(all[i], i);
  return out + "</svg>\n";
}

}  // namespace tactus::bench
