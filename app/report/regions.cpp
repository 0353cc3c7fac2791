#include "app/report/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/check.h"

namespace tactus::report {

namespace {

struct DefaultRegion {
  std::string_view id, code, label;
  double to_mm;
};

// Limits: Callesen 2021, Watanabe and Masui 1999, Stoneham 1993, Li 1994; the middle of what they found.
constexpr std::array<DefaultRegion, 6> kRegions = {{{"nasal_cavity", "NC", "Nasal cavity", 70},
                                                    {"nasopharynx", "NP", "Nasopharynx", 115},
                                                    {"oropharynx", "OP", "Oropharynx", 150},
                                                    {"laryngopharynx", "LP", "Laryngopharynx", 200},
                                                    {"esophagus", "ES", "Esophagus", 440},
                                                    {"stomach", "ST", "Stomach", 600}}};

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

}  // namespace

std::vector<Region> depthRegions(const fuzzy::Variable& depth) {
  std::vector<Region> out;
  double from_mm = depth.min;
  for (std::size_t i = 0; i < kRegions.size(); ++i) {
    const bool last = i + 1 == kRegions.size();
    double to_mm = last ? depth.max : kRegions[i].to_mm;
    if (!last) {
      to_mm = crossing(fuzzy::findTerm(depth.terms, kRegions[i].id), fuzzy::findTerm(depth.terms, kRegions[i + 1].id))
                  .value_or(to_mm);
    }
    to_mm = std::max(to_mm, from_mm);
    out.push_back({.id = std::string(kRegions[i].id),
                   .code = std::string(kRegions[i].code),
                   .label = std::string(kRegions[i].label),
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
