#include "core/exchange/import/rule_parser.h"

#include <algorithm>
#include <iterator>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/exchange/import/foreign_model.h"

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
        TACTUS_TRY(const auto found, find(inputs_, literal, "an input"));
        out.alternatives.back().push_back(found);
      }
      if (never) out.alternatives.pop_back();
    }
    for (const Literal& conclusion : rule.conclusions) {
      TACTUS_TRY(const auto found, find(outputs_, conclusion, "an output"));
      out.conclusions.push_back(found);
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
    TACTUS_TRY(auto one, names.resolve(rule));
    out.push_back(std::move(one));
  }
  return out;
}

namespace {

using base::ErrorCode;

constexpr std::string_view kRuleWords[] = {"if", "then", "and", "or", "is", "with", "rule", "end_ruleblock"};

bool isRuleWord(const Token& token) {
  return token.kind == Token::Kind::kEnd || token.kind == Token::Kind::kSymbol ||
         std::any_of(std::begin(kRuleWords), std::end(kRuleWords), [&](auto word) { return token.is(word); });
}

std::size_t literalsIn(const std::vector<Conjunction>& alternatives) {
  std::size_t count = 0;
  for (const Conjunction& conjunction : alternatives) count += conjunction.size();
  return count;
}

}  // namespace

bool Token::is(std::string_view lower_case) const {
  return text.size() == lower_case.size() && base::lowered(text) == lower_case;
}

bool TokenStream::takeIf(std::string_view lower_case) {
  if (!peek().is(lower_case)) return false;
  take();
  return true;
}

base::Result<ForeignRule> RuleParser::read(TokenStream& tokens) {
  tokens_ = &tokens;
  rule_ = {};
  rule_.at = tokens.peek().at;
  const bool good = expect("if", "IF") && readCondition(false, 0, rule_.alternatives) && expect("then", "THEN") &&
                    readConclusions() && readWeight();
  if (!good) return tl::unexpected(*error_);
  literals_ += literalsIn(rule_.alternatives);
  return std::move(rule_);
}

// A condition is a disjunction, or, negated, the conjunction of its negated parts.
bool RuleParser::readCondition(bool negated, int depth, Alternatives& out) {
  if (!readAll(negated, depth, out)) return false;
  while (tokens_->peek().is("or")) {
    const std::size_t at = tokens_->take().at;
    if (!rule_.or_at) rule_.or_at = at;
    Alternatives more;
    if (!readAll(negated, depth, more) || !join(out, more, negated, at)) return false;
    if (joined_at_ && is_fcl_) {
      source_.warn(*joined_at_,
                   "AND binds closer than OR, as IEC 61131-7 has it; programs that read from left to right, as "
                   "jFuzzyLogic does, give other forces");
    }
  }
  return true;
}

bool RuleParser::readAll(bool negated, int depth, Alternatives& out) {
  if (!readOne(negated, depth, out)) return false;
  std::optional<std::size_t> joined_at;
  while (tokens_->peek().is("and")) {
    const std::size_t at = tokens_->take().at;
    if (!joined_at) joined_at = at;
    if (!rule_.and_at) rule_.and_at = at;
    Alternatives more;
    if (!readOne(negated, depth, more) || !join(out, more, !negated, at)) return false;
  }
  joined_at_ = joined_at;
  return true;
}

bool RuleParser::readOne(bool negated, int depth, Alternatives& out) {
  while (tokens_->takeIf("not")) negated = !negated;
  if (tokens_->peek().text == "(") {
    if (depth == kDeepest) {
      return refuse(ErrorCode::kLimit, tokens_->peek().at, "groups nested deeper than " + std::to_string(kDeepest),
                    "a simpler rule");
    }
    tokens_->take();
    return readCondition(negated, depth + 1, out) && expect(")", "')'");
  }
  Literal literal;
  if (!readLiteral(negated, literal)) return false;
  out.push_back({literal});
  return true;
}

bool RuleParser::readLiteral(bool negated, Literal& out) {
  const Token variable = tokens_->peek();
  if (isRuleWord(variable)) return refuse(ErrorCode::kSyntax, variable.at, shown(variable), "the name of a variable");
  out.variable = tokens_->take().word();
  out.negated = negated;
  if (!expect("is", "IS")) return false;
  for (;;) {
    const Token word = tokens_->peek();
    if (isRuleWord(word)) return refuse(ErrorCode::kSyntax, word.at, shown(word), "the name of a term");
    tokens_->take();
    if (isRuleWord(tokens_->peek())) {
      out.term = word.word();
      return true;
    }
    if (word.is("not")) {
      out.negated = !out.negated;
    } else if (isHedge(word.text)) {
      return refuse(ErrorCode::kValue, word.at, "the hedge " + base::quoted(word.text),
                    "terms without hedges, which Tactus lacks");
    } else {
      const Token next = tokens_->peek();
      return refuse(ErrorCode::kSyntax, next.at, shown(next), "AND, OR, THEN or the end of the rule");
    }
  }
}

bool RuleParser::readConclusions() {
  do {
    Literal conclusion;
    if (!readLiteral(false, conclusion)) return false;
    rule_.conclusions.push_back(conclusion);
  } while (tokens_->takeIf("and") || tokens_->takeIf(","));
  return true;
}

bool RuleParser::readWeight() {
  if (!tokens_->takeIf("with")) return true;
  const Token number = tokens_->take();
  const auto weight = numberIn(number.text);
  if (!weight) return refuse(ErrorCode::kSyntax, number.at, shown(number), "the weight of the rule, a number");
  rule_.weight = {*weight, number.at};
  return true;
}

bool RuleParser::expect(std::string_view lower_case, std::string_view wanted) {
  if (tokens_->takeIf(lower_case)) return true;
  const Token found = tokens_->peek();
  return refuse(ErrorCode::kSyntax, found.at, shown(found), std::string(wanted) + " in a rule");
}

bool RuleParser::join(Alternatives& all, const Alternatives& more, bool both, std::size_t at) {
  const std::size_t count = both ? all.size() * more.size() : all.size() + more.size();
  const std::size_t size =
      both ? literalsIn(all) * more.size() + literalsIn(more) * all.size() : literalsIn(all) + literalsIn(more);
  if (count > kMostAlternatives || literals_ + size > kMostInAll) {
    return refuse(ErrorCode::kLimit, at, "a condition of " + std::to_string(count) + " alternatives",
                  "at most " + std::to_string(kMostAlternatives) + " in a rule, and fewer where there are many rules");
  }
  if (!both) {
    all.insert(all.end(), more.begin(), more.end());
    return true;
  }
  Alternatives joined;
  joined.reserve(count);
  for (const Conjunction& left : all) {
    for (const Conjunction& right : more) {
      joined.push_back(left);
      joined.back().insert(joined.back().end(), right.begin(), right.end());
    }
  }
  all = std::move(joined);
  return true;
}

bool RuleParser::refuse(ErrorCode code, std::size_t at, std::string found, std::string wanted) {
  if (!error_) error_ = source_.error(code, at, std::move(found), std::move(wanted));
  return false;
}

std::string RuleParser::shown(const Token& token) {
  return token.kind == Token::Kind::kEnd ? "the end" : base::quoted(token.text);
}

}  // namespace tactus::exchange
