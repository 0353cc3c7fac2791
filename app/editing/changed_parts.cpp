#include "app/editing/changed_parts.h"

#include <algorithm>

namespace tactus::editing {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::Variable;

/// The rules of `after` that `before` does not have; a rule that only moved is none of them.
std::vector<std::size_t> otherRules(const std::vector<Rule>& before, const std::vector<Rule>& after) {
  std::vector<std::size_t> out;
  std::vector<bool> used(before.size());
  for (std::size_t r = 0; r < after.size(); ++r) {
    std::size_t same = 0;
    while (same < before.size() && (used[same] || !(before[same] == after[r]))) ++same;
    if (same == before.size()) {
      out.push_back(r);
    } else {
      used[same] = true;
    }
  }
  return out;
}

std::optional<std::string> otherTerm(const std::vector<Term>& before, const std::vector<Term>& after) {
  for (const Term& term : after) {
    const Term* const was = fuzzy::findTerm(before, term.id);
    if (was == nullptr || !(*was == term)) return term.id;
  }
  return std::nullopt;
}

std::optional<TermPlace> otherTermOf(const ForceModel& before, const ForceModel& after, const Variable& was,
                                     const Variable& now) {
  if (const auto term = otherTerm(was.terms, now.terms)) return TermPlace{{now.id, {}}, *term};
  for (const Expert& expert : after.experts) {
    const auto old = findExpert(before, expert.id);
    const TermListId list = listOf(expert, now.id);
    if (!old || list.expert.empty()) continue;
    if (const auto term = otherTerm(fuzzy::termsFor(**old, was), fuzzy::termsFor(expert, now))) {
      return TermPlace{list, *term};
    }
  }
  return std::nullopt;
}

}  // namespace

ChangedParts changedParts(const ForceModel& before, const ForceModel& after) {
  ChangedParts out;
  for (const Expert& expert : after.experts) {
    const auto was = findExpert(before, expert.id);
    if (!was || (*was)->rules == expert.rules) continue;
    out.expert = expert.id;
    out.rules = otherRules((*was)->rules, expert.rules);
    break;
  }
  const auto look = [&](const Variable& now) {
    const auto was = findVariable(before, now.id);
    if (was && !out.term) out.term = otherTermOf(before, after, **was, now);
  };
  for (const Variable& input : after.inputs) look(input);
  look(after.output);
  return out;
}

}  // namespace tactus::editing
