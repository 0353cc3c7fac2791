// FCL: IEC 61131-7 as jFuzzyLogic and others write it, and the dialect of fuzzylite. Words in any case; a `;` may be
// missing.
#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/exchange/import/foreign_model.h"
#include "core/exchange/import/rule_parser.h"

namespace tactus::exchange {
namespace {

// The tokens of FCL: words, numbers and signs, without comments.

bool isDigitAt(std::string_view text, std::size_t at) { return at < text.size() && text[at] >= '0' && text[at] <= '9'; }

bool isNamePart(std::string_view text, std::size_t at) {
  if (at >= text.size()) return false;
  const auto c = static_cast<unsigned char>(text[at]);
  return c >= 0x80 || c == '_' || std::isalnum(c) != 0;
}

class FclLexer {
 public:
  explicit FclLexer(const SourceText& source) : source_(source), text_(source.text()) {}

  base::Result<std::vector<Token>> read() {
    for (skip(); at_ < text_.size() && !error_; skip()) {
      const std::size_t end = isNumberHere() ? endOfNumber() : isNamePart(text_, at_) ? endOfName(at_) : endOfSign();
      const std::string_view token = text_.substr(at_, end - at_);
      tokens_.push_back({kindOf(token), token, at_});
      at_ = end;
      line_start_ = false;
    }
    if (error_) return tl::unexpected(*error_);
    tokens_.push_back({Token::Kind::kEnd, {}, text_.size()});
    return std::move(tokens_);
  }

 private:
  static Token::Kind kindOf(std::string_view token) {
    if (numberIn(token)) return Token::Kind::kNumber;
    return isNamePart(token, 0) ? Token::Kind::kWord : Token::Kind::kSymbol;
  }

  /// Moves behind blanks and comments.
  void skip() {
    while (at_ < text_.size() && !error_) {
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("(*")) {
        skipTo("*)");
      } else if (rest.starts_with("/*")) {
        skipTo("*/");
      } else if (rest.starts_with("//") || rest.front() == '#' || (rest.front() == '%' && line_start_)) {
        at_ = std::min(text_.size(), text_.find('\n', at_));
      } else if (std::isspace(static_cast<unsigned char>(rest.front())) != 0) {
        if (rest.front() == '\n') line_start_ = true;
        ++at_;
      } else {
        return;
      }
    }
  }

  void skipTo(std::string_view end) {
    const std::size_t found = text_.find(end, at_ + 2);
    if (found == std::string_view::npos) {
      error_ = source_.error(base::ErrorCode::kSyntax, at_, "a comment without an end", base::quoted(end));
    } else {
      at_ = found + 2;
    }
  }

  bool isSigned() const { return text_[at_] == '+' || text_[at_] == '-'; }

  bool isNumberHere() const {
    const std::size_t first = at_ + (isSigned() ? 1 : 0);
    if (isDigitAt(text_, first) || (first < text_.size() && text_[first] == '.' && isDigitAt(text_, first + 1)))
      return true;
    return isSigned() && numberIn(text_.substr(first, endOfName(first) - first)).has_value();
  }

  /// `0..24` is a number, a sign and a number; a name may begin with digits.
  std::size_t endOfNumber() const {
    std::size_t end = at_ + (isSigned() ? 1 : 0);
    while (isDigitAt(text_, end)) ++end;
    if (text_.substr(end).starts_with(".") && !text_.substr(end).starts_with("..")) ++end;
    while (isDigitAt(text_, end)) ++end;
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
      if (isDigitAt(text_, exponent)) end = exponent;
      while (isDigitAt(text_, end)) ++end;
    }
    return endOfName(end);
  }

  /// Names of fuzzylite may hold dots.
  std::size_t endOfName(std::size_t end) const {
    while (isNamePart(text_, end) || (end > at_ && end < text_.size() && text_[end] == '.' &&
                                      isNamePart(text_, end - 1) && isNamePart(text_, end + 1)))
      ++end;
    return end;
  }

  std::size_t endOfSign() const {
    const std::string_view rest = text_.substr(at_);
    return at_ + (rest.starts_with(":=") || rest.starts_with("..") ? 2 : 1);
  }

  const SourceText& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  bool line_start_ = true;  ///< nothing but blanks and comments since the last line end
  std::vector<Token> tokens_;
  std::optional<base::Error> error_;
};

