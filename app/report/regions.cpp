#include "app/report/regions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

// A depth this close to a limit is said to be at the border.
constexpr double kBorderMm = 3;

/// Where the falling side of `left` crosses the rising side of `right`.
std::optional<double> crossing(const fuzzy::Term* left, const fuzzy::Term* right) {
  if (left == nullptr || right == nullptr) return std::nullopt;
  if (left->shape == fuzzy::Shape::kGaussian || right->shape == fuzzy::Shape::kGaussian) return std::nullopt;
  const double d = left->points.back();
  const double fall = d - left->points[left->points.size() - 2];
  const double a = right->points.front();
  const double rise = right->points[1] - a;
  if (fall + rise == 0) return d;
  return (d * rise + a * fall) / (fall + rise);
}

/// The list in which the terms of `way` are found.
const std::vector<fuzzy::Term>& listOf(const procedure::Procedure& procedure, const fuzzy::Variable& way) {
  const auto& sets = procedure.way_terms;
  const auto found = std::find_if(sets.begin(), sets.end(), [&way](const procedure::TermSet& set) {
    return std::all_of(way.terms.begin(), way.terms.end(),
                       [&set](const fuzzy::Term& term) { return fuzzy::findTerm(set.terms, term.id) != nullptr; });
  });
  return found == sets.end() ? sets.front().terms : found->terms;
}

/// The pack's own code, else the first letters of two words, else the first two letters.
std::string codeOf(const procedure::Procedure& procedure, const fuzzy::Term& region) {
  const auto own = procedure.words.find("short." + region.id);
  if (own != procedure.words.end()) return procedure::textIn(own->second, "en");
  const std::string& label = region.label;
  if (label.empty()) return region.id;
  const std::size_t first = base::firstCharacter(label).bytes;
  std::size_t second = label.find(' ');
  second = second == std::string::npos ? first : second + 1;
  if (second >= label.size()) return label;
  std::string code = label.substr(0, first) + label.substr(second, base::firstCharacter(label.substr(second)).bytes);
  std::transform(code.begin(), code.end(), code.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c; });
  return code;
}

}  // namespace

std::vector<Region> wayRegions(const procedure::Procedure& procedure, const fuzzy::Variable& way) {
  const std::vector<fuzzy::Term>& list = listOf(procedure, way);
  std::vector<Region> out;
  double from_mm = way.min;
  for (std::size_t i = 0; i < list.size(); ++i) {
    double to_mm = way.max;
    if (i + 1 < list.size()) {
      to_mm = crossing(fuzzy::findTerm(way.terms, list[i].id), fuzzy::findTerm(way.terms, list[i + 1].id))
                  .value_or(crossing(&list[i], &list[i + 1]).value_or(from_mm));
    }
    to_mm = std::max(to_mm, from_mm);
    out.push_back({.id = list[i].id,
                   .code = codeOf(procedure, list[i]),
                   .label = list[i].label,
                   .from_mm = from_mm,
                   .to_mm = to_mm});
    from_mm = to_mm;
  }
  return out;
}

const Region& regionOf(const std::vector<Region>& regions, std::string_view id) {
  const auto found =
      std::find_if(regions.begin(), regions.end(), [&](const Region& region) { return region.id == id; });
  TACTUS_CHECK(found != regions.end());
  return *found;
}

std::string whereabouts(const std::vector<Region>& regions, double depth_mm) {
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    return text;
  };
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const bool last = i + 1 == regions.size();
    if (!last && std::abs(depth_mm - regions[i].to_mm) <= kBorderMm) {
      return "border of " + lower(regions[i].label) + " and " + lower(regions[i + 1].label);
    }
    if (depth_mm <= regions[i].to_mm || last) return lower(regions[i].label);
  }
  return {};
}

}  // namespace tactus::report
