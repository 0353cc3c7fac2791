
#include "core/exchange/import/convert.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/exchange/import/foreign_model.h"
#include "core/exchange/import/rule_parser.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/validate.h"

namespace tactus::exchange {
namespace {

// Whether the norms, the defuzzifier and the activation of a foreign model are those of Tactus.

using base::ErrorCode;
using base::quoted;

/// What a method is called, in words and in the format.
struct Kind {
  const char* what;
  Meaning wanted;
  const char* keys[3];   ///< in FLL, FCL, FIS
  const char* words[3];  ///< of the wanted one
};

constexpr Kind kConjunction{
    "conjunction", Meaning::kMinimum, {"conjunction", "AND", "AndMethod"}, {"Minimum", "MIN", "min"}};
constexpr Kind kDisjunction{
    "disjunction", Meaning::kMaximum, {"disjunction", "OR", "OrMethod"}, {"Maximum", "MAX", "max"}};
constexpr Kind kImplication{"implication",
                            Meaning::kMinimum,
                            {"implication", "ACT", "ImpMethod"},
                            {"Minimum or AlgebraicProduct", "MIN or PROD", "min or prod"}};
constexpr Kind kAggregation{
    "aggregation", Meaning::kMaximum, {"aggregation", "ACCU", "AggMethod"}, {"Maximum", "MAX", "max"}};
constexpr Kind kDefuzzifier{
    "defuzzifier", Meaning::kCentroid, {"defuzzifier", "METHOD", "DefuzzMethod"}, {"Centroid", "COG", "centroid"}};

/// The defuzzifiers of systems whose terms are no fuzzy sets.
const char* systemOf(std::string_view word) {
  const std::string lower = base::lowered(word);
  const bool weighted = lower.starts_with("weighted") || lower.starts_with("wt") || lower == "cogs" || lower == "cogf";
  return weighted ? " of a Takagi-Sugeno or Tsukamoto system" : "";
}

class MethodChecker {
 public:
  explicit MethodChecker(const ForeignModel& model)
      : model_(model), source_(*model.source), format_(static_cast<std::size_t>(model.format)) {}

  /// An error unless `method` is the wanted one. A method that is not stated: the default of FCL and FIS.
  bool want(const std::optional<Method>& method, const Kind& kind, std::size_t at) {
    if (error_) return false;
    if (!method && model_.format != ImportFormat::kFll) {
      const std::string first = std::string(kind.words[format_]).substr(0, std::string(kind.words[format_]).find(' '));
      if (warned_.insert(kind.what).second)
        source_.warn(at, std::string(kind.keys[format_]) + " is not stated; " + first + " is taken");
      return true;
    }
    if (method && method->meaning == kind.wanted) return true;
    return refuse(method, kind, at);
  }

  /// Minimum or product.
  void wantImplication(const ForeignBlock& block, std::size_t at) {
    const bool scales = block.implication && block.implication->meaning == Meaning::kProduct;
    if (!scales && !want(block.implication, kImplication, at)) return;
    if (implication_ && *implication_ != scales) {
      error_ = source_.error(ErrorCode::kValue, at, "rule blocks with different implications",
                             "one for all rules of an output");
    }
    implication_ = scales;
  }

  void wantActivation(const ForeignBlock& block) {
    if (error_ || !block.activation) return;
    error_ = source_.error(ErrorCode::kValue, block.activation->word.at,
                           "the activation " + quoted(block.activation->word.text), "General: Tactus takes all rules");
  }

  const std::optional<base::Error>& error() const { return error_; }
  bool scales() const { return implication_.value_or(false); }

 private:
  bool refuse(const std::optional<Method>& method, const Kind& kind, std::size_t at) {
    const bool none = !method || method->meaning == Meaning::kNone;
    const std::size_t where = method && !method->word.text.empty() ? method->word.at : at;
    error_ = source_.error(
        ErrorCode::kValue, where,
        none ? std::string("no ") + kind.what
             : std::string("the ") + kind.what + " " + quoted(method->word.text) + systemOf(method->word.text),
        std::string(kind.words[format_]) + ", all that Tactus has");
    return false;
  }

