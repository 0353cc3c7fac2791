#include "elicitation/rules/rule_lint.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/analysis/rule_table.h"
#include "core/base/check.h"
#include "core/base/text.h"
#include "elicitation/rules/rule_lint_parts.h"
#include "elicitation/rules/rule_missing.h"

namespace tactus::elicitation {
namespace {

// Rules looked at for the newtons, well below a second also where there are many.
constexpr std::size_t kAllowance = 100'000'000;
// Settings of the inputs that a rule does not mention: enough for all combinations of two inputs of three terms.
constexpr std::size_t kMostSettings = 400;

/// Items without an answer, with what the answer could change.
std::vector<RuleFinding> findingsOfMissingItems(const RuleContext& context, const analysis::ForceProbe& probe) {
  std::size_t count = 0;
  for (std::size_t e = 0; e < context.model.experts.size(); ++e) count += context.missing(e).size();
  // Each possible answer is looked at.
  const std::size_t samples = settingsFor(probe, count * context.model.output.terms.size());
  std::vector<RuleFinding> out;
  for (std::size_t e = 0; e < context.model.experts.size(); ++e) {
    for (const auto& item : context.missing(e)) {
      auto& finding = out.emplace_back();
      finding.kind = RuleFinding::Kind::kMissingItem;
      finding.experts = {context.model.experts[e].id};
      finding.sources = {{{}, item.origin}};
      setPlace(finding, analysis::ConditionPlace{item.conditions}, context.model);
      finding.text =
          "no rule for " + finding.place + ": " + describe(finding.sources) + ", " + std::string(name(item.reason));
      const auto stake = answerStake(probe, e, item.conditions, samples);
      if (!stake) continue;
      finding.newtons = stake->newtons;
      finding.at_least = true;
      finding.from = finding.to = stake->point;
    }
  }
  return out;
}

}  // namespace

void setPlace(RuleFinding& finding, analysis::FindingPlace where, const fuzzy::ForceModel& model) {
  finding.place = analysis::describe(where, model);
  finding.where = std::move(where);
}

std::string newtonsText(double force_n) { return base::formatFixed(force_n, 3) + " N"; }

std::size_t settingsFor(const analysis::ForceProbe& probe, std::size_t places) {
  const std::size_t share = kAllowance / (1 + 8 * places * probe.costOfMean());
  return std::clamp<std::size_t>(share, 1, kMostSettings);
}

RuleLint ruleLint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                  std::span<const ExpertRules> origins, const RuleLintSettings& settings, const std::stop_token& stop) {
  TACTUS_CHECK(origins.empty() || origins.size() == model.experts.size());
  RuleContext context{model, compiled, origins, settings, std::nullopt};
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == settings.region_input) context.region_input = i;
  }
  analysis::ForceProbe probe(model, compiled, kAllowance, stop);
  RuleLint out;
  const auto add = [&out](std::vector<RuleFinding> findings) {
    std::move(findings.begin(), findings.end(), std::back_inserter(out.findings));
  };
  ToldSteps told;
  add(findingsOfSteps(context, probe, told));
  add(findingsOfExperts(context, probe));
  out.model = analysis::lint(model, compiled, stop);
  add(findingsOfModel(context, out.model, told));
  add(findingsOfMissingItems(context, probe));
  // Of its own: the newtons of the other findings do not suffer.
  analysis::ForceProbe cliffs(model, compiled, kAllowance, stop);
  add(findingsOfCliffs(context, cliffs));
  out.newtons_complete = out.model.newtons_complete && probe.affords();
  std::stable_sort(out.findings.begin(), out.findings.end(), [](const RuleFinding& x, const RuleFinding& y) {
    return std::pair{x.kind, -x.newtons.value_or(-1)} < std::pair{y.kind, -y.newtons.value_or(-1)};
  });
  return out;
}

}  // namespace tactus::elicitation
