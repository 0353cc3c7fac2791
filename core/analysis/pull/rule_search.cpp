#include "core/analysis/pull/rule_search.h"

#include <algorithm>

#include "core/analysis/directions.h"
#include "core/fuzzy/takes_part.h"

namespace tactus::analysis {
namespace {

using fuzzy::Condition;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;

bool sameConditions(const Rule& one, const Rule& other) {
  return one.conditions.size() == other.conditions.size() &&
         std::is_permutation(one.conditions.begin(), one.conditions.end(), other.conditions.begin());
}

PullEdit wordEdit(const Expert& expert, std::size_t rule, const std::vector<fuzzy::Term>& words, const TermOrder& order,
                  std::size_t word) {
  const auto placeOf = [&](std::size_t w) {
    return static_cast<double>(std::find(order.begin(), order.end(), w) - order.begin());
  };
  const auto now = static_cast<std::size_t>(findTerm(words, expert.rules[rule].then) - words.data());
  return ruleEdit(Gesture::kWord, expert.id, rule, placeOf(word) - placeOf(now), words[word].id);
}

/// The words that rule number `rule` could have, as edits.
std::vector<PullEdit> wordEdits(const ForceModel& model, const Expert& expert, std::size_t rule) {
  const auto& words = termsFor(expert, model.output);
  const TermOrder order = byMiddleOfCore(words);
  std::vector<PullEdit> out;
  for (std::size_t word = 0; word < words.size(); ++word) {
    if (words[word].id == expert.rules[rule].then) continue;
    const bool twice = std::any_of(expert.rules.begin(), expert.rules.end(), [&](const Rule& other) {
      return other.then == words[word].id && sameConditions(other, expert.rules[rule]);
    });
    if (!twice) out.push_back(wordEdit(expert, rule, words, order, word));
  }
  return out;
}

}  // namespace

std::size_t stepsAgainstDirection(const ForceModel& model, std::size_t expert) {
  std::size_t steps = 0;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    steps += direction(model, model.experts[expert], i).steps_against.size();
  }
  return steps;
}

std::vector<PullEdit> ruleEdits(const ForceModel& model, std::size_t expert) {
  const Expert& one = model.experts[expert];
  std::vector<PullEdit> out;
  for (std::size_t r = 0; r < one.rules.size(); ++r) {
    if (!fuzzy::takesPart(one.rules[r])) continue;
    const auto words = wordEdits(model, one, r);
    out.insert(out.end(), words.begin(), words.end());
    out.push_back(ruleEdit(Gesture::kOff, one.id, r));
  }
  return out;
}

std::vector<SearchedRule> searchRules(const PointForce& point, std::size_t expert, double target_n) {
  const ForceModel& model = point.model();
  const Expert& one = model.experts[expert];
  const auto& words = termsFor(one, model.output);
  const auto& rules = point.experts()[expert].rules;
  std::vector<SearchedRule> out;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    const PointRule& rule = rules[r];
    if (rule.membership <= 0) continue;
    for (PullEdit& edit : wordEdits(model, one, rule.index)) {
      const auto then = static_cast<std::size_t>(findTerm(words, edit.then) - words.data());
      const auto there = point.withRule(expert, r, then, rule.weight);
      if (there) out.push_back({std::move(edit), *there});
    }
    if (const auto there = point.withRule(expert, r, rule.then, 0)) {
      out.push_back({ruleEdit(Gesture::kOff, one.id, rule.index), *there});
    }
    std::vector<double> bends;
    for (const double strength : point.experts()[expert].strengths) {
      bends.push_back(strength / rule.membership - rule.weight);
    }
    const auto reach = searchDeltas(
        {-rule.weight, 1 - rule.weight},
        [&](double delta) { return point.withRule(expert, r, rule.then, rule.weight + delta); }, target_n, bends);
    const double weight = rule.weight + reach.exact.value_or(0);
    if (reach.exact && *reach.exact != 0 && weight > 0) {
      out.push_back({ruleEdit(Gesture::kWeight, one.id, rule.index, *reach.exact), target_n});
    }
  }
  return out;
}

}  // namespace tactus::analysis
