// The sections of the reports, one function each. Internal to the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/force_curves.h"
#include "app/report/html.h"
#include "app/report/regions.h"
#include "app/report/study_report.h"
#include "elicitation/model/speed_bootstrap.h"

namespace tactus::report {

/// The data of all sections.
struct ReportContext {
  const StudyReportInputs& in;
  const DemoReportInputs* demo = nullptr;  ///< what only the demo's report has; null in the report of another study
  const ForceCurves* curves = nullptr;     ///< of the averaged model; null without experts
  std::vector<double> usual = {};          ///< the usual value of each input: the setting of curves along the way
  std::vector<Region> regions = {};
  std::vector<Claim> claims = {};                                        ///< of the demo
  std::optional<elicitation::StudySpeedIntervals> speed_intervals = {};  ///< absent if there are too few strokes

  /// Whether the data of a participant, or of any one, are simulated.
  bool simulated(const std::string& participant) const;
  bool simulated() const;
  const procedure::Procedure& about() const { return in.built.about(); }
};

/// Participants and experts that are drawn one by one; with more of them only some, or the range of all.
inline constexpr std::size_t kMostDrawn = 12;

/// The badges of a table or figure of the demo. In the report of another study there is nothing published, and
/// `simulated` only if a participant is.
Markup marks(const ReportContext& context, std::initializer_list<Badge> list);
/// The intervals of the speeds; nothing without speeds, or with too few strokes to draw from.
std::optional<elicitation::StudySpeedIntervals> speedIntervals(const StudyReportInputs& inputs);
/// The way of the model.
const fuzzy::Variable& depthVariable(const fuzzy::ForceModel& model);
/// The usual value of each input of `built`.
std::vector<double> usualPoint(const elicitation::BuiltModel& built);

// study_report.cpp: what both reports have in the same order
/// From the strokes and judgements to the vertices of the terms.
void addTerms(HtmlPage& page, const ReportContext& context);
/// What the hand feels, how far the experts agree, and what is odd in their rules.
void addComparisons(HtmlPage& page, const ReportContext& context);
/// Settings, notes and literature.
void addEnd(HtmlPage& page, const ReportContext& context);

// sections_method.cpp
/// The method study: whether another choice of the method would be felt. Names the command for a study that is too
/// large for it.
void addChoices(HtmlPage& page, const ReportContext& context);
// sections_agreement.cpp
/// Table 3 of the paper from the answers of this study; nothing without answers.
void addUsability(HtmlPage& page, const ReportContext& context);
// sections_study.cpp
void addOverview(HtmlPage& page, const ReportContext& context);
void addOrigin(HtmlPage& page, const ReportContext& context);
// sections_study.cpp
/// Numbers and what is missing.
void addStudyOverview(HtmlPage& page, const ReportContext& context);
void addParticipants(HtmlPage& page, const ReportContext& context);
void addDataFindings(HtmlPage& page, const ReportContext& context);
/// Whether the words follow the hand: blanks, hidden repeats, up against down, and what the order of the trials does.
void addOrderEffects(HtmlPage& page, const ReportContext& context);
/// The force at which each participant would stop; nothing of a procedure that does not ask for it.
void addStopForces(HtmlPage& page, const ReportContext& context);
// sections_rules.cpp
void addRules(HtmlPage& page, const ReportContext& context);
// sections_rules.cpp
/// What the experts say of the way out, region by region, beside the way in; nothing of a form that does not ask.
void addWayOut(HtmlPage& page, const ReportContext& context);
void addConflicts(HtmlPage& page, const ReportContext& context);
// sections_influence.cpp
/// The bands "again", "others" and "next" around the averaged force.
void addUncertainty(HtmlPage& page, const ReportContext& context);
// sections_method.cpp
void addMethod(HtmlPage& page, const ReportContext& context);
void addReferences(HtmlPage& page, const ReportContext& context);
// sections_speed.cpp
void addSpeeds(HtmlPage& page, const ReportContext& context);
void addClusters(HtmlPage& page, const ReportContext& context);
/// The input of the built model that is the rate; it must have one.
const fuzzy::Variable& speedVariable(const ReportContext& context);
// sections_clusters.cpp: the tables of addClusters
void addClusterTables(HtmlPage& page, const ReportContext& context);
// sections_agreement.cpp
void addVotes(HtmlPage& page, const ReportContext& context);
// sections_model.cpp
void addMembershipFunctions(HtmlPage& page, const ReportContext& context);
void addVertices(HtmlPage& page, const ReportContext& context);
void addReachableRange(HtmlPage& page, const ReportContext& context);
// sections_force.cpp
void addFrequency(HtmlPage& page, const ReportContext& context);
void addSurface(HtmlPage& page, const ReportContext& context);
void addInfluences(HtmlPage& page, const ReportContext& context);
void addExperts(HtmlPage& page, const ReportContext& context);
void addReadings(HtmlPage& page, const ReportContext& context);
/// What others published of the procedure, with what it is not; nothing of a pack without.
void addPublishedForces(HtmlPage& page, const ReportContext& context);
// sections_feel.cpp
/// Fig. 13 and 18: the force that a simulated hand feels from the averaged model. Adds nothing if the model cannot be
/// rendered.
void addFeel(HtmlPage& page, const ReportContext& context);
/// The blind comparisons of models by hand, each with its verdict; nothing without any.
void addDuels(HtmlPage& page, const ReportContext& context);
// sections_evidence.cpp
/// Content, face, construct and concurrent evidence: done, with its numbers, or not done yet, with what it needs.
void addEvidence(HtmlPage& page, const ReportContext& context);
// sections_agreement.cpp
void addAgreement(HtmlPage& page, const ReportContext& context);
// sections_influence.cpp
void addInfluence(HtmlPage& page, const ReportContext& context);
// sections_findings.cpp
void addFindings(HtmlPage& page, const ReportContext& context);
void addWeights(HtmlPage& page, const ReportContext& context);
// sections_claims.cpp
/// Each statement with its verdicts for the published expert, and for the mean or all experts.
void addVerdicts(HtmlPage& page, const ReportContext& context);
void addClaims(HtmlPage& page, const ReportContext& context);
// sections_study.cpp
void addContradictions(HtmlPage& page, const ReportContext& context);
void addBuildNotes(HtmlPage& page, const ReportContext& context);

/// The common axes of all force-depth plots, so that readers can compare figures.
PlotAxis depthAxis(const ReportContext& context);
PlotAxis forceAxis(const ReportContext& context);
/// `NC nasal cavity, NP nasopharynx, …`.
std::string regionCodes(const std::vector<Region>& regions);
/// Shades every second region and writes the names along the top.
void markRegions(SvgPlot& plot, const std::vector<Region>& regions);
/// A plot over the depth at the conditions of the curves, with its regions marked. `height`: px.
SvgPlot depthPlot(const ReportContext& context, const std::string& title, double height, const PlotAxis& y);
/// `insertion speed 35 mm/s`: a value of one input.
std::string valueText(const fuzzy::Variable& input, double value);
/// `insertion depth 35 mm, insertion speed 35 mm/s, …`: a point of the input space.
std::string settingText(const fuzzy::ForceModel& model, const std::vector<double>& point);
/// The same of all inputs but the way and those of `without`.
std::string settingText(const ReportContext& context, const std::vector<double>& point,
                        const std::vector<std::size_t>& without = {});
/// ` at <the usual values>`; empty for a model of the way alone.
std::string atUsual(const ReportContext& context);
/// The line of expert `index`, with its own color and dash.
LineLook expertLook(std::size_t index);

}  // namespace tactus::report
