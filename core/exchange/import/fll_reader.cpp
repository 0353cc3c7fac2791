// FLL of fuzzylite, versions 5 to 7: one `key: value` a line, `#` comments.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/exchange/import/foreign_model.h"
#include "core/exchange/import/rule_parser.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;

Token::Kind kindOf(std::string_view text) {
  if (text == "(" || text == ")" || text == ",") return Token::Kind::kSymbol;
  return numberIn(text) ? Token::Kind::kNumber : Token::Kind::kWord;
}

/// The words of a line, and its end.
std::vector<Token> wordsOf(Word line) {
  constexpr std::string_view kBlanks = " \t";
  constexpr std::string_view kEnds = " \t(),";
  std::vector<Token> out;
  for (std::size_t i = line.text.find_first_not_of(kBlanks); i < line.text.size();
       i = line.text.find_first_not_of(kBlanks, i)) {
    const std::size_t end = std::max(i + 1, std::min(line.text.size(), line.text.find_first_of(kEnds, i)));
    const std::string_view word = line.text.substr(i, end - i);
    out.push_back({kindOf(word), word, line.at + i});
    i = end;
  }
  out.push_back({Token::Kind::kEnd, {}, line.at + line.text.size()});
  return out;
}

Word trimmedWord(Word word) {
  const std::size_t begin = word.text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {{}, word.at + word.text.size()};
  return {base::trimmed(word.text), word.at + begin};
}

class FllReader {
 public:
  explicit FllReader(const std::shared_ptr<SourceText>& source)
      : source_(*source), rules_(*source, ImportFormat::kFll) {
    model_.format = ImportFormat::kFll;
    model_.source = source;
  }

  base::Result<ForeignModel> read() {
    const std::string_view text = source_.text();
    for (std::size_t begin = 0; begin < text.size() && !error_;) {
      const std::size_t end = std::min(text.size(), text.find('\n', begin));
      Word line{text.substr(begin, end - begin), begin};
      line.text = line.text.substr(0, line.text.find('#'));
      readLine(trimmedWord(line));
      begin = end + 1;
    }
    if (error_) return tl::unexpected(*error_);
    return std::move(model_);
  }

 private:
  using Line = void (FllReader::*)(Word value);

