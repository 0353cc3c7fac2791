#include "app/report/demo_report.h"

#include "app/report/report_sections.h"

namespace tactus::report {
base::Result<std::string> demoReport(const DemoReportInputs& inputs) {
  const auto curves = ForceCurves::of(inputs.built.model);
  if (!curves) return tl::unexpected(curves.error());
  auto claims = checkClaims(inputs.built.model, {inputs.published_expert, inputs.highest_peak_expert});
  if (!claims) return tl::unexpected(claims.error());
  const StudyReportInputs of_study{.study = inputs.study,
                                   .built = inputs.built,
                                   .build_settings = inputs.build_settings,
                                   .forms = inputs.forms,
                                   .settings = inputs.settings};
  const ReportContext context{.in = of_study,
                              .demo = &inputs,
                              .curves = &*curves,
                              .regions = depthRegions(depthVariable(inputs.built.model)),
                              .claims = std::move(*claims),
                              .speed_intervals = speedIntervals(of_study)};

  HtmlPage page(
      "A force model of nasogastric tube insertion",
      "Published data in, averaged expert model out: the tables and figures of Choi et al., “A heuristic force "
      "model for haptic simulation of nasogastric tube insertion using fuzzy logic”, recomputed. Where the "
      "paper prints no data, simulated data stand in and are marked.");
  addOverview(page, context);
  addOrigin(page, context);
  addTerms(page, context);
  addSurface(page, context);
  addInfluences(page, context);
  addExperts(page, context);
  addUncertainty(page, context);
  addComparisons(page, context);
  addClaims(page, context);
  addReadings(page, context);
  addReachableRange(page, context);
  addContradictions(page, context);
  addEnd(page, context);
  return page.html();
}

}  // namespace tactus::report
