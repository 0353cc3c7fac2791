#include "app/workbench/feel/procedure.h"

#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/shown_procedure.h"

namespace tactus::workbench {
namespace {

constexpr int kSteps = 4000;

}  // namespace

std::vector<DepthRegion> depthRegions(const fuzzy::Variable& depth) {
  std::vector<DepthRegion> regions;
  std::optional<std::size_t> before;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = std::lerp(depth.min, depth.max, static_cast<double>(i) / kSteps);
    const auto term = strongestTerm(depth, x);
    if (term && term != before) {
      // What touches begins where the one before ends.
      if (before) regions.back().to_mm = x;
      regions.push_back({labelOf(depth.terms[*term]), x, x, depth.terms[*term].id});
    } else if (term) {
      regions.back().to_mm = x;
    }
    before = term;
  }
  return regions;
}

std::optional<std::size_t> regionAt(const std::vector<DepthRegion>& regions, double depth_mm) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const bool last = i + 1 == regions.size();
    if (depth_mm >= regions[i].from_mm && (depth_mm < regions[i].to_mm || (last && depth_mm <= regions[i].to_mm)))
      return i;
  }
  return std::nullopt;
}

std::vector<ProcedureStep> stepsOf(const procedure::Procedure* procedure) {
  std::vector<ProcedureStep> out;
  if (procedure == nullptr) return out;
  for (const procedure::Step& step : procedure->steps)
    out.push_back({inProgramLanguage(step.title), inProgramLanguage(step.text), step.from_mm});
  return out;
}

std::optional<std::size_t> stepAt(const std::vector<ProcedureStep>& steps, double depth_mm) {
  std::optional<std::size_t> at;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].from_mm && *steps[i].from_mm <= depth_mm) at = i;
  }
  return at;
}

}  // namespace tactus::workbench
