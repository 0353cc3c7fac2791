#include "tests/bench/results.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/base/tables/csv.h"

#include "tests/bench/text_table.h"

namespace tactus::bench {
namespace {

void addError(ErrorFigures& figures, double error, std::size_t count) {
  // A force that is no number is an error without bound.
  if (std::isnan(error)) error = HUGE_VAL;
  figures.largest_n = std::max(figures.largest_n, error);
  figures.mean_n += error / static_cast<double>(count);
}

std::string timesUnit(std::optional<double> unit_ns, double ns) {
  return unit_ns ? threeDigits(*unit_ns / ns) + "x" : "-";
}

std::string settingText(const ContenderResult& row) { return row.setting == 0 ? "" : std::to_string(row.setting); }

void printContenders(const Results& results, std::ostream& out) {
  std::vector<std::vector<std::string>> rows = {{"model", "method", "setting", "median", "min",
                                                 "faster than fuzzylite 100", "largest error", "mean error",
                                                 "largest difference", "mean difference"}};
  for (const auto& r : results.contenders) {
    rows.push_back({r.model, r.family, settingText(r), formatTime(r.timing.median_ns), formatTime(r.timing.min_ns),
                    timesUnit(results.unit_ns, r.timing.median_ns), threeDigits(r.exact.largest_n) + " N",
                    threeDigits(r.exact.mean_n) + " N", threeDigits(r.one_point.largest_n) + " N",
                    threeDigits(r.one_point.mean_n) + " N"});
  }
  out << "\nTime of one evaluation, error against exact rationals, difference from our one-point evaluator\n\n";
  out << alignedTable(rows, 2);
}

/// One line per value, one column per thing that was measured.
void printCosts(const Results& results, std::ostream& out) {
  std::vector<std::string> parts;
  for (const auto& cost : results.costs) {
    if (std::find(parts.begin(), parts.end(), cost.part) == parts.end()) parts.push_back(cost.part);
  }
  for (const auto& part : parts) {
    std::vector<std::string> heading = {part};
    std::vector<std::vector<std::string>> rows;
    for (const auto& cost : results.costs) {
      if (cost.part != part) continue;
      if (std::find(heading.begin(), heading.end(), cost.what) == heading.end()) {
        heading.push_back(cost.what);
        heading.push_back("in fuzzylite 100");
      }
      if (rows.empty() || rows.back().front() != cost.value) rows.push_back({cost.value});
      rows.back().push_back(formatTime(cost.timing.median_ns));
      rows.back().push_back(results.cost_unit_ns ? threeDigits(cost.timing.median_ns / *results.cost_unit_ns) : "-");
    }
    rows.insert(rows.begin(), heading);
    out << '\n';
    out << alignedTable(rows, 1);
  }
}

}  // namespace

ErrorFigures errorAgainstExact(const Case& about, std::span<const double> forces_n) {
  ErrorFigures out;
  const std::size_t count = std::min(about.exact_n.size(), forces_n.size());
  for (std::size_t p = 0; p < count; ++p) {
    const bool number = std::isfinite(forces_n[p]);
    addError(out, number ? std::abs(mpq_class(mpq_class(forces_n[p]) - about.exact_n[p]).get_d()) : HUGE_VAL, count);
  }
  return out;
}

ErrorFigures differenceFromOnePoint(const Case& about, std::span<const double> forces_n) {
  ErrorFigures out;
  for (std::size_t p = 0; p < forces_n.size(); ++p) {
    addError(out, std::abs(forces_n[p] - about.one_point_n[p]), forces_n.size());
  }
  return out;
}

std::string formatTime(double ns) {
  if (ns < 1e4) return threeDigits(ns) + " ns";
  if (ns < 1e7) return threeDigits(ns / 1e3) + " µs";
  return threeDigits(ns / 1e6) + " ms";
}

void printTables(const Results& results, std::ostream& out) {
  for (const auto& line : results.circumstances) out << line << '\n';
  printContenders(results, out);
  if (!results.costs.empty()) {
    out << "\nCost of larger models, of set-up and of common tasks (medians";
    if (results.cost_unit_ns) out << "; fuzzylite 100 took " << formatTime(*results.cost_unit_ns) << " meanwhile";
    out << ")\n";
  }
  printCosts(results, out);
}

std::string csvText(const Results& results) {
  base::CsvWriter csv({"part", "model", "method", "setting", "median_ns", "min_ns", "in_fuzzylite_100",
                       "faster_than_fuzzylite_100", "largest_error_n", "mean_error_n", "largest_difference_n",
                       "mean_difference_n"});
  const auto times = [&csv](const Timing& timing, std::optional<double> unit_ns) {
    csv.cell(timing.median_ns).cell(timing.min_ns);
    if (unit_ns) {
      csv.cell(timing.median_ns / *unit_ns).cell(*unit_ns / timing.median_ns);
    } else {
      csv.cell("").cell("");
    }
  };
  for (const auto& r : results.contenders) {
    csv.cell("run time against error").cell(r.model).cell(r.family).cell(settingText(r));
    times(r.timing, results.unit_ns);
    csv.cell(r.exact.largest_n).cell(r.exact.mean_n).cell(r.one_point.largest_n).cell(r.one_point.mean_n);
    csv.endRow();
  }
  for (const auto& r : results.costs) {
    csv.cell(r.part).cell("").cell(r.what).cell(r.value);
    times(r.timing, results.cost_unit_ns);
    csv.cell("").cell("").cell("").cell("");
    csv.endRow();
  }
  return csv.text();
}

}  // namespace tactus::bench
