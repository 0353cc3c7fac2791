// FIS of MATLAB and Octave, and what fuzzylite writes of it: sections, `key=value`, rules of numbers.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/exchange/import/fis_lines.h"
#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {
namespace {

// The rules of a FIS file: `1 0 -2, 1 (0.5) : 1`, terms by their number.

using base::ErrorCode;

/// The hedge that Octave and fuzzylite put into the fraction of a term's number.
std::string hedgeOf(double fraction) {
  const int hundredths = static_cast<int>(std::lround(100 * fraction));
  switch (hundredths) {
    case 5: return "the hedge 'somewhat'";
    case 20: return "the hedge 'very'";
    case 30: return "the hedge 'extremely'";
    case 40: return "the hedge 'very very'";
    default: return "a hedge, the power " + base::formatNumber(10 * fraction);
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

/// The rule in `line` for a model whose variables are complete. Refused: a number without a term, hedges, a rule
/// without condition or conclusion.
base::Result<ForeignRule> readFisRule(const ForeignModel& model, Word line) {
  return FisRuleReader(model, line).read();
}

using base::ErrorCode;

/// `prefix` with a number from 1 behind it, in any case: `Input3`, `MF12`.
std::optional<std::size_t> numbered(std::string_view word, std::string_view prefix) {
  if (base::lowered(word.substr(0, prefix.size())) != prefix) return std::nullopt;
  const auto number = base::parseInteger(word.substr(prefix.size()));
  if (!number || *number < 1) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

class FisReader {
 public:
  explicit FisReader(const std::shared_ptr<SourceText>& source) : source_(*source) {
    model_.format = ImportFormat::kFis;
    model_.source = source;
    model_.blocks.push_back({});
  }

  base::Result<ForeignModel> read() {
    const std::string_view text = source_.text();
    for (std::size_t begin = 0; begin < text.size() && !error_;) {
      const std::size_t end = std::min(text.size(), text.find('\n', begin));
      const std::string_view line = text.substr(begin, end - begin);
      const std::size_t blank = std::min(line.size(), line.find_first_not_of(" \t"));
      readLine({base::trimmed(line), begin + blank});
      begin = end + 1;
    }
    if (!error_) readRules();
    if (!error_) checkCounts();
    if (error_) return tl::unexpected(*error_);
    return std::move(model_);
  }

 private:
  enum class Section { kNone, kSystem, kInput, kOutput, kRules };

  void readLine(Word line) {
    if (line.text.empty() || line.text.front() == '%' || line.text.front() == '#' || line.text.starts_with("//"))
      return;
    if (line.text.front() == '[') return beginSection(line);
    if (section_ == Section::kRules) {
      // Read when all variables are known.
      rule_lines_.push_back(line);
      return;
    }
    LineCursor cursor(line);
    const std::size_t equals = line.text.find('=');
    if (equals == std::string_view::npos)
      return refuse(ErrorCode::kSyntax, line.at, base::quoted(line.text), "a key and a value, as in Name='x'");
    const Word key{base::trimmed(line.text.substr(0, equals)), line.at};
    LineCursor value({line.text.substr(equals + 1), line.at + equals + 1});
    switch (section_) {
      case Section::kNone: return refuse(ErrorCode::kSyntax, line.at, base::quoted(line.text), "[System] before it");
      case Section::kSystem: return readSystem(key, value);
      case Section::kInput:
      case Section::kOutput: return readVariable(key, value);
      case Section::kRules: return;
    }
  }

  void beginSection(Word line) {
    const std::size_t close = line.text.find(']');
    const std::string_view name = base::trimmed(line.text.substr(1, std::min(close, line.text.size()) - 1));
    const std::string lower = base::lowered(name);
    if (lower == "system") {
      section_ = Section::kSystem;
    } else if (lower == "rules") {
      section_ = Section::kRules;
    } else if (const auto input = numbered(name, "input")) {
      beginVariable(model_.inputs, *input, Section::kInput, line);
    } else if (const auto output = numbered(name, "output")) {
      beginVariable(model_.outputs, *output, Section::kOutput, line);
    } else {
      refuse(ErrorCode::kSyntax, line.at, base::quoted(line.text), "[System], [Input1], [Output1] or [Rules]");
    }
  }

  void beginVariable(std::vector<ForeignVariable>& variables, std::size_t number, Section section, Word line) {
    if (number != variables.size() + 1) {
      return refuse(ErrorCode::kSchema, line.at, base::quoted(line.text),
                    "number " + std::to_string(variables.size() + 1) + ", the next one");
    }
    if ((error_ = tooMany(source_, variables, line))) return;
    variables.push_back({});
    variables.back().name = {{}, line.at};
    section_ = section;
  }

  void readSystem(Word key, LineCursor& value) {
    const std::string name = base::lowered(key.text);
    ForeignBlock& block = model_.blocks.front();
    if (name == "name") {
      model_.name = text(value).text;
    } else if (name == "type") {
      const Word type = text(value);
      if (base::lowered(type.text) != "mamdani") {
        refuse(ErrorCode::kValue, type.at, "a system of the type " + base::quoted(type.text),
               "'mamdani', the only type that Tactus knows");
      }
    } else if (name == "numinputs") {
      inputs_ = count(value);
    } else if (name == "numoutputs") {
      outputs_ = count(value);
    } else if (name == "numrules") {
      rules_ = count(value);
    } else if (name == "andmethod") {
      block.conjunction = methodOf(text(value));
    } else if (name == "ormethod") {
      block.disjunction = methodOf(text(value));
    } else if (name == "impmethod") {
      block.implication = methodOf(text(value));
    } else if (name == "aggmethod") {
      block.aggregation = methodOf(text(value));
    } else if (name == "defuzzmethod") {
      defuzzifier_ = methodOf(text(value));
    } else if (name != "version") {
      ignored(key);
    }
  }

  void readVariable(Word key, LineCursor& value) {
    const std::string name = base::lowered(key.text);
    ForeignVariable& variable = section_ == Section::kInput ? model_.inputs.back() : model_.outputs.back();
    if (name == "name") {
      variable.name = text(value);
    } else if (name == "range") {
      readRange(variable, key, value);
    } else if (name == "nummfs") {
      variable.stated_terms = count(value);
    } else if (const auto number = numbered(key.text, "mf")) {
      readTerm(variable, key, *number, value);
    } else if (name == "enabled") {
      variable.enabled = flag(value);
    } else if (name == "default") {
      const Word word = value.takeWord();
      const auto fallback = numberIn(word.text);
      if (!fallback) return refuse(ErrorCode::kSyntax, word.at, base::quoted(word.text), "a number or nan");
      variable.fallback = ForeignNumber{*fallback, word.at};
    } else if (name == "lockprevious" || name == "lockvalid") {
      const std::size_t at = value.at();
      if (flag(value)) variable.holds_last = at;
    } else if (name.starts_with("umf") || name.starts_with("lmf")) {
      refuse(ErrorCode::kValue, key.at, "a term of type 2", "terms of type 1: Tactus lacks upper and lower terms");
    } else if (name != "lockrange" && name != "lockvalidoutput") {
      ignored(key);
    }
  }

  void readRange(ForeignVariable& variable, Word key, LineCursor& value) {
    std::vector<double> ends;
    const std::size_t at = value.at();
    const std::string shown = base::quoted(value.rest());
    const bool good = takeList(value, [&](Word word) { ends.push_back(numberIn(word.text).value_or(std::nan(""))); });
    if (!good || ends.size() != 2 || !(ends[0] < ends[1])) {
      return refuse(ErrorCode::kValue, at, shown, "two numbers, the lower one first, as in [0 1]");
    }
    variable.range_at = key.at;
    if (ends[1] - ends[0] < std::numeric_limits<double>::infinity()) variable.range = ForeignRange{ends[0], ends[1]};
  }

  /// `'low':'trimf',[0 1 2]`
  void readTerm(ForeignVariable& variable, Word key, std::size_t number, LineCursor& value) {
    if (number != variable.terms.size() + 1) {
      return refuse(ErrorCode::kSchema, key.at, base::quoted(key.text),
                    "MF" + std::to_string(variable.terms.size() + 1) + ", the next one");
    }
    const auto malformed = [&] {
      refuse(ErrorCode::kSyntax, value.at(), value.atEnd() ? "the end of the line" : base::quoted(value.rest()),
             "a term as in 'low':'trimf',[0 1 2]");
    };
    ForeignTerm term;
    const auto name = value.takeQuoted();
    if (!name || !value.takeIf(':')) return malformed();
    const auto shape = value.takeQuoted();
    if (!shape || !value.takeIf(',')) return malformed();
    term.name = *name;
    term.word = *shape;
    term.shape = shapeOf(shape->text);
    if (term.shape != ForeignShape::kOther) {
      if (!takeList(value, [&](Word word) { addNumber(term, word); })) return malformed();
      if (!value.atEnd()) return malformed();
      if (base::lowered(shape->text) == "gaussmf" && term.numbers.size() >= 2) {
        std::swap(term.numbers[0], term.numbers[1]);  // sigma stands first
      }
      takeHeight(term);
    }
    if ((error_ = error_ ? error_ : tooMany(source_, variable.terms, term.name))) return;
    variable.terms.push_back(std::move(term));
  }

  void addNumber(ForeignTerm& term, Word word) {
    const auto number = numberIn(word.text);
    if (!number) return refuse(ErrorCode::kSyntax, word.at, base::quoted(word.text), "a number of the term");
    term.numbers.push_back({*number, word.at});
  }

  void readRules() {
    for (const Word& line : rule_lines_) {
      auto rule = readFisRule(model_, line);
      if (!rule) {
        error_ = rule.error();
        return;
      }
      model_.rules.push_back(std::move(*rule));
    }
    for (ForeignVariable& output : model_.outputs) output.defuzzifier = defuzzifier_;
  }

  // Counts that do not match are told and otherwise ignored: people edit these files.
  void checkCounts() {
    const auto check = [this](const std::optional<std::size_t>& stated, std::size_t found, const std::string& what) {
      if (stated && *stated != found) {
        source_.warnWhole("the file says " + std::to_string(*stated) + " " + what + " and has " +
                          std::to_string(found));
      }
    };
    check(inputs_, model_.inputs.size(), "inputs");
    check(outputs_, model_.outputs.size(), "outputs");
    check(rules_, model_.rules.size(), "rules");
    for (const auto* variables : {&model_.inputs, &model_.outputs}) {
      for (const ForeignVariable& variable : *variables)
        check(variable.stated_terms, variable.terms.size(), "terms of " + base::quoted(variable.name.text));
    }
  }

  /// A text in quotes; without them the next word.
  static Word text(LineCursor& value) {
    const auto quoted = value.takeQuoted();
    return quoted ? *quoted : value.takeWord();
  }

  std::optional<std::size_t> count(LineCursor& value) {
    const Word word = value.takeWord();
    const auto number = base::parseInteger(word.text);
    if (number && *number >= 0) return static_cast<std::size_t>(*number);
    refuse(ErrorCode::kSyntax, word.at, base::quoted(word.text), "a count");
    return std::nullopt;
  }

  bool flag(LineCursor& value) {
    const Word word = text(value);
    const std::string lower = base::lowered(word.text);
    const bool yes = lower == "1" || lower == "true";
    if (!yes && lower != "0" && lower != "false")
      refuse(ErrorCode::kSyntax, word.at, base::quoted(word.text), "0 or 1");
    return yes;
  }

  void ignored(Word key) {
    source_.warn(key.at, "the key " + base::quoted(key.text) + " is not known and is not used");
  }

  void refuse(ErrorCode code, std::size_t at, std::string found, std::string wanted) {
    if (!error_) error_ = source_.error(code, at, std::move(found), std::move(wanted));
  }

  SourceText& source_;
  ForeignModel model_;
  Section section_ = Section::kNone;
  std::optional<std::size_t> inputs_;
  std::optional<std::size_t> outputs_;
  std::optional<std::size_t> rules_;
  std::optional<Method> defuzzifier_;
  std::vector<Word> rule_lines_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<ForeignModel> readFis(const std::shared_ptr<SourceText>& source) { return FisReader(source).read(); }

}  // namespace tactus::exchange
