#include "questionnaires/rule_sentence.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::questionnaires {
namespace {

using base::ErrorCode;
using base::fail;
using base::quoted;
using base::Result;

/// The words of a sentence, without its commas and final colon.
std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':') {
      if (!word.empty()) words.push_back(std::exchange(word, {}));
    } else {
      word += c;
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

/// Walks over the words; names are what stands between the keywords.
class Words {
 public:
  explicit Words(std::string_view text) : words_(wordsOf(text)), place_("sentence " + quoted(text)) {}

  bool atEnd() const { return at_ == words_.size(); }
  const std::string& place() const { return place_; }

  bool take(std::string_view keyword) {
    if (atEnd() || base::lowered(words_[at_]) != keyword) return false;
    ++at_;
    return true;
  }

  Result<void> require(std::string_view keyword) {
    if (take(keyword)) return {};
    return fail(ErrorCode::kSyntax, place_, atEnd() ? "its end" : quoted(words_[at_]), "the word " + quoted(keyword));
  }

  /// The words up to the next keyword, joined by spaces; may be empty.
  std::string name() {
    const std::size_t start = at_;
    while (!atEnd() && !isKeyword(words_[at_])) ++at_;
    return base::joined(std::vector<std::string>(words_.begin() + static_cast<std::ptrdiff_t>(start),
                                                 words_.begin() + static_cast<std::ptrdiff_t>(at_)),
                        " ");
  }

 private:
  static bool isKeyword(const std::string& word) {
    const std::string lower = base::lowered(word);
    return lower == "if" || lower == "is" || lower == "and" || lower == "then";
  }

  std::vector<std::string> words_;
  std::string place_;
  std::size_t at_ = 0;
};

std::string idsOf(const std::vector<NamedId>& terms) {
  std::vector<std::string> ids;
  for (const auto& term : terms) ids.push_back(term.id);
  return base::joined(ids, ", ");
}

Result<std::string> termOf(const VariableWords& variable, const std::string& word, const std::string& place) {
  auto term = variable.term(word);
  if (!term) {
    return fail(ErrorCode::kReference, place, quoted(word),
                "a term of " + quoted(variable.name.id) + ": " + idsOf(variable.terms));
  }
  return *term;
}

/// Reads `input IS [in] term` into `terms`, by the index of the input.
Result<void> readCondition(Words& words, const AliasTable& aliases, std::map<std::size_t, std::string>& terms) {
  const std::string name = words.name();
  const auto input = aliases.input(name);
  if (!input) {
    std::vector<NamedId> known;
    for (const auto& variable : aliases.inputs) known.push_back(variable.name);
    return fail(ErrorCode::kReference, words.place(), quoted(name), "an input: " + idsOf(known));
  }
  if (auto is = words.require("is"); !is) return is;
  words.take("in");
  TACTUS_TRY(const auto term, termOf(aliases.inputs[*input], words.name(), words.place()));
  if (!terms.emplace(*input, term).second) {
    return fail(ErrorCode::kValue, words.place(), "two conditions on " + quoted(name), "one condition for each input");
  }
  return {};
}

/// Reads `output IS [term]`; the term is empty where the sentence ends after IS.
Result<std::string> readConsequent(Words& words, const AliasTable& aliases) {
  const std::string name = words.name();
  const auto& output = aliases.output.name;
  if (std::find(output.words.begin(), output.words.end(), base::lowered(name)) == output.words.end()) {
    return fail(ErrorCode::kReference, words.place(), quoted(name), "the output " + quoted(output.id));
  }
  if (const auto is = words.require("is"); !is) return tl::unexpected(is.error());
  const std::string word = words.name();
  if (!words.atEnd()) return fail(ErrorCode::kSyntax, words.place(), "more after the rule", "its end");
  if (word.empty()) return std::string();
  return termOf(aliases.output, word, words.place());
}

}  // namespace

Result<RuleSentence> parseRuleSentence(std::string_view text, const AliasTable& aliases) {
  Words words(text);
  if (const auto start = words.require("if"); !start) return tl::unexpected(start.error());
  std::map<std::size_t, std::string> terms;
  do {
    if (const auto read = readCondition(words, aliases, terms); !read) return tl::unexpected(read.error());
  } while (words.take("and"));
  if (const auto then = words.require("then"); !then) return tl::unexpected(then.error());
  TACTUS_TRY(auto consequent, readConsequent(words, aliases));

  RuleSentence sentence;
  for (const auto& [input, term] : terms) sentence.conditions.push_back({aliases.inputs[input].name.id, term});
  sentence.then = std::move(consequent);
  return sentence;
}

}  // namespace tactus::questionnaires
