#include "app/editing/rule_edits.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/term_list.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;

std::string number(std::size_t index) { return "rule " + std::to_string(index + 1); }

Result<void> checkIndex(const Expert& expert, std::size_t index) {
  if (index < expert.rules.size()) return {};
  return fail(ErrorCode::kReference, labelOf(expert), number(index),
              "one of the " + std::to_string(expert.rules.size()) + " rules");
}

/// The rule in words with its consequent: `S4: IF Speed is Slow THEN Small`.
std::string ruleText(const ForceModel& model, const Expert& expert, const Rule& rule) {
  return labelOf(expert) + ": " + conditionsText(model, expert, rule) + " THEN " +
         consequentText(model, expert, rule.then);
}

std::string text(const ForceModel& model, const Expert& expert, std::span<const std::size_t> indices) {
  if (indices.size() == 1) return ruleText(model, expert, expert.rules[indices.front()]);
  return labelOf(expert) + ": " + std::to_string(indices.size()) + " rules";
}

/// The conditions in an order that does not depend on how they were written.
std::vector<std::pair<std::string, std::string>> sortedConditions(const Rule& rule) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& condition : rule.conditions) out.emplace_back(condition.input, condition.term);
  std::sort(out.begin(), out.end());
  return out;
}

/// A copy of the model in which rules of one expert are changed. `change` gets the copy and the expert and returns the
/// label; the indices are in range.
template <class Change>
Result<Edit> changed(const ForceModel& model, const std::string& expert_id, std::span<const std::size_t> indices,
                     const Change& change) {
  ForceModel out = model;
  TACTUS_TRY(const auto expert, findExpert(out, expert_id));
  for (const std::size_t index : indices) {
    if (auto ok = checkIndex(*expert, index); !ok) return tl::unexpected(ok.error());
  }
  std::string label = change(out, *expert);
  return finished(std::move(out), std::move(label));
}

/// Refuses what only a person who looks at a list of rules would do; everything else is refused by `finished`.
Result<void> checkRule(const Expert& expert, const Rule& rule, std::optional<std::size_t> instead_of) {
  if (rule.conditions.empty()) {
    return fail(ErrorCode::kValue, labelOf(expert), "a rule without a condition", "one condition or more");
  }
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    if (r == instead_of || expert.rules[r].then != rule.then || !sameConditions(expert.rules[r], rule)) continue;
    return fail(ErrorCode::kValue, labelOf(expert), "the same as " + number(r), "a new rule");
  }
  return {};
}

/// The rule of `expert`, among those not yet taken, whose place `rule` takes: the same one, or else the first with the
/// same conditions. The number of `taken` if there is none.
std::size_t placeFor(const Rule& rule, const Expert& expert, const std::vector<bool>& taken) {
  std::size_t place = taken.size();
  for (std::size_t r = taken.size(); r-- > 0;) {
    if (taken[r] || !sameConditions(expert.rules[r], rule)) continue;
    if (expert.rules[r].then == rule.then) return r;
    place = r;
  }
  return place;
}

Result<void> checkAny(std::span<const std::size_t> indices) {
  if (!indices.empty()) return {};
  return fail(ErrorCode::kValue, "rules", "none", "one or more");
}

}  // namespace

Rule inOrderOfInputs(const ForceModel& model, Rule rule) {
  const auto place = [&model](const fuzzy::Condition& condition) {
    return std::find_if(model.inputs.begin(), model.inputs.end(),
                        [&](const fuzzy::Variable& input) { return input.id == condition.input; });
  };
  std::stable_sort(rule.conditions.begin(), rule.conditions.end(),
                   [&](const auto& one, const auto& other) { return place(one) < place(other); });
  return rule;
}

bool sameConditions(const Rule& one, const Rule& other) {
  return one.conditions.size() == other.conditions.size() &&
         std::is_permutation(one.conditions.begin(), one.conditions.end(), other.conditions.begin());
}

std::vector<std::size_t> conflictingRules(const Expert& expert) {
  std::map<std::vector<std::pair<std::string, std::string>>, std::vector<std::size_t>> alike;
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    const Rule& rule = expert.rules[r];
    if (fuzzy::takesPart(rule)) alike[sortedConditions(rule)].push_back(r);
  }
  std::vector<std::size_t> out;
  for (const auto& same : alike) {
    const auto& rules = same.second;
    const bool agree = std::all_of(rules.begin(), rules.end(),
                                   [&](std::size_t r) { return expert.rules[r].then == expert.rules[rules[0]].then; });
    if (!agree) out.insert(out.end(), rules.begin(), rules.end());
  }
  std::sort(out.begin(), out.end());
  return out;
}

Result<Edit> addRule(const ForceModel& model, const std::string& expert_id, Rule rule) {
  if (const auto expert = findExpert(model, expert_id)) {
    if (auto ok = checkRule(**expert, rule, std::nullopt); !ok) return tl::unexpected(ok.error());
  }
  return changed(model, expert_id, {}, [&](ForceModel& out, Expert& expert) {
    expert.rules.push_back(inOrderOfInputs(out, std::move(rule)));
    return ruleText(out, expert, expert.rules.back()) + ", added";
  });
}

Result<Edit> replaceRule(const ForceModel& model, const std::string& expert_id, std::size_t index, Rule rule) {
  if (const auto expert = findExpert(model, expert_id)) {
    if (auto ok = checkRule(**expert, rule, index); !ok) return tl::unexpected(ok.error());
  }
  return changed(model, expert_id, std::span(&index, 1), [&](ForceModel& out, Expert& expert) {
    expert.rules[index] = inOrderOfInputs(out, std::move(rule));
    return ruleText(out, expert, expert.rules[index]) + ", " + number(index) + " rewritten";
  });
}

