#include "core/exchange/import/fis_rules.h"

#include <cmath>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/exchange/import/fis_lines.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;

/// The hedge that Octave and fuzzylite put into the fraction of a term's number.
std::string hedgeOf(double fraction) {
  const int hundredths = static_cast<int>(std::lround(100 * fraction));
  switch (hundredths) {
    case 5:
      return "the hedge 'somewhat'";
    case 20:
      return "the hedge 'very'";
    case 30:
      return "the hedge 'extremely'";
    case 40:
      return "the hedge 'very very'";
    default:
      return "a hedge, the power " + base::formatNumber(10 * fraction);
  }
}

class FisRuleReader {
 public:
  FisRuleReader(const ForeignModel& model, Word line) : model_(model), source_(*model.source), line_(line) {
    rule_.at = line.at;
  }

  base::Result<ForeignRule> read() {
    std::vector<Literal> condition;
    const bool good = readSide(model_.inputs, "inputs", condition) && expect(',') &&
                      readSide(model_.outputs, "outputs", rule_.conclusions) && readWeight() &&
                      readConnective(condition);
    if (!good) return tl::unexpected(*error_);
    return std::move(rule_);
  }

 private:
  /// One number for each variable; `found` gets those that are not 0.
  bool readSide(const std::vector<ForeignVariable>& variables, const std::string& what, std::vector<Literal>& found) {
    for (const ForeignVariable& variable : variables) {
      const Word word = line_.takeWord();
      const auto number = numberIn(word.text);
      if (!number || !std::isfinite(*number)) {
        return refuse(ErrorCode::kSyntax, word.at, word.text.empty() ? shownRest() : base::quoted(word.text),
                      "the number of a term of " + base::quoted(variable.name.text) + ", one for each of the " +
                          std::to_string(variables.size()) + " " + what);
      }
      if (*number == 0) continue;
      Literal literal;
      if (!termOf(variable, word, *number, literal)) return false;
      found.push_back(literal);
    }
    return true;
  }

  bool termOf(const ForeignVariable& variable, Word word, double number, Literal& out) {
    const double whole = std::trunc(std::abs(number));
    const double fraction = std::abs(number) - whole;
    if (fraction > 1e-9) {
      return refuse(ErrorCode::kValue, word.at, hedgeOf(fraction) + " in " + base::quoted(word.text),
                    "terms without hedges, which Tactus lacks");
    }
    if (whole < 1 || whole > static_cast<double>(variable.terms.size())) {
      return refuse(ErrorCode::kReference, word.at, "term " + base::quoted(word.text),
                    "a number from 1 to " + std::to_string(variable.terms.size()) + ", the terms of " +
                        base::quoted(variable.name.text));
    }
    const ForeignTerm& term = variable.terms[static_cast<std::size_t>(whole) - 1];
    out = {{variable.name.text, word.at}, {term.name.text, word.at}, number < 0};
    return true;
  }

  /// `(0.5)`
  bool readWeight() {
    if (!expect('(')) return false;
    const Word word = line_.takeWord();
    const auto weight = numberIn(word.text);
    if (!weight)
      return refuse(ErrorCode::kSyntax, word.at, base::quoted(word.text), "the weight of the rule, a number");
    rule_.weight = {*weight, word.at};
    return expect(')');
  }

  /// `: 1` joins by AND, `: 2` by OR.
  bool readConnective(const std::vector<Literal>& condition) {
    if (!expect(':')) return false;
    const Word word = line_.takeWord();
    const auto number = numberIn(word.text);
    if (number != 1 && number != 2)
      return refuse(ErrorCode::kSyntax, word.at, base::quoted(word.text), "1 for AND or 2 for OR");
    if (!line_.atEnd()) return refuse(ErrorCode::kSyntax, line_.at(), shownRest(), "the end of the rule");
    if (condition.size() > 1) (number == 1 ? rule_.and_at : rule_.or_at) = word.at;
    // Without a condition it is refused where its output is chosen: fuzzylite writes rules that follow rules in this
    // way.
    if (number == 1 || condition.empty()) {
      rule_.alternatives.push_back(condition);
    } else {
      for (const Literal& literal : condition) rule_.alternatives.push_back({literal});
    }
    return true;
  }

  bool expect(char sign) {
    if (line_.takeIf(sign)) return true;
    return refuse(ErrorCode::kSyntax, line_.at(), shownRest(),
                  std::string("'") + sign + "' in a rule as '1 2, 1 (1) : 1'");
  }

  std::string shownRest() { return line_.atEnd() ? std::string("the end of the line") : base::quoted(line_.rest()); }

  bool refuse(ErrorCode code, std::size_t at, std::string found, std::string wanted) {
    if (!error_) error_ = source_.error(code, at, std::move(found), std::move(wanted));
    return false;
  }

  const ForeignModel& model_;
  const SourceText& source_;
  LineCursor line_;
  ForeignRule rule_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<ForeignRule> readFisRule(const ForeignModel& model, Word line) {
  return FisRuleReader(model, line).read();
}

}  // namespace tactus::exchange