/// All tokens of `source`. Comments are `(* *)`, `/* */`, `//` and `#` to the end of the line, and `%` at the beginning
/// of a line. `..` and `:=` are one sign each. Refused: a comment without an end.
base::Result<std::vector<Token>> fclTokens(const SourceText& source) { return FclLexer(source).read(); }

using base::ErrorCode;

/// Words that end a statement without a `;`.
constexpr std::string_view kStatements[] = {"term",    "range",         "method",        "default", "accu",
                                            "enabled", "lock",          "end_fuzzify",   "rule",    "and",
                                            "or",      "end_defuzzify", "end_ruleblock", "act"};

class FclReader {
 public:
  FclReader(const std::shared_ptr<SourceText>& source, std::vector<Token> tokens)
      : source_(*source), tokens_(std::move(tokens)), rules_(*source, ImportFormat::kFcl) {
    model_.format = ImportFormat::kFcl;
    model_.source = source;
  }

  base::Result<ForeignModel> read() {
    readFile();
    if (error_) return tl::unexpected(*error_);
    return std::move(model_);
  }

 private:
  const Token& peek() const { return tokens_.peek(); }

  void readFile() {
    if (tokens_.takeIf("function_block") && !isBlockWord(peek())) model_.name = tokens_.take().text;
    while (!error_ && peek().kind != Token::Kind::kEnd) {
      if (tokens_.takeIf("end_function_block")) return expectNoMore();
      readBlock();
    }
  }

  void expectNoMore() {
    if (peek().is("function_block")) {
      return refuse(ErrorCode::kValue, peek(), "a second FUNCTION_BLOCK",
                    "one: keep the one to be read in a file of its own");
    }
    if (peek().kind != Token::Kind::kEnd) unexpected("the end of the file");
  }

  static bool isBlockWord(const Token& token) {
    return token.is("var_input") || token.is("var_output") || token.is("fuzzify") || token.is("defuzzify") ||
           token.is("ruleblock");
  }

  void readBlock() {
    const Token word = tokens_.take();
    if (word.is("var_input")) return readVariables(model_.inputs);
    if (word.is("var_output")) return readVariables(model_.outputs);
    if (word.is("fuzzify")) return readFuzzify(model_.inputs, "end_fuzzify", "VAR_INPUT");
    if (word.is("defuzzify")) return readFuzzify(model_.outputs, "end_defuzzify", "VAR_OUTPUT");
    if (word.is("ruleblock")) return readRules();
    const std::vector<std::string> known = {"VAR_INPUT", "VAR_OUTPUT", "FUZZIFY",
                                            "DEFUZZIFY", "RULEBLOCK",  "END_FUNCTION_BLOCK"};
    refuse(ErrorCode::kSyntax, word, shown(word),
           "a block: VAR_INPUT, VAR_OUTPUT, FUZZIFY, DEFUZZIFY or RULEBLOCK" + base::suggestion(word.text, known));
  }

  /// `x, y : REAL := 0; RANGE := (0 .. 1);`
  void readVariables(std::vector<ForeignVariable>& variables) {
    while (!error_ && !tokens_.takeIf("end_var")) {
      if (peek().is("range") && !variables.empty()) {
        readRange(variables.back());
        continue;
      }
      if (peek().kind != Token::Kind::kWord) return unexpected("the name of a variable or END_VAR");
      do {
        if ((error_ = tooMany(source_, variables, peek().word()))) return;
        variables.push_back({});
        variables.back().name = tokens_.take().word();
      } while (tokens_.takeIf(","));
      if (!expect(":")) return;
      if (peek().kind != Token::Kind::kWord) return unexpected("the type of the variable");
      tokens_.take();
      // A start value changes no force.
      if (tokens_.takeIf(":=")) tokens_.take();
      tokens_.takeIf(";");
    }
  }

  ForeignVariable* find(std::vector<ForeignVariable>& variables, Word name) {
    const auto by = [&](auto same) -> ForeignVariable* {
      const auto found = std::find_if(variables.begin(), variables.end(), same);
      return found == variables.end() ? nullptr : &*found;
    };
    if (auto* exact = by([&](const auto& v) { return v.name.text == name.text; })) return exact;
    return by([&](const auto& v) { return base::lowered(v.name.text) == base::lowered(name.text); });
  }

