#include "core/fuzzy/resolve.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string>

#include "core/base/text.h"
#include "core/fuzzy/flat_map.h"
#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {
namespace {

using base::ErrorCode;

const Variable& variableOf(const ForceModel& model, std::size_t index) {
  return index < model.inputs.size() ? model.inputs[index] : model.output;
}

/// Reads one expert after the other. Experts mostly answer the same items in the same order, so each rule is first
/// compared with the same one of the expert before.
class Resolver {
 public:
  Resolver(const ForceModel& model, const ModelNames& names, ModelTables& tables)
      : model_(model), names_(names), output_(model.inputs.size()), tables_(tables), by_key_(usualRules(model)) {
    std::size_t rules = 0;
    for (const Expert& expert : model.experts) rules += expert.rules.size();
    tables.experts.reserve(model.experts.size());
    tables.rules.reserve(rules);
    tables.premises.reserve(usualRules(model));
    tables.conditions.reserve(2 * usualRules(model));
    premise_of_.reserve(usualRules(model));
    seen_.reserve(usualRules(model));
  }

  Problem read(const Expert& expert, const Place& place) {
    constexpr double kAnyWeight = std::numeric_limits<double>::max();
    if (auto wrong = checkNumber(expert.weight, 0, kAnyWeight, place["weight"])) return wrong;
    expert_ = &expert;
    const bool terms_were_usual = terms_are_usual_;
    if (auto wrong = readOverrides(place["terms"])) return wrong;
    const std::size_t count = expert.rules.size();
    const Place rules = place["rules"];
    if (count > kMostRules) {
      return problem(ErrorCode::kLimit, rules, std::to_string(count) + " rules",
                     "at most " + std::to_string(kMostRules));
    }
    if (!terms_are_usual_ || !terms_were_usual) before_ = {};
    const std::uint32_t first = sizeOf(tables_.rules);
    premise_of_.resize(count);
    const std::size_t read = readRules(expert.rules);
    if (read < count) return problemOf(expert.rules[read], rules[read]);
    before_ = expert.rules;
    ExpertTable& table = tables_.experts.emplace_back();
    table.given_weight = expert.weight;
    table.rules = {first, sizeOf(tables_.rules) - first};
    return nullptr;
  }

 private:
  /// Output terms that follow from a premise in the rules of one expert.
  struct Seen {
    const Expert* expert = nullptr;
    std::uint64_t terms = 0;
  };

  static std::size_t usualRules(const ForceModel& model) { return model.experts.front().rules.size(); }

  /// Sets what the names of terms mean to the expert.
  Problem readOverrides(const Place& place) {
    for (std::size_t i = 0; i <= output_; ++i) terms_[i] = &names_.terms[i];
    terms_are_usual_ = true;
    for (const auto& own : expert_->overrides) {
      const Place at = place[own.variable];
      const std::size_t variable = names_.variables.find(own.variable);
      if (variable == NameList::kNone) {
        return problem(ErrorCode::kReference, at, base::quoted(own.variable), "the id of a variable of the model");
      }
      NameList& names = own_terms_[variable];
      if (terms_[variable] == &names) {
        return problem(ErrorCode::kSchema, at, base::quoted(own.variable) + " twice",
                       "one list of terms for a variable");
      }
      if (auto wrong = checkTerms(own.terms, variable == output_ ? &model_.output : nullptr, at, names)) return wrong;
      terms_[variable] = &names;
      terms_are_usual_ = terms_are_usual_ && names == names_.terms[variable];
    }
    return nullptr;
  }

  /// Returns how many it could read.
  [[gnu::noinline]] std::size_t readRules(std::span<const Rule> rules) {
    const NameList& output_terms = *terms_[output_];
    for (std::size_t i = 0; i < rules.size(); ++i) {
      const Rule& rule = rules[i];
      const bool is_known = i < before_.size() && areSame(rule.conditions, before_[i].conditions);
      if (!is_known && !findPremise(rule.conditions, premise_of_[i])) return i;
      const std::size_t then = output_terms.find(rule.then);
      if (then == NameList::kNone || !isWithin(rule.weight, 0, 1) || !isNew(premise_of_[i], then)) return i;
      if (takesPart(rule)) {
        tables_.rules.push_back({rule.weight, premise_of_[i], static_cast<std::uint16_t>(then)});
      }
    }
    return rules.size();
  }