  const ForeignModel& model_;
  SourceText& source_;
  std::size_t format_;
  std::set<std::string> warned_;
  std::optional<bool> implication_;
  std::optional<base::Error> error_;
};

/// Checks what `rules`, which all conclude on `output`, need: minimum for AND and maximum for OR where a rule uses
/// them, maximum as aggregation, the centroid, all rules active, one implication. Returns the implication. What FCL and
/// FIS do not state is the default of their programs, with a warning.
base::Result<fuzzy::Implication> checkMethods(const ForeignModel& model, const ForeignVariable& output,
                                              const std::vector<ResolvedRule>& rules) {
  MethodChecker checker(model);
  checker.want(output.defuzzifier, kDefuzzifier, output.name.at);
  std::set<std::size_t> blocks;
  for (const ResolvedRule& rule : rules) {
    const ForeignBlock& block = model.blocks[rule.rule->block];
    if (blocks.insert(rule.rule->block).second) {
      checker.want(output.aggregation ? output.aggregation : block.aggregation, kAggregation, output.name.at);
      checker.wantActivation(block);
      checker.wantImplication(block, rule.rule->at);
    }
    // IEC 61131-7 pairs MIN with MAX: stating one states the other.
    const bool paired = model.format == ImportFormat::kFcl;
    const bool is_max = block.disjunction && block.disjunction->meaning == Meaning::kMaximum;
    const bool is_min = block.conjunction && block.conjunction->meaning == Meaning::kMinimum;
    if (rule.rule->and_at && !(paired && !block.conjunction && is_max))
      checker.want(block.conjunction, kConjunction, *rule.rule->and_at);
    if (rule.rule->or_at && !(paired && !block.disjunction && is_min))
      checker.want(block.disjunction, kDisjunction, *rule.rule->or_at);
    if (checker.error()) break;
  }
  if (checker.error()) return tl::unexpected(*checker.error());
  return checker.scales() ? fuzzy::Implication::kScale : fuzzy::Implication::kClip;
}

using base::ErrorCode;
using base::quoted;

class ModelConverter {
 public:
  explicit ModelConverter(const ForeignModel& foreign) : foreign_(foreign), source_(*foreign.source) {}

  base::Result<fuzzy::ForceModel> convert(const std::string& output) {
    const bool good =
        chooseOutput(output) && chooseRules() && checkForce() && carryVariables() && addRules() && finish();
    if (!good) return tl::unexpected(*error_);
    return std::move(model_);
  }

 private:
  const ForeignVariable& output() const { return foreign_.outputs[output_]; }

  bool chooseOutput(const std::string& wanted) {
    if (foreign_.inputs.empty()) return refuseWhole(ErrorCode::kSchema, "no input", "one input or more");
    if (foreign_.outputs.empty()) return refuseWhole(ErrorCode::kSchema, "no output", "an output, the force");
    ForeignNames names(foreign_.format);
    for (const ForeignVariable& variable : foreign_.outputs) names.add(variable.name.text);
    if (!wanted.empty()) {
      const auto found = names.find(wanted);
      if (!found) return refuseWhole(ErrorCode::kReference, "no output " + quoted(wanted), "one of " + names.listed());
      output_ = *found;
    } else if (foreign_.outputs.size() > 1) {
      return refuseWhole(ErrorCode::kValue, std::to_string(foreign_.outputs.size()) + " outputs, " + names.listed(),
                         "the choice of one of them, the force");
    }
    if (!output().enabled)
      source_.warn(output().name.at,
                   "the output " + quoted(output().name.text) + " is disabled in the file; here it counts");
    return true;
  }

  /// The rules that conclude on the output, of the blocks that are enabled.
  bool chooseRules() {
    auto all = resolved(foreign_);
    if (!all) return fail(all.error());
    std::map<std::size_t, std::size_t> left_out;
    for (ResolvedRule& rule : *all) {
      std::erase_if(rule.conclusions, [this](const ResolvedLiteral& l) { return l.variable != output_; });
      if (rule.conclusions.empty()) continue;
      if (rule.reads_output) {
        return fail(source_.error(ErrorCode::kValue, rule.reads_output->at,
                                  "the output " + quoted(rule.reads_output->text) + " in a condition",
                                  "inputs: Tactus has no rules that follow rules"));
      }
      if (foreign_.blocks[rule.rule->block].enabled) {
        rules_.push_back(std::move(rule));
      } else {
        ++left_out[rule.rule->block];
      }
    }
    for (const auto& [block, count] : left_out) {
      source_.warnWhole("the rule block " + quoted(foreign_.blocks[block].name.text) + " is disabled; its " +
                        std::to_string(count) + " rules are left out");
    }
    if (!rules_.empty()) return true;
    return refuseWhole(ErrorCode::kSchema, "no rule for " + quoted(output().name.text), "one rule or more");
  }

