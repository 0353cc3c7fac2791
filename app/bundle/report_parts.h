// The parts of a bundle's report: numbers that no analysis gives as such, texts, and the second page. Internal to the
// report.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/bundle/bundle.h"
#include "app/report/html.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::bundle {

// report_numbers.cpp

/// The label; without one the id.
const std::string& labelOf(const fuzzy::Variable& variable);
const std::string& labelOf(const fuzzy::Term& term);
/// The middle of a term's core inside the universe.
double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term);
/// The middle of the middle word of each input.
std::vector<double> middleWords(const fuzzy::ForceModel& model);

/// A part of the way where one word is the truest.
struct RegionNumbers {
  std::string label;
  double from_mm = 0;
  double to_mm = 0;
  std::optional<double> lowest_n;  ///< of the average, at vertices of the terms and between them; empty without a force
  std::optional<double> highest_n;
  double apart_n = 0;  ///< the largest difference of two experts at these points
};
/// In the order of the way. Nothing without a way.
std::vector<RegionNumbers> regionNumbers(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled);

/// A slope of the average along an input.
struct Slope {
  double slope = 0;           ///< absolute value, force per unit of the input
  std::vector<double> point;  ///< where it begins
};
/// The largest slope between positions analysis::stepWidth apart, 1 mm along a depth; a jump counts over that width.
/// Tries positions all along the input at vertices of the others and between them. Nothing without a force.
std::optional<Slope> largestSlope(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                  std::size_t input);

struct Agreement {
  double mean_n = 0;      ///< mean distance of the expert from the average
  double within_jnd = 0;  ///< share of the points at which it is at most one just-noticeable difference
};
/// Of one expert, at points spread evenly over the box. Nothing where it never fires.
std::optional<Agreement> agreementOf(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                     std::size_t expert);

/// Two significant digits; a whole number from 10 on.
std::string shortly(double value);

// report_second_page.cpp

inline constexpr std::size_t kMostReportRows = 12;  ///< of a table, so that two pages hold it

/// Experts, approvals, inputs, limits and files.
void addSecondPage(report::HtmlPage& page, const Bundle& bundle, const fuzzy::CompiledModel& compiled);

}  // namespace tactus::bundle
