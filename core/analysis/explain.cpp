#include "core/analysis/explain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::MembershipFunction;

// Products of small memberships and weights are taken times this power of two, or they would lose digits.
constexpr double kScale = 0x1p512;
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

/// Back from kScale. What fires never becomes 0.
double unscaled(double value) { return value > 0 ? std::max(value / kScale, kSmallest) : 0; }

std::size_t inputOf(const ForceModel& model, const std::string& id) {
  const auto it = std::find_if(model.inputs.begin(), model.inputs.end(), [&](const auto& v) { return v.id == id; });
  TACTUS_CHECK(it != model.inputs.end());
  return static_cast<std::size_t>(it - model.inputs.begin());
}

/// The rule, with its strength times kScale.
ExplainedRule explainRule(const ForceModel& model, const Expert& expert, std::size_t index,
                          const std::vector<ExplainedInput>& inputs) {
  const auto& rule = expert.rules[index];
  ExplainedRule out;
  out.rule = index;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& condition : rule.conditions) {
    const std::size_t i = inputOf(model, condition.input);
    const auto& term = *findTerm(termsFor(expert, model.inputs[i]), condition.term);
    const double membership = MembershipFunction::of(term).scaled(inputs[i].value, kScale);
    if (membership < smallest) {
      smallest = membership;
      out.smallest_condition = out.memberships.size();
    }
    out.memberships.push_back(unscaled(membership));
  }
  if (fuzzy::takesPart(rule) && smallest > 0) out.strength = std::max(rule.weight * smallest, kSmallest);
  return out;
}

ExplainedExpert explainExpert(const ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t index,
                              const std::vector<ExplainedInput>& inputs, std::span<const double> point) {
  const Expert& expert = model.experts[index];
  ExplainedExpert out;
  out.id = expert.id;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    auto& list = out.memberships.emplace_back();
    for (const auto& term : termsFor(expert, model.inputs[i])) {
      list.push_back({term.id, MembershipFunction::of(term)(inputs[i].value)});
    }
  }

  const auto& output_terms = termsFor(expert, model.output);
  for (const auto& term : output_terms) out.output_terms.push_back({term.id, 0, std::nullopt, {}});
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    out.rules.push_back(explainRule(model, expert, r, inputs));
    const auto term = static_cast<std::size_t>(findTerm(output_terms, expert.rules[r].then) - output_terms.data());
    auto& then = out.output_terms[term];
    if (out.rules.back().strength <= then.strength) continue;
    then.strength = out.rules.back().strength;
    then.winning_rule = r;
  }
  for (auto& rule : out.rules) rule.strength = unscaled(rule.strength);

  std::vector<Polyline> sets;
  for (std::size_t t = 0; t < output_terms.size(); ++t) {
    auto& then = out.output_terms[t];
    then.strength = unscaled(then.strength);
    if (!then.winning_rule) continue;
    out.rules[*then.winning_rule].wins = true;
    const auto function = MembershipFunction::of(output_terms[t]);
    out.sampled = out.sampled || function.gaussian;
    then.set = impliedSet(function, then.strength, model.implication, model.output.min, model.output.max);
    sets.push_back(then.set);
  }
  out.abstains = sets.empty();
  out.aggregated = upperEnvelope(sets);
  out.force_n = compiled.evaluateExpert(index, point).force_n;
  return out;
}

}  // namespace

base::Result<Explanation> explain(const ForceModel& model, const fuzzy::CompiledModel& compiled,
                                  std::span<const double> inputs) {
  if (inputs.size() != model.inputs.size()) {
    return base::fail(base::ErrorCode::kValue, "", std::to_string(inputs.size()) + " input values",
                      std::to_string(model.inputs.size()) + ", one per input");
  }
  Explanation out;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!std::isfinite(inputs[i])) {
      return base::fail(base::ErrorCode::kValue, model.inputs[i].id, base::formatNumber(inputs[i]), "a finite number");
    }
    out.inputs.push_back({model.inputs[i].id, inputs[i], compiled.clampInput(i, inputs[i])});
  }

  double weights = 0;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    out.experts.push_back(explainExpert(model, compiled, e, out.inputs, inputs));
    if (!out.experts.back().abstains) weights += compiled.normalizedWeight(e);
  }
  for (std::size_t e = 0; e < out.experts.size(); ++e) {
    auto& expert = out.experts[e];
    if (expert.abstains || weights == 0) continue;
    expert.weight_share = compiled.normalizedWeight(e) / weights;
    expert.contribution_n = expert.weight_share * expert.force_n;
  }
  const auto force = compiled.evaluate(inputs);
  out.force_n = force.force_n;
  out.fired = force.fired;
  out.is_default = !force.fired;
  return out;
}

}  // namespace tactus::analysis