  /// Norms, defuzzifier, and what the output is where no rule fires.
  bool checkForce() {
    const auto implication = checkMethods(foreign_, output(), rules_);
    if (!implication) return fail(implication.error());
    model_.implication = *implication;
    if (output().holds_last) {
      source_.warn(*output().holds_last,
                   "the last value is kept where no rule fires; Tactus gives the default force there");
    }
    if (!output().fallback || std::isnan(output().fallback->value)) return true;
    model_.default_force_n = output().fallback->value;
    if (std::isfinite(model_.default_force_n)) return true;
    return fail(source_.error(ErrorCode::kValue, output().fallback->at, base::formatNumber(model_.default_force_n),
                              "a finite default or nan"));
  }

  bool carryVariables() {
    std::vector<std::vector<bool>> used;
    for (const ForeignVariable& input : foreign_.inputs) used.emplace_back(input.terms.size(), false);
    std::vector<bool> concluded(output().terms.size(), false);
    for (const ResolvedRule& rule : rules_) {
      for (const auto& conjunction : rule.alternatives) {
        for (const ResolvedLiteral& literal : conjunction) used[literal.variable][literal.term] = true;
      }
      for (const ResolvedLiteral& conclusion : rule.conclusions) concluded[conclusion.term] = true;
    }
    std::set<std::string> ids;
    for (std::size_t i = 0; i < foreign_.inputs.size(); ++i) {
      if (!carryInput(i, used[i], ids)) return false;
    }
    auto carried = CarriedVariable::carry(foreign_, output(), true, 1, concluded);
    if (!carried) return fail(carried.error());
    force_.emplace(std::move(*carried));
    return isNew(ids, force_->variable().id, output());
  }

  bool carryInput(std::size_t index, const std::vector<bool>& used, std::set<std::string>& ids) {
    const ForeignVariable& input = foreign_.inputs[index];
    const std::string name = "the input " + quoted(input.name.text);
    const bool is_used = std::find(used.begin(), used.end(), true) != used.end();
    inputs_.emplace_back();
    if (!is_used && input.terms.empty()) {
      source_.warn(input.name.at, name + " has no terms and no rule; it is left out");
      return true;
    }
    if (!is_used) source_.warn(input.name.at, name + " is in no rule");
    if (!input.enabled) source_.warn(input.name.at, name + " is disabled in the file; conditions on it never hold");
    auto carried = CarriedVariable::carry(foreign_, input, false, index + 1, used);
    if (!carried) return fail(carried.error());
    if (carried->variable().terms.empty()) {
      source_.warn(input.name.at, name + " has no terms that Tactus knows; it is left out");
      return true;
    }
    inputs_.back().emplace(std::move(*carried));
    return isNew(ids, inputs_.back()->variable().id, input);
  }

  bool isNew(std::set<std::string>& ids, const std::string& id, const ForeignVariable& variable) {
    if (ids.insert(id).second) return true;
    return fail(source_.error(ErrorCode::kSchema, variable.name.at,
                              quoted(variable.name.text) + " with the id " + quoted(id) + " of an earlier variable",
                              "names that differ in letters and digits"));
  }

  bool addRules() {
    for (const ResolvedRule& rule : rules_) {
      std::vector<std::string> then;
      for (const ResolvedLiteral& conclusion : rule.conclusions) {
        const auto ids = force_->idsOf(conclusion.term, conclusion.negated, conclusion.at);
        if (!ids) return fail(ids.error());
        then.insert(then.end(), ids->begin(), ids->end());
      }
      for (const auto& conjunction : rule.alternatives) {
        if (!addConjunction(rule, conjunction, then)) return false;
      }
    }
    if (!expert_rules_.empty()) return true;
    return refuseWhole(ErrorCode::kSchema, "rules that never fire, all of them", "a rule that gives a force");
  }

