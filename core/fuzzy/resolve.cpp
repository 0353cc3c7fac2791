#include "core/fuzzy/resolve.h"

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/fuzzy/flat_map.h"
#include "core/fuzzy/model_checks.h"

namespace tactus::fuzzy {
namespace {

using base::ErrorCode;
using base::fail;
using base::quoted;
using base::Result;

NameList namesOf(const std::vector<Term>& terms) {
  NameList names;
  names.reserve(terms.size());
  for (const Term& term : terms) names.add(term.id);
  return names;
}

/// Names of the model's variables and of their own terms; the output comes after the inputs.
struct ModelNames {
  NameList variables;
  std::array<NameList, kMostInputs + 1> terms;

  explicit ModelNames(const ForceModel& model) {
    for (std::size_t i = 0; i <= model.inputs.size(); ++i) {
      variables.add(variableOf(model, i).id);
      terms[i] = namesOf(variableOf(model, i).terms);
    }
  }

  static const Variable& variableOf(const ForceModel& model, std::size_t index) {
    return index < model.inputs.size() ? model.inputs[index] : model.output;
  }
};

class ExpertResolver {
 public:
  ExpertResolver(const ForceModel& model, const ModelNames& names, const Expert& expert)
      : model_(model), names_(names), expert_(expert), output_(model.inputs.size()) {
    for (std::size_t i = 0; i <= output_; ++i) terms_[i] = &names.terms[i];
  }

  Result<void> resolve(const Place& place, RuleTable& table) {
    constexpr double kAnyWeight = std::numeric_limits<double>::max();
    if (auto ok = checkNumber(expert_.weight, 0, kAnyWeight, place["weight"]); !ok) return ok;
    if (auto ok = readOverrides(place["terms"]); !ok) return ok;
    const std::size_t count = expert_.rules.size();
    const Place rules = place["rules"];
    if (count > kMostRules) {
      return fail(ErrorCode::kLimit, rules.text(), std::to_string(count) + " rules",
                  "at most " + std::to_string(kMostRules));
    }
    table.weight = expert_.weight;
    table.rules.reserve(count);
    table.conditions.reserve(2 * count);
    FlatMap seen(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint64_t key = 0;
      if (!addRule(expert_.rules[i], rules[i], table, key)) return tl::unexpected(std::move(*error_));
      if (seen.findOrAdd(key, static_cast<std::uint32_t>(i)) != i) {
        return fail(ErrorCode::kSchema, rules[i].text(),
                    "a rule with the conditions and the consequent of an earlier one", "each rule once");
      }
    }
    return {};
  }

 private:
  Result<void> readOverrides(const Place& place) {
    for (const auto& own : expert_.overrides) {
      const Place at = place[own.variable];
      const auto variable = names_.variables.find(own.variable);
      if (!variable) {
        return fail(ErrorCode::kReference, at.text(), quoted(own.variable), "the id of a variable of the model");
      }
      if (terms_[*variable] != &names_.terms[*variable]) {
        return fail(ErrorCode::kSchema, at.text(), quoted(own.variable) + " twice", "one list of terms for a variable");
      }
      if (auto ok = checkTerms(own.terms, *variable == output_ ? &model_.output : nullptr, at); !ok) return ok;
      own_terms_[*variable] = namesOf(own.terms);
      terms_[*variable] = &own_terms_[*variable];
    }
    return {};
  }

  /// `key` becomes a number that no other rule has: seven bits for the term of each input, and the output term.
  /// Returns false and sets `error_` where something is wrong: rules are many, and a Result is large.
  bool addRule(const Rule& rule, const Place& place, RuleTable& table, std::uint64_t& key) {
    if (rule.conditions.empty()) {
      return refuse(ErrorCode::kSchema, place["if"], "a rule without a condition", "one condition or more");
    }
    const std::size_t first_condition = table.conditions.size();
    for (const Condition& condition : rule.conditions) {
      const auto input = names_.variables.find(condition.input);
      if (!input || *input == output_) {
        return refuse(ErrorCode::kReference, place["if"][condition.input], quoted(condition.input),
                      "the id of an input of the model");
      }
      if ((key >> 7U * *input & 0x7FU) != 0) {
        return refuse(ErrorCode::kSchema, place["if"][condition.input], quoted(condition.input) + " twice",
                      "each input once in a rule");
      }
      const auto term = terms_[*input]->find(condition.term);
      if (!term) return refuseTerm(*input, condition.term, place["if"][condition.input]);
      key |= (*term + std::uint64_t{1}) << 7U * *input;
      table.conditions.push_back({static_cast<std::uint8_t>(*input), static_cast<std::uint8_t>(*term)});
    }
    const auto then = terms_[output_]->find(rule.then);
    if (!then) return refuseTerm(output_, rule.then, place["then"]);
    key |= std::uint64_t{*then} << 7U * kMostInputs;
    if (!isWithin(rule.weight, 0, 1)) {
      error_ = checkNumber(rule.weight, 0, 1, place["weight"]).error();
      return false;
    }
    if (!rule.enabled || rule.weight == 0) {
      table.conditions.resize(first_condition);
      return true;
    }
    table.rules.push_back({static_cast<std::uint32_t>(first_condition),
                           static_cast<std::uint16_t>(rule.conditions.size()), static_cast<std::uint16_t>(*then),
                           rule.weight});
    return true;
  }

  bool refuse(ErrorCode code, const Place& place, std::string found, std::string wanted) {
    error_ = base::Error{code, {}, place.text(), std::move(found), std::move(wanted)};
    return false;
  }

  bool refuseTerm(std::size_t index, const std::string& id, const Place& place) {
    const Variable& variable = ModelNames::variableOf(model_, index);
    std::string known;
    for (const Term& term : termsFor(expert_, variable)) known += (known.empty() ? "" : ", ") + term.id;
    return refuse(ErrorCode::kReference, place, quoted(id), "a term of " + quoted(variable.id) + ": " + known);
  }

  const ForceModel& model_;
  const ModelNames& names_;
  const Expert& expert_;
  const std::size_t output_;
  std::array<const NameList*, kMostInputs + 1> terms_{};  ///< as this expert understands them
  std::array<NameList, kMostInputs + 1> own_terms_;
  std::optional<base::Error> error_;
};

}  // namespace

Result<void> resolveExperts(const ForceModel& model, std::vector<RuleTable>& tables) {
  const Place root;
  const Place experts = root["experts"];
  if (auto ok = checkCount(model.experts.size(), kMostExperts, "experts", experts); !ok) return ok;
  const ModelNames names(model);
  NameList ids;
  bool weighty = false;
  tables.reserve(model.experts.size());
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    const Place place = experts[i];
    if (auto ok = checkUnique(ids, model.experts[i].id, place["id"]); !ok) return ok;
    if (auto ok = ExpertResolver(model, names, model.experts[i]).resolve(place, tables.emplace_back()); !ok) return ok;
    weighty = weighty || model.experts[i].weight > 0;
  }
  if (!weighty) {
    return fail(ErrorCode::kValue, experts.text(), "only experts of weight 0", "one expert or more with a weight > 0");
  }
  return {};
}

}  // namespace tactus::fuzzy
