#include "app/report/demo_report.h"

#include <algorithm>

#include "app/report/report_sections.h"

namespace tactus::report {

base::Result<std::string> demoReport(const DemoReportInputs& inputs) {
  const auto curves = ForceCurves::of(inputs.built.model);
  if (!curves) return tl::unexpected(curves.error());
  auto claims = checkClaims(inputs.built.model, {inputs.published_expert, inputs.highest_peak_expert});
  if (!claims) return tl::unexpected(claims.error());
  const auto depth = std::find_if(inputs.built.model.inputs.begin(), inputs.built.model.inputs.end(),
                                  [](const fuzzy::Variable& input) { return input.id == "depth"; });
  const ReportContext context{inputs, *curves, depthRegions(*depth), std::move(*claims)};

  HtmlPage page(
      "A force model of nasogastric tube insertion",
      "Published data in, averaged expert model out: the tables and figures of Choi et al., “A heuristic force "
      "model for haptic simulation of nasogastric tube insertion using fuzzy logic”, recomputed. Where the "
      "paper prints no data, simulated data stand in and are marked.");
  addOverview(page, context);
  addOrigin(page, context);
  addSpeeds(page, context);
  addClusters(page, context);
  addVotes(page, context);
  addMembershipFunctions(page, context);
  addSurface(page, context);
  addInfluences(page, context);
  addExperts(page, context);
  addClaims(page, context);
  addReadings(page, context);
  addReachableRange(page, context);
  addContradictions(page, context);
  addBuildNotes(page, context);
  return page.html();
}

}  // namespace tactus::report