  /// The rules of one alternative: one for each choice among the terms of its literals.
  bool addConjunction(const ResolvedRule& rule, const std::vector<ResolvedLiteral>& literals,
                      const std::vector<std::string>& then) {
    if (literals.empty()) {
      return fail(source_.error(ErrorCode::kValue, rule.rule->at, "a rule whose condition asks for no term",
                                "a term of one input or more"));
    }
    std::map<std::size_t, ResolvedLiteral> by_input;
    for (const ResolvedLiteral& literal : literals) {
      // Such a condition never holds, so neither do those joined with it by AND.
      if (!foreign_.inputs[literal.variable].enabled) return true;
      const auto [found, is_new] = by_input.emplace(literal.variable, literal);
      if (is_new || found->second.isSame(literal)) continue;
      return fail(
          source_.error(ErrorCode::kValue, literal.at,
                        "two conditions on " + quoted(foreign_.inputs[literal.variable].name.text) + " joined by AND",
                        "one condition on each input: Tactus has no term that is the minimum of two"));
    }
    std::vector<std::vector<fuzzy::Condition>> choices(1);
    for (const auto& [input, literal] : by_input) {
      const auto ids = inputs_[input]->idsOf(literal.term, literal.negated, literal.at);
      if (!ids) return fail(ids.error());
      std::vector<std::vector<fuzzy::Condition>> longer;
      for (const auto& choice : choices) {
        for (const std::string& id : *ids) {
          longer.push_back(choice);
          longer.back().push_back({inputs_[input]->variable().id, id});
        }
      }
      choices = std::move(longer);
      if (choices.size() > fuzzy::kMostRules) return refuseSize(*rule.rule);
    }
    for (const auto& choice : choices) {
      for (const std::string& term : then) {
        if (!addRule(rule, choice, term)) return false;
      }
    }
    return true;
  }

  /// The same conditions and conclusion twice are one rule with the larger weight, as the maximum has it.
  bool addRule(const ResolvedRule& rule, const std::vector<fuzzy::Condition>& conditions, const std::string& then) {
    std::string key = then;
    for (const fuzzy::Condition& condition : conditions) key += '\n' + condition.input + '\n' + condition.term;
    const auto [known, is_new] = rule_of_.emplace(std::move(key), expert_rules_.size());
    if (is_new) {
      if (expert_rules_.size() == fuzzy::kMostRules) return refuseSize(*rule.rule);
      expert_rules_.push_back({conditions, then, rule.rule->weight.value});
      return true;
    }
    fuzzy::Rule& before = expert_rules_[known->second];
    before.weight = std::max(before.weight, rule.rule->weight.value);
    return true;
  }

  bool refuseSize(const ForeignRule& rule) {
    return fail(source_.error(ErrorCode::kLimit, rule.at,
                              "more than " + std::to_string(fuzzy::kMostRules) + " rules after OR and NOT are split",
                              "at most " + std::to_string(fuzzy::kMostRules)));
  }

  bool finish() {
    // Our own writers put this before the expert.
    constexpr std::string_view kOwn = "force_model_";
    std::string name = foreign_.name;
    if (name.starts_with(kOwn)) name.erase(0, kOwn.size());
    fuzzy::Expert expert;
    expert.id = idFrom(name, "imported");
    expert.label = name.empty() ? expert.id : base::oneLine(name);
    expert.rules = std::move(expert_rules_);
    model_.name = expert.label;
    for (auto& input : inputs_) {
      if (input) model_.inputs.push_back(input->variable());
    }
    model_.output = force_->variable();
    model_.experts.push_back(std::move(expert));
    auto valid = fuzzy::validate(model_);
    if (valid) return true;
    valid.error().file = source_.file();
    valid.error().place = "the model made of it, " + valid.error().place;
    return fail(valid.error());
  }

  bool fail(const base::Error& error) {
    if (!error_) error_ = error;
    return false;
  }
  bool refuseWhole(ErrorCode code, std::string found, std::string wanted) {
    return fail(source_.failWhole(code, std::move(found), std::move(wanted)).value());
  }

  const ForeignModel& foreign_;
  SourceText& source_;
  std::size_t output_ = 0;
  std::vector<ResolvedRule> rules_;
  std::vector<std::optional<CarriedVariable>> inputs_;  ///< nothing for one that is left out
  std::optional<CarriedVariable> force_;
  std::vector<fuzzy::Rule> expert_rules_;
  std::map<std::string, std::size_t> rule_of_;
  fuzzy::ForceModel model_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<fuzzy::ForceModel> converted(const ForeignModel& foreign, const std::string& output) {
  return ModelConverter(foreign).convert(output);
}

}  // namespace tactus::exchange