  static bool areSame(const std::vector<Condition>& a, const std::vector<Condition>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Condition& x, const Condition& y) {
      return isSameId(x.input, y.input) && isSameId(x.term, y.term);
    });
  }

  /// The premise with these conditions, new or known; false where something is wrong with them.
  [[gnu::noinline]] bool findPremise(const std::vector<Condition>& conditions, std::uint32_t& premise) {
    const std::uint32_t first = sizeOf(tables_.conditions);
    std::uint64_t key = 0;  // seven bits for the term of each input
    for (const Condition& condition : conditions) {
      const std::size_t input = names_.variables.find(condition.input);
      if (input >= output_ || (key >> 7U * input & 0x7FU) != 0) return false;
      const std::size_t term = terms_[input]->find(condition.term);
      if (term == NameList::kNone) return false;
      key |= (term + std::uint64_t{1}) << 7U * input;
      tables_.conditions.push_back({static_cast<std::uint8_t>(input), static_cast<std::uint8_t>(term)});
    }
    if (key == 0) return false;
    const std::uint32_t next = sizeOf(tables_.premises);
    premise = by_key_.findOrAdd(key, next);
    if (premise == next) {
      tables_.premises.push_back({first, sizeOf(tables_.conditions) - first});
      seen_.emplace_back();
    } else {
      tables_.conditions.resize(first);
    }
    return true;
  }

  /// Whether the output term follows from the premise for the first time in the rules of this expert.
  bool isNew(std::uint32_t premise, std::size_t then) {
    Seen& seen = seen_[premise];
    if (seen.expert != expert_) seen = {expert_, 0};
    const std::uint64_t bit = std::uint64_t{1} << then;
    const bool is_new = (seen.terms & bit) == 0;
    seen.terms |= bit;
    return is_new;
  }

  /// What is wrong with a rule that cannot be read.
  Problem problemOf(const Rule& rule, const Place& place) const {
    const Place premise = place["if"];
    if (rule.conditions.empty()) {
      return problem(ErrorCode::kSchema, premise, "a rule without a condition", "one condition or more");
    }
    NameList known;
    for (const Condition& condition : rule.conditions) {
      const Place at = premise[condition.input];
      const std::size_t input = names_.variables.find(condition.input);
      if (input >= output_) {
        return problem(ErrorCode::kReference, at, base::quoted(condition.input), "the id of an input of the model");
      }
      if (!known.add(condition.input)) {
        return problem(ErrorCode::kSchema, at, base::quoted(condition.input) + " twice", "each input once in a rule");
      }
      if (terms_[input]->find(condition.term) == NameList::kNone) return unknownTerm(input, condition.term, at);
    }
    if (terms_[output_]->find(rule.then) == NameList::kNone) return unknownTerm(output_, rule.then, place["then"]);
    if (auto wrong = checkNumber(rule.weight, 0, 1, place["weight"])) return wrong;
    return problem(ErrorCode::kSchema, place, "a rule with the conditions and the consequent of an earlier one",
                   "each rule once");
  }

  Problem unknownTerm(std::size_t index, const std::string& id, const Place& place) const {
    const Variable& variable = variableOf(model_, index);
    std::string known;
    for (const Term& term : termsFor(*expert_, variable)) known += (known.empty() ? "" : ", ") + term.id;
    return problem(ErrorCode::kReference, place, base::quoted(id),
                   "a term of " + base::quoted(variable.id) + ": " + known);
  }

  const ForceModel& model_;
  const ModelNames& names_;
  const std::size_t output_;
  ModelTables& tables_;
  const Expert* expert_ = nullptr;
  std::array<const NameList*, kMostInputs + 1> terms_{};  ///< as this expert understands them
  std::array<NameList, kMostInputs + 1> own_terms_;
  bool terms_are_usual_ = true;            ///< names of terms mean what they mean without lists of the expert's own
  std::span<const Rule> before_;           ///< rules of the last expert
  std::vector<std::uint32_t> premise_of_;  ///< for each of them
  FlatMap by_key_;                         ///< premises
  std::vector<Seen> seen_;                 ///< for each premise
};

}  // namespace

Problem resolveExperts(const ForceModel& model, const ModelNames& names, ModelTables& tables) {
  const Place root;
  const Place experts = root["experts"];
  if (auto wrong = checkCount(model.experts.size(), kMostExperts, "experts", experts)) return wrong;
  NameList ids;
  ids.reserve(model.experts.size());
  bool weighty = false;
  Resolver resolver(model, names, tables);
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    const Place place = experts[i];
    if (auto wrong = checkUnique(ids, model.experts[i].id, place["id"])) return wrong;
    if (auto wrong = resolver.read(model.experts[i], place)) return wrong;
    weighty = weighty || model.experts[i].weight > 0;
  }
  if (weighty) return nullptr;
  return problem(ErrorCode::kValue, experts, "only experts of weight 0", "one expert or more with a weight > 0");
}

}  // namespace tactus::fuzzy
