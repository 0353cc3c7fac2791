#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/force_steps.h"
#include "core/base/text.h"
#include "elicitation/force/force_step_limits.h"
#include "elicitation/rules/rule_lint_parts.h"

namespace tactus::elicitation {
namespace {

// Rules looked at for all of them: some hundredths of a second.
constexpr std::size_t kCliffAllowance = 40'000'000;
constexpr std::size_t kFewestForces = 1000;

std::string trimmedNumber(double value, int decimals) {
  std::string text = base::formatFixed(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string withUnit(const std::string& number, const std::string& unit) {
  return unit == "1" || unit.empty() ? number : number + ' ' + unit;
}

/// `lubrication 1, speed 50 mm/s`: the values of the other inputs.
std::string settingText(const fuzzy::ForceModel& model, const analysis::ForceStep& step) {
  std::string text;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i == step.input) continue;
    if (!text.empty()) text += ", ";
    text += model.inputs[i].id + ' ' + withUnit(base::formatNumber(step.from[i]), model.inputs[i].unit);
  }
  return text;
}

}  // namespace

std::vector<RuleFinding> findingsOfCliffs(const RuleContext& context, analysis::ForceProbe& probe) {
  std::vector<RuleFinding> out;
  if (context.model.output.unit != "N") return out;
  const auto limits = forceStepLimits(context.model);
  const std::size_t forces = std::max(kFewestForces, kCliffAllowance / (2 * probe.costOfMean()));
  for (const auto& step : analysis::forceSteps(probe, limits, forces)) {
    const fuzzy::Variable& input = context.model.inputs[step.input];
    auto& finding = out.emplace_back();
    finding.kind = RuleFinding::Kind::kForceStep;
    if (step.expert) finding.experts = {context.model.experts[*step.expert].id};
    setPlace(finding, analysis::CliffPlace{step.input, step.from[step.input], step.to[step.input]}, context.model);
    finding.text = "the force steps from " + newtonsText(step.from_n) + " to " + newtonsText(step.to_n) + " within " +
                   withUnit(trimmedNumber(step.to[step.input] - step.from[step.input], 2), input.unit) + ", " +
                   base::formatFixed(step.noticeable, 1) + " just-noticeable differences";
    if (step.noticeable <= 1) {
      finding.text +=
          " but steeper than the renderer's stiffness of " + base::formatNumber(limits.stiffness_n_mm) + " N/mm";
    }
    finding.text += ": " + finding.place;
    if (const auto setting = settingText(context.model, step); !setting.empty()) finding.text += " where " + setting;
    finding.newtons = std::abs(step.to_n - step.from_n);
    finding.at_least = context.model.inputs.size() > 1;
    finding.from = step.from;
    finding.to = step.to;
  }
  return out;
}

}  // namespace tactus::elicitation
