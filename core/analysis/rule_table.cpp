#include "core/analysis/rule_table.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

static_assert(fuzzy::kMostInputs * 7 <= 64 && fuzzy::kMostTerms < 0x7F, "the conditions of a rule fit into 64 bits");

std::size_t indexOf(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  const fuzzy::Term* const term = findTerm(terms, id);
  TACTUS_CHECK(term != nullptr);
  return static_cast<std::size_t>(term - terms.data());
}

}  // namespace

std::vector<ResolvedRule> resolveRules(const fuzzy::ForceModel& model, const fuzzy::Expert& expert) {
  std::vector<ResolvedRule> out;
  const auto& output_terms = termsFor(expert, model.output);
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    const auto& rule = expert.rules[r];
    if (!rule.enabled || rule.weight == 0) continue;
    ResolvedRule resolved{r, 0, indexOf(output_terms, rule.then), rule.weight};
    for (const auto& condition : rule.conditions) {
      const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                      [&](const fuzzy::Variable& v) { return v.id == condition.input; });
      TACTUS_CHECK(input != model.inputs.end());
      const auto position = static_cast<std::uint64_t>(input - model.inputs.begin());
      resolved.conditions |= (indexOf(termsFor(expert, *input), condition.term) + 1) << (7 * position);
    }
    out.push_back(resolved);
  }
  return out;
}

double peakPosition(const fuzzy::Term& term, double min, double max) {
  const auto f = fuzzy::MembershipFunction::of(term);
  if (f.gaussian) return std::clamp(f.mean, min, max);
  const double left = std::clamp(f.b, min, max);
  const double right = std::clamp(f.c, min, max);
  return left + (right - left) / 2;
}

double largestStrength(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const ResolvedRule& rule) {
  double peak = 1;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (rule.termOf(i) < 0) continue;
    const auto& input = model.inputs[i];
    const auto& term = termsFor(expert, input)[static_cast<std::size_t>(rule.termOf(i))];
    peak = std::min(peak, fuzzy::MembershipFunction::of(term)(peakPosition(term, input.min, input.max)));
  }
  return peak == 0 ? 0 : std::max(rule.weight * peak, 5e-324);
}

std::vector<double> largestStrengths(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                     std::span<const ResolvedRule> rules) {
  std::vector<double> largest(termsFor(expert, model.output).size());
  for (const auto& rule : rules) {
    largest[rule.then] = std::max(largest[rule.then], largestStrength(model, expert, rule));
  }
  return largest;
}

}  // namespace tactus::analysis
