#include <algorithm>

#include "core/analysis/expert_spread.h"
#include "core/analysis/explain.h"
#include "core/base/check.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/rules/rule_lint_parts.h"

namespace tactus::elicitation {
namespace {

// Points at which experts are compared: most combinations of the vertices of four inputs.
constexpr std::size_t kMostComparisons = 20000;
// Rules looked at for all of them.
constexpr std::size_t kExpertAllowance = 25'000'000;

/// The rule of each of the two that is strongest at the point, the first of equals.
std::vector<RuleFinding::Source> strongestRules(const RuleContext& context, const analysis::ExpertSpread& spread) {
  const auto explained = analysis::explain(context.model, context.compiled, spread.point);
  TACTUS_CHECK(explained.has_value());
  std::vector<RuleFinding::Source> out;
  for (const std::size_t e : {spread.low, spread.high}) {
    const auto& rules = explained->experts[e].rules;
    const auto strongest = std::max_element(rules.begin(), rules.end(),
                                            [](const auto& x, const auto& y) { return x.strength < y.strength; });
    out.push_back(context.source(e, strongest->rule));
  }
  return out;
}

/// Who of the two has no term for the region, so that the force there comes from another region's rules.
std::string notAsked(const RuleContext& context, const analysis::ExpertSpread& spread) {
  std::string text;
  if (spread.region.empty()) return text;
  for (const std::size_t e : {spread.low, spread.high}) {
    const auto& expert = context.model.experts[e];
    if (findTerm(termsFor(expert, context.model.inputs[*context.region_input]), spread.region) != nullptr) continue;
    text.append("; ").append(expert.id).append(" was not asked about this region");
  }
  return text;
}

}  // namespace

std::vector<RuleFinding> findingsOfExperts(const RuleContext& context, analysis::ForceProbe& probe) {
  std::vector<RuleFinding> out;
  if (context.model.output.unit != "N") return out;
  const std::size_t samples = std::clamp<std::size_t>(kExpertAllowance / probe.costOfMean(), 1, kMostComparisons);
  for (const auto& spread : analysis::expertsApart(probe, context.region_input, justNoticeableDifference,
                                                   context.settings.noticeable_times, samples)) {
    const std::string& low = context.model.experts[spread.low].id;
    const std::string& high = context.model.experts[spread.high].id;
    auto& finding = out.emplace_back();
    finding.kind = RuleFinding::Kind::kExpertsApart;
    finding.experts = {low, high};
    finding.sources = strongestRules(context, spread);
    analysis::ConditionPlace where;
    if (!spread.region.empty()) where.conditions = {{context.settings.region_input, spread.region}};
    setPlace(finding, std::move(where), context.model);
    finding.text = low + " gives " + newtonsText(spread.low_n) + " by " + describe({finding.sources.front()});
    finding.text += " and " + high + ' ' + newtonsText(spread.high_n) + " by " + describe({finding.sources.back()});
    finding.text += (spread.region.empty() ? "" : " where " + finding.place) + "; ";
    finding.text += spread.mean_far_from_all ? "no expert's force is near their mean of " + newtonsText(spread.mean_n)
                                             : "the mean of " + newtonsText(spread.mean_n) + " is near that of " +
                                                   context.model.experts[spread.nearest].id;
    finding.text += ", one just-noticeable difference is " + newtonsText(justNoticeableDifference(spread.mean_n)) +
                    notAsked(context, spread);
    finding.newtons = spread.high_n - spread.low_n;
    finding.at_least = true;
    finding.from = finding.to = spread.point;
  }
  return out;
}

}  // namespace tactus::elicitation