  void readFuzzify(std::vector<ForeignVariable>& variables, std::string_view end, const std::string& declared) {
    const Token name = tokens_.take();
    ForeignVariable* const variable = find(variables, name.word());
    if (variable == nullptr)
      return refuse(ErrorCode::kReference, name, shown(name), "a variable that " + declared + " declares");
    while (!error_ && !tokens_.takeIf(end)) {
      if (tokens_.takeIf("term")) {
        readTerm(*variable);
      } else if (peek().is("range")) {
        readRange(*variable);
      } else if (tokens_.takeIf("enabled")) {
        variable->enabled = readFlag();
      } else if (tokens_.takeIf("lock")) {
        readLocks(*variable);
      } else if (end == "end_fuzzify" || !readOutputItem(*variable)) {
        return unexpected(end == "end_fuzzify" ? "TERM, RANGE or END_FUZZIFY"
                                               : "TERM, RANGE, METHOD, ACCU, DEFAULT or END_DEFUZZIFY");
      }
      tokens_.takeIf(";");
    }
  }

  bool readOutputItem(ForeignVariable& output) {
    if (tokens_.takeIf("method")) {
      output.defuzzifier = readMethod();
    } else if (tokens_.takeIf("accu")) {
      output.aggregation = readMethod();
    } else if (tokens_.takeIf("default")) {
      readDefault(output);
    } else {
      return false;
    }
    return true;
  }

  /// `(0 .. 1)`
  void readRange(ForeignVariable& variable) {
    const Token range = tokens_.take();
    if (!expect(":=") || !expect("(")) return;
    const auto min = readNumber();
    if (error_ || !expect("..")) return;
    const auto max = readNumber();
    if (error_ || !expect(")")) return;
    tokens_.takeIf(";");
    if (!(min.value < max.value) || !(max.value - min.value < std::numeric_limits<double>::infinity())) {
      return refuse(ErrorCode::kValue, range, base::formatNumber(min.value) + " .. " + base::formatNumber(max.value),
                    "a range from a lower to a higher number");
    }
    variable.range = ForeignRange{min.value, max.value};
    variable.range_at = range.at;
  }

  ForeignNumber readNumber() {
    const Token token = peek();
    const auto number = numberIn(token.text);
    if (!number) {
      unexpected("a number");
      return {};
    }
    tokens_.take();
    return {*number, token.at};
  }

  bool readFlag() {
    if (!expect(":")) return true;
    const Token word = tokens_.take();
    if (!word.is("true") && !word.is("false")) refuse(ErrorCode::kSyntax, word, shown(word), "TRUE or FALSE");
    return word.is("true");
  }

  /// `LOCK : PREVIOUS | RANGE`
  void readLocks(ForeignVariable& variable) {
    if (!expect(":")) return;
    do {
      const Token word = tokens_.take();
      if (word.is("previous")) variable.holds_last = word.at;
    } while (tokens_.takeIf("|"));
  }

  /// `0.5`, `nan`, `NC`, `0.5 | NC`
  void readDefault(ForeignVariable& output) {
    if (!expect(":=")) return;
    do {
      const Token word = peek();
      if (tokens_.takeIf("nc")) {
        output.holds_last = word.at;
      } else {
        output.fallback = readNumber();
      }
    } while (!error_ && tokens_.takeIf("|"));
  }

  Method readMethod() {
    if (!expect(":")) return {};
    if (peek().kind == Token::Kind::kSymbol || peek().kind == Token::Kind::kEnd) {
      // `OR : ;` states nothing.
      return methodOf({{}, peek().at});
    }
    return methodOf(tokens_.take().word());
  }

  bool atEndOfStatement() const {
    return peek().kind == Token::Kind::kEnd || peek().text == ";" ||
           std::any_of(std::begin(kStatements), std::end(kStatements), [&](auto word) { return peek().is(word); });
  }

