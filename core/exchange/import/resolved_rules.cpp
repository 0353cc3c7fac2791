#include "core/exchange/import/resolved_rules.h"

#include "core/base/text.h"
#include "core/exchange/import/foreign_names.h"
#include "core/exchange/import/method_words.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;
using base::quoted;

/// The names of some variables and of their terms.
struct Names {
  Names(const std::vector<ForeignVariable>& all, ImportFormat format) : variables(format) {
    for (const ForeignVariable& variable : all) {
      variables.add(variable.name.text);
      terms.emplace_back(format);
      for (const ForeignTerm& term : variable.terms) terms.back().add(term.name.text);
    }
  }

  ForeignNames variables;
  std::vector<ForeignNames> terms;
};

class NameResolver {
 public:
  explicit NameResolver(const ForeignModel& model)
      : source_(*model.source), inputs_(model.inputs, model.format), outputs_(model.outputs, model.format) {}

  base::Result<ResolvedRule> resolve(const ForeignRule& rule) const {
    ResolvedRule out{&rule, {}, {}, {}};
    for (const Conjunction& conjunction : rule.alternatives) {
      out.alternatives.emplace_back();
      bool never = false;
      for (const Literal& literal : conjunction) {
        const bool is_input = inputs_.variables.find(literal.variable.text).has_value();
        if (!is_input && outputs_.variables.find(literal.variable.text)) {
          out.reads_output = literal.variable;
          continue;
        }
        if (isAlways(literal)) {
          never = never || literal.negated;
          continue;
        }
        const auto found = find(inputs_, literal, "an input");
        if (!found) return tl::unexpected(found.error());
        out.alternatives.back().push_back(*found);
      }
      if (never) out.alternatives.pop_back();
    }
    for (const Literal& conclusion : rule.conclusions) {
      const auto found = find(outputs_, conclusion, "an output");
      if (!found) return tl::unexpected(found.error());
      out.conclusions.push_back(*found);
    }
    if (rule.weight.value >= 0 && rule.weight.value <= 1) return out;
    return source_.fail(ErrorCode::kValue, rule.weight.at, "the weight " + base::formatNumber(rule.weight.value),
                        "a weight from 0 to 1");
  }

 private:
  /// `x is any`, of an input that has no term of this name.
  bool isAlways(const Literal& literal) const {
    const auto input = inputs_.variables.find(literal.variable.text);
    return input && isAny(literal.term.text) && !inputs_.terms[*input].find(literal.term.text);
  }

  /// `literal` among `names`.
  base::Result<ResolvedLiteral> find(const Names& names, const Literal& literal, const std::string& kind) const {
    const auto variable = names.variables.find(literal.variable.text);
    if (!variable) {
      return source_.fail(ErrorCode::kReference, literal.variable.at,
                          "the unknown variable " + quoted(literal.variable.text),
                          kind + " in this part of a rule: " + names.variables.listed() +
                              names.variables.suggestion(literal.variable.text));
    }
    const ForeignNames& terms = names.terms[*variable];
    const auto term = terms.find(literal.term.text);
    if (term) return ResolvedLiteral{*variable, *term, literal.negated, literal.variable.at};
    if (isHedge(literal.term.text)) {
      return source_.fail(ErrorCode::kValue, literal.term.at, "the hedge " + quoted(literal.term.text),
                          "terms without hedges, which Tactus lacks");
    }
    return source_.fail(
        ErrorCode::kReference, literal.term.at, "the unknown term " + quoted(literal.term.text),
        "a term of " + quoted(literal.variable.text) + ": " + terms.listed() + terms.suggestion(literal.term.text));
  }

  const SourceText& source_;
  Names inputs_;
  Names outputs_;
};

}  // namespace

base::Result<std::vector<ResolvedRule>> resolved(const ForeignModel& model) {
  const NameResolver names(model);
  std::vector<ResolvedRule> out;
  out.reserve(model.rules.size());
  for (const ForeignRule& rule : model.rules) {
    auto one = names.resolve(rule);
    if (!one) return tl::unexpected(one.error());
    out.push_back(std::move(*one));
  }
  return out;
}

}  // namespace tactus::exchange
