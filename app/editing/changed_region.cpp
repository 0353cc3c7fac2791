#include <algorithm>
#include <set>
#include <tuple>

#include "app/editing/edit_impact.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::editing {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::Variable;

/// A range of one input: everything where it is not limited.
struct Span {
  double low;
  double high;
};

Span supportOf(const Term& term, const Variable& variable) {
  const auto [low, high] = fuzzy::supportOf(fuzzy::MembershipFunction::of(term));
  return {std::clamp(low, variable.min, variable.max), std::clamp(high, variable.min, variable.max)};
}

bool sameFunction(const Term& one, const Term& other) { return one.shape == other.shape && one.points == other.points; }

class Region {
 public:
  explicit Region(const ForceModel& model) : model_(model) {}

  void addEverything() {
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) hull(i, {model_.inputs[i].min, model_.inputs[i].max});
  }

  /// The box in which `term` of one input holds.
  void addTerm(std::size_t input, const Term& term) {
    const Span support = supportOf(term, model_.inputs[input]);
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      hull(i, i == input ? support : Span{model_.inputs[i].min, model_.inputs[i].max});
    }
  }

  /// The box in which a rule can fire.
  void addRule(const Expert& expert, const Rule& rule) {
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      const Variable& input = model_.inputs[i];
      Span box{input.min, input.max};
      for (const auto& condition : rule.conditions) {
        const Term* const term =
            condition.input == input.id ? findTerm(termsFor(expert, input), condition.term) : nullptr;
        if (term != nullptr) box = supportOf(*term, input);
      }
      hull(i, box);
    }
  }

  std::vector<analysis::InputRange> ranges() const { return ranges_; }

 private:
  void hull(std::size_t input, Span span) {
    const Variable& variable = model_.inputs[input];
    if (ranges_.size() <= input) {
      ranges_.push_back({variable.id, span.low, span.high, true, true, false});
    } else {
      ranges_[input].low = std::min(ranges_[input].low, span.low);
      ranges_[input].high = std::max(ranges_[input].high, span.high);
    }
    ranges_[input].whole_universe = ranges_[input].low == variable.min && ranges_[input].high == variable.max;
  }

  const ForceModel& model_;
  std::vector<analysis::InputRange> ranges_;
};

void addTerms(std::size_t input, const std::vector<Term>& before, const std::vector<Term>& after, Region& region) {
  const auto add_missing = [&](const std::vector<Term>& from, const std::vector<Term>& in) {
    for (const Term& term : from) {
      const Term* const other = findTerm(in, term.id);
      if (other == nullptr || !sameFunction(term, *other)) region.addTerm(input, term);
    }
  };
  add_missing(before, after);
  add_missing(after, before);
}

bool sameOutput(const std::vector<Term>& before, const std::vector<Term>& after) {
  return before.size() == after.size() &&
         std::equal(before.begin(), before.end(), after.begin(),
                    [](const Term& a, const Term& b) { return a.id == b.id && sameFunction(a, b); });
}

using RuleKey = std::tuple<std::vector<std::pair<std::string, std::string>>, std::string, double>;

RuleKey keyOf(const Rule& rule) {
  std::vector<std::pair<std::string, std::string>> conditions;
  for (const auto& condition : rule.conditions) conditions.emplace_back(condition.input, condition.term);
  std::sort(conditions.begin(), conditions.end());
  return {std::move(conditions), rule.then, rule.weight};
}

void addRules(const Expert& before, const Expert& after, Region& region) {
  if (before.rules == after.rules) return;
  const auto add_missing = [&](const Expert& from, const Expert& in) {
    std::set<RuleKey> known;
    for (const Rule& rule : in.rules) {
      if (fuzzy::takesPart(rule)) known.insert(keyOf(rule));
    }
    for (const Rule& rule : from.rules) {
      if (fuzzy::takesPart(rule) && !known.contains(keyOf(rule))) region.addRule(from, rule);
    }
  };
  add_missing(before, after);
  add_missing(after, before);
}

/// Whether a number that holds everywhere is another one.
bool differEverywhere(const ForceModel& before, const ForceModel& after) {
  if (before.implication != after.implication || before.experts.size() != after.experts.size()) return true;
  if (before.output.min != after.output.min || before.output.max != after.output.max) return true;
  for (std::size_t e = 0; e < before.experts.size(); ++e) {
    const Expert& one = before.experts[e];
    const Expert& other = after.experts[e];
    if (one.id != other.id || one.weight != other.weight) return true;
    if (!sameOutput(termsFor(one, before.output), termsFor(other, after.output))) return true;
  }
  for (std::size_t i = 0; i < before.inputs.size(); ++i) {
    if (before.inputs[i].min != after.inputs[i].min || before.inputs[i].max != after.inputs[i].max) return true;
  }
  return false;
}

}  // namespace

std::vector<analysis::InputRange> changedRegion(const ForceModel& before, const ForceModel& after) {
  Region region(after);
  if (differEverywhere(before, after)) {
    region.addEverything();
    return region.ranges();
  }
  for (std::size_t e = 0; e < after.experts.size(); ++e) {
    if (after.experts[e].weight == 0) continue;
    for (std::size_t i = 0; i < after.inputs.size(); ++i) {
      addTerms(i, termsFor(before.experts[e], before.inputs[i]), termsFor(after.experts[e], after.inputs[i]), region);
    }
    addRules(before.experts[e], after.experts[e], region);
  }
  return region.ranges();
}

}  // namespace tactus::editing