  void readLine(Word line) {
    if (line.text.empty()) return;
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos) {
      return refuse(ErrorCode::kSyntax, line.at, base::quoted(line.text), "a key and a value, as in 'enabled: true'");
    }
    const Word key{base::trimmed(line.text.substr(0, colon)), line.at};
    const Word value = trimmedWord({line.text.substr(colon + 1), line.at + colon + 1});
    const auto& keys = keysOf(section_);
    if (const auto known = keys.find(base::lowered(key.text)); known != keys.end())
      return (this->*known->second)(value);
    std::vector<std::string> names;
    for (const auto& [name, unused] : keys) names.push_back(name);
    refuse(ErrorCode::kSyntax, key.at, "the key " + base::quoted(key.text),
           "a key of FLL that fits here" + base::suggestion(key.text, names));
  }

  enum class Section { kEngine, kInput, kOutput, kRules };
  using Keys = std::map<std::string, Line, std::less<>>;

  /// The keys that may follow in a section: those of its own, and those that begin another.
  static const Keys& keysOf(Section section) {
    static const std::array<Keys, 4> keys = [] {
      const Keys sections = {{"engine", &FllReader::engine},
                             {"inputvariable", &FllReader::input},
                             {"outputvariable", &FllReader::output},
                             {"ruleblock", &FllReader::block},
                             {"description", &FllReader::ignore}};
      std::array<Keys, 4> out = {sections, sections, sections, sections};
      out[1].insert({{"enabled", &FllReader::enabled},
                     {"range", &FllReader::range},
                     {"lock-range", &FllReader::ignore},
                     {"term", &FllReader::term}});
      out[2] = out[1];
      out[2].insert({{"aggregation", &FllReader::aggregation},
                     {"accumulation", &FllReader::aggregation},
                     {"defuzzifier", &FllReader::defuzzifier},
                     {"default", &FllReader::fallback},
                     {"lock-previous", &FllReader::lockPrevious},
                     {"lock-valid", &FllReader::lockPrevious}});
      out[3].insert({{"enabled", &FllReader::blockEnabled},
                     {"conjunction", &FllReader::conjunction},
                     {"disjunction", &FllReader::disjunction},
                     {"implication", &FllReader::implication},
                     {"activation", &FllReader::activation},
                     {"rule", &FllReader::rule}});
      return out;
    }();
    return keys[static_cast<std::size_t>(section)];
  }

  void engine(Word value) {
    model_.name = value.text;
    section_ = Section::kEngine;
  }
  void input(Word value) { beginVariable(model_.inputs, Section::kInput, value); }
  void output(Word value) { beginVariable(model_.outputs, Section::kOutput, value); }
  void block(Word value) {
    model_.blocks.push_back({});
    model_.blocks.back().name = value;
    section_ = Section::kRules;
  }
  void ignore(Word /*value*/) {}

  void beginVariable(std::vector<ForeignVariable>& variables, Section section, Word name) {
    if (name.text.empty()) return refuse(ErrorCode::kSyntax, name.at, "no name", "the name of the variable");
    if ((error_ = tooMany(source_, variables, name))) return;
    variables.push_back({});
    variables.back().name = name;
    section_ = section;
  }

  ForeignVariable& variable() { return section_ == Section::kInput ? model_.inputs.back() : model_.outputs.back(); }
  ForeignBlock& ruleBlock() { return model_.blocks.back(); }

  bool flag(Word value) {
    const std::string word = base::lowered(value.text);
    if (word != "true" && word != "false")
      refuse(ErrorCode::kSyntax, value.at, base::quoted(value.text), "true or false");
    return word == "true";
  }
  void enabled(Word value) { variable().enabled = flag(value); }
  void blockEnabled(Word value) { ruleBlock().enabled = flag(value); }
  void lockPrevious(Word value) {
    if (flag(value)) variable().holds_last = value.at;
  }

  void range(Word value) {
    const auto words = wordsOf(value);
    const auto min = words.size() == 3 ? numberIn(words[0].text) : std::nullopt;
    const auto max = words.size() == 3 ? numberIn(words[1].text) : std::nullopt;
    if (!min || !max || *min != *min || *max != *max || *min >= *max) {
      return refuse(ErrorCode::kValue, value.at, base::quoted(value.text), "two numbers, the lower one first");
    }
    // Without a range fuzzylite writes `-inf inf`.
    variable().range_at = value.at;
    if (*max - *min < std::numeric_limits<double>::infinity()) variable().range = ForeignRange{*min, *max};
  }

  void term(Word value) {
    const auto words = wordsOf(value);
    if (words.size() < 3) {
      return refuse(ErrorCode::kSyntax, value.at, base::quoted(value.text),
                    "the name of a term, its shape and numbers, as in 'low Triangle 0 1 2'");
    }
    ForeignTerm term;
    term.name = words[0].word();
    term.word = words[1].word();
    term.shape = shapeOf(term.word.text);
    for (std::size_t i = 2; i + 1 < words.size() && term.shape != ForeignShape::kOther; ++i) {
      const auto number = numberIn(words[i].text);
      if (!number) return refuse(ErrorCode::kSyntax, words[i].at, base::quoted(words[i].text), "a number of the term");
      term.numbers.push_back({*number, words[i].at});
    }
    takeHeight(term);
    if ((error_ = tooMany(source_, variable().terms, term.name))) return;
    variable().terms.push_back(std::move(term));
  }

  void aggregation(Word value) { variable().aggregation = methodOf(value); }
  void defuzzifier(Word value) {
    // `Centroid 1000`: how many points fuzzylite takes does not matter here.
    variable().defuzzifier = methodOf(wordsOf(value).front().word());
  }
  void fallback(Word value) {
    const auto number = numberIn(value.text);
    if (!number) return refuse(ErrorCode::kSyntax, value.at, base::quoted(value.text), "a number or nan");
    variable().fallback = ForeignNumber{*number, value.at};
  }

  void conjunction(Word value) { ruleBlock().conjunction = methodOf(value); }
  void disjunction(Word value) { ruleBlock().disjunction = methodOf(value); }
  void implication(Word value) { ruleBlock().implication = methodOf(value); }
  void activation(Word value) {
    const Method method = methodOf(wordsOf(value).front().word());
    if (method.meaning == Meaning::kNone || base::lowered(method.word.text) == "general") return;
    // Version 5 wrote the implication here; later versions write a strategy.
    if (method.meaning == Meaning::kOther || ruleBlock().implication) {
      ruleBlock().activation = method;
    } else {
      ruleBlock().implication = method;
    }
  }

  void rule(Word value) {
    TokenStream tokens(wordsOf(value));
    auto rule = rules_.read(tokens);
    if (!rule) {
      error_ = rule.error();
      return;
    }
    if (tokens.peek().kind != Token::Kind::kEnd) {
      return refuse(ErrorCode::kSyntax, tokens.peek().at, base::quoted(tokens.peek().text), "the end of the rule");
    }
    rule->block = model_.blocks.size() - 1;
    model_.rules.push_back(std::move(*rule));
  }

  void refuse(ErrorCode code, std::size_t at, std::string found, std::string wanted) {
    if (!error_) error_ = source_.error(code, at, std::move(found), std::move(wanted));
  }

  SourceText& source_;
  RuleParser rules_;
  ForeignModel model_;
  Section section_ = Section::kEngine;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<ForeignModel> readFll(const std::shared_ptr<SourceText>& source) { return FllReader(source).read(); }

}  // namespace tactus::exchange
