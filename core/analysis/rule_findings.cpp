#include "core/analysis/rule_findings.h"

#include <array>
#include <unordered_map>

#include "core/base/check.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::analysis {

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

}  // namespace tactus::analysis
