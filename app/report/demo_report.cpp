#include "app/report/demo_report.h"

#include <algorithm>

#include "app/report/report_sections.h"

namespace tactus::report {
namespace {

/// Nothing where there are no speeds, or too few strokes to draw from.
std::optional<elicitation::StudySpeedIntervals> speedIntervals(const DemoReportInputs& inputs) {
  auto bootstrap = elicitation::SpeedBootstrap::of(inputs.study, inputs.built, inputs.build_settings);
  if (!bootstrap) return std::nullopt;
  bootstrap->add(elicitation::kBootstrapReplicates);
  return bootstrap->intervals();
}

}  // namespace

base::Result<std::string> demoReport(const DemoReportInputs& inputs) {
  const auto curves = ForceCurves::of(inputs.built.model);
  if (!curves) return tl::unexpected(curves.error());
  auto claims = checkClaims(inputs.built.model, {inputs.published_expert, inputs.highest_peak_expert});
  if (!claims) return tl::unexpected(claims.error());
  const auto depth = std::find_if(inputs.built.model.inputs.begin(), inputs.built.model.inputs.end(),
                                  [](const fuzzy::Variable& input) { return input.id == "depth"; });
  const ReportContext context{inputs, *curves, depthRegions(*depth), std::move(*claims), speedIntervals(inputs)};

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
  addFrequency(page, context);
  addMembershipFunctions(page, context);
  addSurface(page, context);
  addInfluences(page, context);
  addExperts(page, context);
  addFeel(page, context);
  addAgreement(page, context);
  addWeights(page, context);
  addFindings(page, context);
  addClaims(page, context);
  addReadings(page, context);
  addReachableRange(page, context);
  addContradictions(page, context);
  addBuildNotes(page, context);
  return page.html();
}

}  // namespace tactus::report
