#include "elicitation/depth/depth_terms.h"

#include <cmath>
#include <string>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;

constexpr double kSmallestScale = 0.5;
constexpr double kLargestScale = 2;

std::string between(const fuzzy::Variable& depth, std::size_t gap) {
  return "boundary of " + depth.terms[gap].id + " and " + depth.terms[gap + 1].id;
}

std::string mm(double depth_mm) { return base::roundedNumber(depth_mm) + " mm"; }

}  // namespace

base::Result<std::vector<fuzzy::Term>> depthTerms(const fuzzy::Variable& depth,
                                                  std::span<const DepthBoundary> boundaries, double scale) {
  if (boundaries.size() + 1 != depth.terms.size()) {
    return fail(ErrorCode::kData, "regions", std::to_string(boundaries.size()) + " boundaries",
                std::to_string(depth.terms.size() - 1) + ", one fewer than regions");
  }
  if (!(scale >= kSmallestScale && scale <= kLargestScale)) {
    return fail(ErrorCode::kValue, "anatomical scale", base::roundedNumber(scale), "a factor from 0.5 to 2");
  }
  double before_mm = depth.min;  // where the last ramp ends
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const DepthBoundary& one = boundaries[k];
    if (!std::isfinite(one.depth_mm) || !(std::isfinite(one.half_overlap_mm) && one.half_overlap_mm >= 0)) {
      return fail(ErrorCode::kValue, between(depth, k), "a number that is not finite, or a negative overlap",
                  "a depth, and an overlap of 0 mm or more");
    }
    const double begin_mm = scale * (one.depth_mm - one.half_overlap_mm);
    const double end_mm = scale * (one.depth_mm + one.half_overlap_mm);
    if (begin_mm < before_mm) {
      return fail(ErrorCode::kData, between(depth, k), "a ramp from " + mm(begin_mm),
                  "a begin at or behind " + mm(before_mm) + ", where the ramp before ends");
    }
    if (end_mm > depth.max) {
      return fail(ErrorCode::kData, between(depth, k), "a ramp to " + mm(end_mm),
                  "an end within the universe, " + mm(depth.max));
    }
    before_mm = end_mm;
  }
  std::vector<fuzzy::Term> terms = depth.terms;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const auto begin = [&](std::size_t gap) {
      return scale * (boundaries[gap].depth_mm - boundaries[gap].half_overlap_mm);
    };
    const auto end = [&](std::size_t gap) {
      return scale * (boundaries[gap].depth_mm + boundaries[gap].half_overlap_mm);
    };
    const bool first = k == 0;
    const bool last = k + 1 == terms.size();
    terms[k].shape = fuzzy::Shape::kTrapezoid;
    terms[k].points = {first ? depth.min : begin(k - 1), first ? depth.min : end(k - 1), last ? depth.max : begin(k),
                       last ? depth.max : end(k)};
  }
  return terms;
}

std::vector<DepthBoundary> boundariesOf(std::span<const fuzzy::Term> terms) {
  std::vector<DepthBoundary> out;
  for (std::size_t k = 0; k + 1 < terms.size(); ++k) {
    const double begin_mm = terms[k].points[2];
    const double end_mm = terms[k].points[3];
    out.push_back({(begin_mm + end_mm) / 2, (end_mm - begin_mm) / 2});
  }
  return out;
}

}  // namespace tactus::elicitation
