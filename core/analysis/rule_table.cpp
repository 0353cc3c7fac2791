#include "core/analysis/rule_table.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "core/base/check.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

/// For each term its place in the order of the centres, from 0; terms with the same centre share one.
std::vector<int> places(const std::vector<fuzzy::Term>& terms) {
  std::vector<double> centres;
  for (const auto& term : terms) {
    const auto f = fuzzy::MembershipFunction::of(term);
    // A quarter of each: their sum may be beyond the range of double.
    centres.push_back(f.gaussian ? f.mean : f.a / 4 + f.b / 4 + f.c / 4 + f.d / 4);
  }
  std::vector<double> order = centres;
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::vector<int> out;
  for (const double centre : centres) {
    out.push_back(static_cast<int>(std::lower_bound(order.begin(), order.end(), centre) - order.begin()));
  }
  return out;
}

}  // namespace

std::vector<NeighborStep> neighborSteps(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                        std::size_t input) {
  const auto along = places(termsFor(expert, model.inputs[input]));
  const auto levels = places(termsFor(expert, model.output));
  // By the other conditions, then by the place of the term along the input.
  std::map<std::uint64_t, std::map<int, std::vector<const ResolvedRule*>>> sequences;
  const auto rules = resolveRules(model, expert);
  for (const auto& rule : rules) {
    const int term = rule.termOf(input);
    if (term < 0) continue;
    const std::uint64_t others = rule.conditions & ~(std::uint64_t{0x7F} << (7 * input));
    sequences[others][along[static_cast<std::size_t>(term)]].push_back(&rule);
  }
  std::vector<NeighborStep> steps;
  for (const auto& [others, sequence] : sequences) {
    for (auto here = sequence.begin(); here != sequence.end(); ++here) {
      const auto next = std::next(here);
      if (next == sequence.end()) break;
      for (const auto* before : here->second) {
        for (const auto* after : next->second) {
          steps.push_back({input, before->index, after->index, levels[after->then] - levels[before->then],
                           next->first == here->first + 1});
        }
      }
    }
  }
  return steps;
}

std::string describe(const NeighborStep& step, const fuzzy::ForceModel& model, const fuzzy::Expert& expert) {
  const auto& before = expert.rules[step.before];
  const auto& after = expert.rules[step.after];
  std::vector<fuzzy::Condition> others = before.conditions;
  const auto along = std::find_if(others.begin(), others.end(), [&](const fuzzy::Condition& condition) {
    return condition.input == model.inputs[step.input].id;
  });
  TACTUS_CHECK(along != others.end());
  std::string text = along->input + " from " + along->term + " to ";
  others.erase(along);
  for (const auto& condition : after.conditions) {
    if (condition.input == model.inputs[step.input].id) text += condition.term;
  }
  if (!others.empty()) text += " where " + describe(std::move(others));
  return text + ", " + model.output.id + " from " + before.then + " to " + after.then;
}

std::string describe(std::vector<fuzzy::Condition> conditions) {
  std::sort(conditions.begin(), conditions.end(),
            [](const fuzzy::Condition& x, const fuzzy::Condition& y) { return x.input < y.input; });
  std::string text;
  for (const auto& condition : conditions) {
    if (!text.empty()) text += " and ";
    text += condition.input + " is " + condition.term;
  }
  return text;
}

std::vector<RulePair> conflicts(const std::vector<ResolvedRule>& rules) {
  std::vector<RulePair> out;
  std::unordered_map<std::uint64_t, std::size_t> first;
  for (const auto& rule : rules) {
    const auto [it, fresh] = first.emplace(rule.conditions, rule.index);
    if (!fresh) out.push_back({rule.index, it->second});
  }
  return out;
}

std::vector<RulePair> redundantRules(const std::vector<ResolvedRule>& rules, std::size_t input_count) {
  // One table per consequent. The number of a rule's conditions is small, so all subsets of them are looked up.
  std::array<std::unordered_map<std::uint64_t, const ResolvedRule*>, fuzzy::kMostTerms> tables;
  for (const auto& rule : rules) tables[rule.then].emplace(rule.conditions, &rule);
  std::vector<RulePair> out;
  for (const auto& rule : rules) {
    std::vector<std::uint64_t> parts;
    for (std::size_t i = 0; i < input_count; ++i) {
      const std::uint64_t part = rule.conditions & (std::uint64_t{0x7F} << (7 * i));
      if (part != 0) parts.push_back(part);
    }
    const std::size_t everything = (std::size_t{1} << parts.size()) - 1;
    for (std::size_t subset = 1; subset < everything; ++subset) {
      std::uint64_t conditions = 0;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if ((subset >> i & 1U) != 0) conditions |= parts[i];
      }
      const auto it = tables[rule.then].find(conditions);
      if (it == tables[rule.then].end() || it->second->weight < rule.weight) continue;
      out.push_back({rule.index, it->second->index});
      break;
    }
  }
  return out;
}

double forceOfTerm(const fuzzy::ForceModel& model, const fuzzy::Term& term, double strength) {
  fuzzy::ForceModel alone;
  alone.implication = model.implication;
  alone.inputs = {{"x", "x", "1", 0, 1, {{"any", "any", fuzzy::Shape::kTrapezoid, {0, 0, 1, 1}}}}};
  alone.output = model.output;
  alone.output.id = "y";
  alone.output.terms = {term};
  alone.experts = {{"one", "one", 1, {}, {{{{"x", "any"}}, term.id, strength, true}}}};
  const auto compiled = fuzzy::compile(alone);
  TACTUS_CHECK(compiled.has_value());
  return compiled->evaluate(std::array{0.5}).force_n;
}

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