  void readTerm(ForeignVariable& variable) {
    ForeignTerm term;
    if (peek().kind != Token::Kind::kWord && peek().kind != Token::Kind::kNumber)
      return unexpected("the name of a term");
    term.name = tokens_.take().word();
    if (!expect(":=")) return;
    term.word = peek().word();
    if (peek().text == "(") {
      term.shape = ForeignShape::kPoints;
      readPoints(term);
    } else if (peek().kind == Token::Kind::kWord) {
      term.shape = shapeOf(tokens_.take().text);
      readShapeNumbers(term);
    } else if (peek().kind == Token::Kind::kNumber) {
      term.word.text = "singleton";
      tokens_.take();
    }
    if (!error_ && !atEndOfStatement()) return unexpected("';'");
    if (!error_) error_ = tooMany(source_, variable.terms, term.name);
    variable.terms.push_back(std::move(term));
  }

  void readPoints(ForeignTerm& term) {
    while (!error_ && tokens_.takeIf("(")) {
      for (const char* const sign : {",", ")"}) {
        if (!error_ && peek().kind == Token::Kind::kWord) {
          return refuse(ErrorCode::kValue, peek(), "the variable " + shown(peek()) + " in a term",
                        "numbers: a term of Tactus does not change with a variable");
        }
        term.numbers.push_back(readNumber());
        if (error_ || !expect(sign)) return;
      }
      // Some writers put commas between the points.
      tokens_.takeIf(",");
    }
  }

  void readShapeNumbers(ForeignTerm& term) {
    if (term.shape == ForeignShape::kOther) {
      while (!atEndOfStatement()) tokens_.take();
      return;
    }
    while (!error_ && !atEndOfStatement()) {
      term.numbers.push_back(readNumber());
      tokens_.takeIf(",");
    }
    takeHeight(term);
  }

  void readRules() {
    model_.blocks.push_back({});
    if (peek().kind == Token::Kind::kWord && !isRuleItem(peek())) model_.blocks.back().name = tokens_.take().word();
    while (!error_ && !tokens_.takeIf("end_ruleblock")) {
      ForeignBlock& block = model_.blocks.back();
      if (tokens_.takeIf("rule")) {
        readRule();
      } else if (tokens_.takeIf("and")) {
        block.conjunction = readMethod();
      } else if (tokens_.takeIf("or")) {
        block.disjunction = readMethod();
      } else if (tokens_.takeIf("act")) {
        block.implication = readMethod();
      } else if (tokens_.takeIf("accu")) {
        block.aggregation = readMethod();
      } else if (tokens_.takeIf("activation")) {
        const Method method = readMethod();
        if (base::lowered(method.word.text) != "general" && method.meaning != Meaning::kNone) block.activation = method;
      } else if (tokens_.takeIf("enabled")) {
        block.enabled = readFlag();
      } else {
        return unexpected("RULE, AND, OR, ACT, ACCU or END_RULEBLOCK");
      }
      tokens_.takeIf(";");
    }
  }

  static bool isRuleItem(const Token& token) {
    return token.is("rule") || token.is("and") || token.is("or") || token.is("act") || token.is("accu") ||
           token.is("activation") || token.is("enabled") || token.is("end_ruleblock");
  }

  /// `RULE 1 : IF …`; the name of a rule is for people.
  void readRule() {
    if (peek().text != ":") tokens_.take();
    if (!expect(":")) return;
    auto rule = rules_.read(tokens_);
    if (!rule) {
      error_ = rule.error();
      return;
    }
    rule->block = model_.blocks.size() - 1;
    model_.rules.push_back(std::move(*rule));
  }

  bool expect(std::string_view sign) {
    if (error_) return false;
    if (tokens_.takeIf(sign)) return true;
    unexpected(base::quoted(sign));
    return false;
  }

  static std::string shown(const Token& token) {
    return token.kind == Token::Kind::kEnd ? "the end of the file" : base::quoted(token.text);
  }
  void unexpected(std::string wanted) { refuse(ErrorCode::kSyntax, peek(), shown(peek()), std::move(wanted)); }
  void refuse(ErrorCode code, const Token& token, std::string found, std::string wanted) {
    if (!error_) error_ = source_.error(code, token.at, std::move(found), std::move(wanted));
  }

  SourceText& source_;
  TokenStream tokens_;
  RuleParser rules_;
  ForeignModel model_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<ForeignModel> readFcl(const std::shared_ptr<SourceText>& source) {
  TACTUS_TRY(auto tokens, fclTokens(*source));
  return FclReader(source, std::move(tokens)).read();
}

}  // namespace tactus::exchange
