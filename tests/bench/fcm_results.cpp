#include "tests/bench/fcm_results.h"

#include "core/base/tables/csv.h"
#include "core/base/text.h"

#include "tests/bench/text_table.h"

namespace tactus::bench {
namespace {

std::string digits(const std::optional<double>& value, const std::string& unit = "") {
  return value ? threeDigits(*value) + unit : "-";
}

using Line = std::vector<std::string>;

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
      comparison.push_back({row.method, samples, threeDigits(row.median_ms), threeDigits(row.min_ms), digits(row.error),
                            digits(row.reads), digits(row.ratio, "x")});
    } else {
      growth.push_back({row.part, row.method, samples, std::to_string(row.clusters), base::formatNumber(row.m),
                        threeDigits(row.median_ms), threeDigits(row.min_ms), digits(row.reads)});
    }
  }
  text += "\nRun time and error, three clusters, m = 2\n\n" + alignedTable(comparison, 1);
  if (growth.size() > 1) text += "\nHow the cost of ours grows\n\n" + alignedTable(growth, 2);
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