Result<Edit> setConsequent(const ForceModel& model, const std::string& expert_id, std::span<const std::size_t> indices,
                           const std::string& then) {
  if (auto ok = checkAny(indices); !ok) return tl::unexpected(ok.error());
  if (const auto expert = findExpert(model, expert_id)) {
    // Of the rules as they would be, none may be the same as another one.
    Expert after = **expert;
    for (const std::size_t index : indices) {
      if (index < after.rules.size()) after.rules[index].then = then;
    }
    for (const std::size_t index : indices) {
      if (index >= after.rules.size()) continue;
      if (auto ok = checkRule(after, after.rules[index], index); !ok) return tl::unexpected(ok.error());
    }
  }
  return changed(model, expert_id, indices, [&](ForceModel& out, Expert& expert) {
    if (indices.size() > 1) {
      for (const std::size_t index : indices) expert.rules[index].then = then;
      return text(out, expert, indices) + " THEN " + consequentText(out, expert, then);
    }
    Rule& rule = expert.rules[indices.front()];
    const std::string before = std::exchange(rule.then, then);
    return labelOf(expert) + ": " + conditionsText(out, expert, rule) + ": " + consequentText(out, expert, before) +
           " to " + consequentText(out, expert, then);
  });
}

Result<Edit> setRuleWeight(const ForceModel& model, const std::string& expert_id, std::span<const std::size_t> indices,
                           double weight) {
  if (auto ok = checkAny(indices); !ok) return tl::unexpected(ok.error());
  return changed(model, expert_id, indices, [&](ForceModel& out, Expert& expert) {
    if (indices.size() > 1) {
      for (const std::size_t index : indices) expert.rules[index].weight = weight;
      return text(out, expert, indices) + ", weight " + base::formatNumber(weight);
    }
    Rule& rule = expert.rules[indices.front()];
    const double before = std::exchange(rule.weight, weight);
    return ruleText(out, expert, rule) + ", weight " + base::formatNumber(before) + " to " + base::formatNumber(weight);
  });
}

Result<Edit> setConsequent(const ForceModel& model, const std::string& expert, std::size_t index,
                           const std::string& then) {
  return setConsequent(model, expert, std::span(&index, 1), then);
}

Result<Edit> setRuleWeight(const ForceModel& model, const std::string& expert, std::size_t index, double weight) {
  return setRuleWeight(model, expert, std::span(&index, 1), weight);
}

Result<Edit> enableRules(const ForceModel& model, const std::string& expert_id, std::span<const std::size_t> indices,
                         bool enabled) {
  if (auto ok = checkAny(indices); !ok) return tl::unexpected(ok.error());
  return changed(model, expert_id, indices, [&](ForceModel& out, Expert& expert) {
    for (const std::size_t index : indices) expert.rules[index].enabled = enabled;
    return text(out, expert, indices) + (enabled ? ", enabled" : ", disabled");
  });
}

Result<Edit> removeRules(const ForceModel& model, const std::string& expert_id, std::span<const std::size_t> indices) {
  if (auto ok = checkAny(indices); !ok) return tl::unexpected(ok.error());
  return changed(model, expert_id, indices, [&](ForceModel& out, Expert& expert) {
    std::string label = text(out, expert, indices) + ", removed";
    std::vector<Rule> kept;
    for (std::size_t r = 0; r < expert.rules.size(); ++r) {
      if (std::find(indices.begin(), indices.end(), r) == indices.end()) kept.push_back(std::move(expert.rules[r]));
    }
    expert.rules = std::move(kept);
    return label;
  });
}

Result<Edit> putRules(const ForceModel& model, const std::string& expert_id, std::span<const Rule> rules) {
  if (rules.empty()) return fail(ErrorCode::kValue, "rules", "none", "one or more");
  return changed(model, expert_id, {}, [&](ForceModel& out, Expert& expert) {
    const std::size_t known = expert.rules.size();
    std::vector<bool> taken(known);
    std::vector<const Rule*> put;
    std::size_t added = 0;
    for (const Rule& rule : rules) {
      const auto same = [&](const Rule* one) { return one->then == rule.then && sameConditions(*one, rule); };
      if (std::any_of(put.begin(), put.end(), same)) continue;
      put.push_back(&rule);
      const std::size_t place = placeFor(rule, expert, taken);
      if (place == known) {
        expert.rules.push_back(inOrderOfInputs(out, rule));
        ++added;
        continue;
      }
      taken[place] = true;
      expert.rules[place].then = rule.then;
      expert.rules[place].weight = rule.weight;
      expert.rules[place].enabled = rule.enabled;
    }
    return labelOf(expert) + ": " + std::to_string(put.size()) + (put.size() == 1 ? " rule" : " rules") + " pasted, " +
           std::to_string(added) + " of them new";
  });
}

Result<Edit> setExpertWeight(const ForceModel& model, const std::string& expert_id, double weight) {
  return changed(model, expert_id, {}, [&](ForceModel&, Expert& expert) {
    const double before = std::exchange(expert.weight, weight);
    return labelOf(expert) + ": share in the mean " + base::formatNumber(before) + " to " + base::formatNumber(weight);
  });
}

}  // namespace tactus::editing
