#include <algorithm>
#include <cmath>

#include "core/analysis/directions.h"
#include "core/analysis/rule_table.h"
#include "elicitation/rules/rule_lint_parts.h"

namespace tactus::elicitation {
namespace {

bool isAgainst(const RuleContext& context, const analysis::NeighborStep& step) {
  return std::any_of(context.settings.directions.begin(), context.settings.directions.end(),
                     [&](const DeclaredDirection& declared) {
                       return declared.input == context.model.inputs[step.input].id &&
                              step.levels * static_cast<int>(declared.direction) < 0;
                     });
}

bool isJump(const RuleContext& context, const analysis::NeighborStep& step) {
  return step.adjacent && step.levels != 0 && std::abs(step.levels) >= context.settings.jump_levels;
}

/// A step that is worth a finding.
struct ExpertStep {
  std::size_t expert;
  analysis::NeighborStep step;
};

std::vector<ExpertStep> stepsToTell(const RuleContext& context) {
  std::vector<ExpertStep> out;
  for (std::size_t e = 0; e < context.model.experts.size(); ++e) {
    for (std::size_t i = 0; i < context.model.inputs.size(); ++i) {
      for (const auto& step : analysis::neighborSteps(context.model, context.model.experts[e], i)) {
        if (isAgainst(context, step) || isJump(context, step)) out.push_back({e, step});
      }
    }
  }
  return out;
}

}  // namespace

std::vector<RuleFinding> findingsOfSteps(const RuleContext& context, analysis::ForceProbe& probe, ToldSteps& told) {
  const auto steps = stepsToTell(context);
  const std::size_t samples = settingsFor(probe, steps.size());
  std::vector<RuleFinding> out;
  for (const auto& [e, step] : steps) {
    const fuzzy::Expert& who = context.model.experts[e];
    RuleFinding finding;
    setPlace(finding, analysis::StepPlace{e, step}, context.model);
    finding.experts = {who.id};
    finding.sources = {context.source(e, step.before), context.source(e, step.after)};
    if (const auto change = analysis::changeAlong(probe, e, step, samples)) {
      finding.newtons = change->newtons;
      finding.at_least = true;
      // Where other rules outweigh the step everywhere there is no change to point at.
      if (change->newtons > 0) {
        finding.from = change->from;
        finding.to = change->to;
      }
    }
    const auto add = [&](RuleFinding::Kind kind, const std::string& says) {
      finding.kind = kind;
      finding.text = says + ": " + finding.place + "; " + describe(finding.sources);
      out.push_back(finding);
    };
    if (isAgainst(context, step)) {
      told.insert({e, {step.before, step.after}});
      add(RuleFinding::Kind::kAgainstDeclaration, "against the declared direction");
    }
    if (isJump(context, step)) {
      const int levels = std::abs(step.levels);
      add(RuleFinding::Kind::kLevelJump, std::to_string(levels) + (levels == 1 ? " level" : " levels") + " at once");
    }
  }
  return out;
}

}  // namespace tactus::elicitation
