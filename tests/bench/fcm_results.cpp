#include "tests/bench/fcm_results.h"

#include <algorithm>
#include <cmath>

#include "core/base/csv.h"
#include "core/base/text.h"

namespace tactus::bench {
namespace {

/// Three significant digits; an exponent where the number is very small.
std::string digits(double value) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return base::formatNumber(value);
  const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (magnitude >= -4) return base::formatFixed(value, std::clamp(2 - magnitude, 0, 6));
  return base::formatFixed(value / std::pow(10.0, magnitude), 1) + 'e' + std::to_string(magnitude);
}

std::string digits(const std::optional<double>& value, const std::string& unit = "") {
  return value ? digits(*value) + unit : "-";
}

using Line = std::vector<std::string>;

std::string aligned(const std::vector<Line>& lines, std::size_t left) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t c = 0; c < line.size(); ++c) {
      const std::string gap(widths[c] - line[c].size(), ' ');
      row += (c < left ? line[c] + gap : gap + line[c]) + "  ";
    }
    text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace

std::string fcmTables(const FcmResults& results) {
  std::string text;
  for (const auto& line : results.circumstances) text += line + '\n';
  std::vector<Line> comparison = {
      {"method", "samples", "median ms", "min ms", "error mm/s", "reads", "faster than e1071 1e-15"}};
  std::vector<Line> growth = {{"part", "method", "samples", "clusters", "m", "median ms", "min ms", "reads"}};
  for (const auto& row : results.rows) {
    const std::string samples = std::to_string(row.samples);
    if (row.part == "comparison") {
      comparison.push_back({row.method, samples, digits(row.median_ms), digits(row.min_ms), digits(row.error),
                            digits(row.reads), digits(row.ratio, "x")});
    } else {
      growth.push_back({row.part, row.method, samples, std::to_string(row.clusters), base::formatNumber(row.m),
                        digits(row.median_ms), digits(row.min_ms), digits(row.reads)});
    }
  }
  text += "\nRun time and error, three clusters, m = 2\n\n" + aligned(comparison, 1);
  if (growth.size() > 1) text += "\nHow the cost of ours grows\n\n" + aligned(growth, 2);
  return text;
}

std::string fcmCsv(const FcmResults& results) {
  base::CsvWriter csv({"part", "method", "samples", "clusters", "m", "median_ms", "min_ms", "largest_error_mm_s",
                       "reads", "faster_than_e1071"});
  const auto optional = [&csv](const std::optional<double>& value) {
    value ? csv.cell(*value) : csv.cell(std::string_view());
  };
  for (const auto& row : results.rows) {
    csv.cell(row.part).cell(row.method).cell(row.samples).cell(row.clusters).cell(row.m);
    csv.cell(row.median_ms).cell(row.min_ms);
    optional(row.error);
    optional(row.reads);
    optional(row.ratio);
    csv.endRow();
  }
  return csv.text();
}

}  // namespace tactus::bench
