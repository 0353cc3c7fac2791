#include "app/report/study_report.h"

#include <algorithm>

#include "app/living/living.h"
#include "app/report/report_sections.h"
#include "core/base/error.h"

namespace tactus::report {

base::Result<std::string> demoReport(const DemoReportInputs& inputs) {
  TACTUS_TRY(const auto curves, ForceCurves::of(inputs.built.model));
  TACTUS_TRY(auto claims, checkClaims(inputs.built.model, {inputs.published_expert, inputs.highest_peak_expert}));
  const StudyReportInputs of_study{.study = inputs.study,
                                   .built = inputs.built,
                                   .build_settings = inputs.build_settings,
                                   .forms = inputs.forms,
                                   .settings = inputs.settings};
  const ReportContext context{.in = of_study,
                              .demo = &inputs,
                              .curves = &curves,
                              .usual = usualPoint(inputs.built),
                              .regions = wayRegions(inputs.built.about(), depthVariable(inputs.built.model)),
                              .claims = std::move(claims),
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

namespace {

/// Everything that comes out of a model with at least one expert.
void addModelSections(HtmlPage& page, const ReportContext& context) {
  addRules(page, context);
  addWayOut(page, context);
  addExperts(page, context);
  addUncertainty(page, context);
  addSurface(page, context);
  addInfluences(page, context);
  addPublishedForces(page, context);
  addComparisons(page, context);
  addReachableRange(page, context);
  addChoices(page, context);
}

/// The averaged model, for a reader who moves it.
void addLiving(HtmlPage& page, const ReportContext& context) {
  const fuzzy::ForceModel& model = context.in.built.model;
  const auto living = living::sectionOf(model, context.curves->compiled(), context.simulated());
  if (!living) return;
  page.style(living->style);
  page.screenSection("Try the model", Markup::raw(living->html));
}

std::string titleOf(const StudyReportInputs& inputs) {
  if (!inputs.built.model.name.empty()) return inputs.built.model.name;
  return inputs.study.name.empty() ? "A study of insertion forces" : inputs.study.name;
}

}  // namespace

void addTerms(HtmlPage& page, const ReportContext& context) {
  addSpeeds(page, context);
  addClusters(page, context);
  addVotes(page, context);
  addFrequency(page, context);
  addMembershipFunctions(page, context);
  addVertices(page, context);
}

void addComparisons(HtmlPage& page, const ReportContext& context) {
  addFeel(page, context);
  addAgreement(page, context);
  addInfluence(page, context);
  addConflicts(page, context);
  addWeights(page, context);
  addFindings(page, context);
}

void addEnd(HtmlPage& page, const ReportContext& context) {
  addMethod(page, context);
  addBuildNotes(page, context);
  addReferences(page, context);
}

Markup marks(const ReportContext& context, std::initializer_list<Badge> list) {
  if (context.demo != nullptr) return badges(list);
  std::vector<Badge> kept;
  for (const Badge one : list) {
    if (one == Badge::kPublished || (one == Badge::kSimulated && !context.simulated())) continue;
    kept.push_back(one);
  }
  Markup out;
  for (std::size_t i = 0; i < kept.size(); ++i) out += (i > 0 ? Markup(" ") : Markup()) + badge(kept[i]);
  return out;
}

bool ReportContext::simulated(const std::string& participant) const {
  const auto& people = in.study.participants;
  return std::any_of(people.begin(), people.end(),
                     [&](const auto& one) { return one.simulated && one.code == participant; });
}

bool ReportContext::simulated() const {
  const auto& people = in.study.participants;
  return std::any_of(people.begin(), people.end(), [](const auto& one) { return one.simulated; });
}

std::optional<elicitation::StudySpeedIntervals> speedIntervals(const StudyReportInputs& inputs) {
  if (inputs.replicates == 0) return std::nullopt;
  auto bootstrap = elicitation::SpeedBootstrap::of(inputs.study, inputs.built, inputs.build_settings);
  if (!bootstrap) return std::nullopt;
  bootstrap->add(inputs.replicates);
  return bootstrap->intervals();
}

const fuzzy::Variable& depthVariable(const fuzzy::ForceModel& model) {
  return model.inputs[fuzzy::wayOf(model.inputs).value()];
}

std::vector<double> usualPoint(const elicitation::BuiltModel& built) {
  const procedure::Procedure& about = built.about();
  std::vector<double> point;
  for (const fuzzy::Variable& input : built.model.inputs) {
    const auto own = std::find_if(about.inputs.begin(), about.inputs.end(),
                                  [&input](const fuzzy::Variable& one) { return one.id == input.id; });
    point.push_back(own == about.inputs.end()
                        ? (input.min + input.max) / 2
                        : about.input_notes[static_cast<std::size_t>(own - about.inputs.begin())].usual);
  }
  return point;
}

namespace {

/// What the page is, in one sentence.
std::string subtitleOf(const ReportContext& context) {
  return "From the participants’ judgements and answers to an averaged force model, by the method of Choi et al. "
         "Procedure: " +
         context.about().titleIn("en") + ".";
}

}  // namespace

base::Result<std::string> studyReport(const StudyReportInputs& inputs) {
  if (!fuzzy::wayOf(inputs.built.model.inputs)) {
    return base::fail(base::ErrorCode::kReference, "/inputs", "no input of the role `way`",
                      "an input along which the tip moves");
  }
  const bool with_experts = !inputs.built.model.experts.empty();
  std::optional<ForceCurves> curves;
  if (with_experts) {
    TACTUS_TRY(auto made, ForceCurves::of(inputs.built.model));
    curves = std::move(made);
  }
  const ReportContext context{.in = inputs,
                              .curves = curves ? &*curves : nullptr,
                              .usual = usualPoint(inputs.built),
                              .regions = wayRegions(inputs.built.about(), depthVariable(inputs.built.model)),
                              .speed_intervals = speedIntervals(inputs)};
  HtmlPage page(titleOf(inputs), subtitleOf(context));
  page.numberCaptions();
  addStudyOverview(page, context);
  if (with_experts) addLiving(page, context);
  addParticipants(page, context);
  addDataFindings(page, context);
  addOrderEffects(page, context);
  addStopForces(page, context);
  addTerms(page, context);
  if (with_experts) {
    addModelSections(page, context);
  } else {
    addAgreement(page, context);
  }
  addUsability(page, context);
  addDuels(page, context);
  addEvidence(page, context);
  addEnd(page, context);
  return page.html();
}

}  // namespace tactus::report
