// The sentences of contracts: one grammar for writing and reading.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/contracts/contract_check.h"

namespace tactus::contracts {
namespace {

using base::ErrorCode;
using fuzzy::Contract;
using Kind = fuzzy::Contract::Kind;

/// Words of the grammar: a name with one of them is written in quotes.
constexpr std::array<std::string_view, 16> kWords = {"and",   "above",  "below", "by", "force", "in",
                                                     "is",    "more",   "never", "of", "than",  "the",
                                                     "where", "within", "model", "jnd"};

bool isPlain(std::string_view id) {
  if (id.empty() || !base::isLetter(id.front()) || id.back() == '_') return false;
  std::string word;
  for (std::size_t i = 0; i <= id.size(); ++i) {
    if (i < id.size() && (base::isLetter(id[i]) || base::isDigit(id[i]))) {
      word += id[i];
      continue;
    }
    if (i < id.size() && id[i] != '_') return false;
    const std::string low = base::lowered(word);
    if (word.empty() || std::find(kWords.begin(), kWords.end(), low) != kWords.end()) return false;
    word.clear();
  }
  return true;
}

std::string spoken(std::string_view id) {
  std::string out = base::lowered(id);
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

/// How a sentence names `id`, one of `ids` or a name that is gone.
std::string nameOf(const std::vector<std::string>& ids, const std::string& id) {
  const std::string plain = spoken(id);
  const auto same = std::count_if(ids.begin(), ids.end(), [&](const std::string& one) { return spoken(one) == plain; });
  if (same <= 1 && isPlain(id)) return plain;
  std::string out = "\"";
  for (const char c : id) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::vector<std::string> inputIds(const fuzzy::ForceModel& model) {
  std::vector<std::string> ids;
  for (const auto& input : model.inputs) ids.push_back(input.id);
  return ids;
}

const fuzzy::Variable* findInput(const fuzzy::ForceModel& model, std::string_view id) {
  const auto at = std::find_if(model.inputs.begin(), model.inputs.end(), [&](const auto& one) { return one.id == id; });
  return at == model.inputs.end() ? nullptr : &*at;
}

std::vector<std::string> wordIds(const fuzzy::ForceModel& model, const std::string& input) {
  std::vector<std::string> ids;
  const fuzzy::Variable* const variable = findInput(model, input);
  if (variable == nullptr) return ids;
  for (const auto& term : variable->terms) ids.push_back(term.id);
  return ids;
}

/// The unit as a word of a sentence, with a space before it; nothing for `1` and for what is no word.
std::string unitWord(const std::string& unit) {
  const bool is_word = !unit.empty() && unit != "1" && base::lowered(unit) != "jnd" && base::lowered(unit) != "of" &&
                       unit.find_first_of(" \t\"") == std::string::npos;
  return is_word ? ' ' + unit : std::string();
}

/// Reads a sentence from the left.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  /// Takes `phrase` if it is next, as whole words in either case; a name in quotes letter by letter.
  bool takes(std::string_view phrase) {
    skipSpaces();
    std::size_t at = at_;
    if (phrase.starts_with('"')) {
      if (!text_.substr(at).starts_with(phrase)) return false;
      at_ += phrase.size();
      return true;
    }
    for (std::size_t i = 0; i < phrase.size(); ++i) {
      if (phrase[i] == ' ') {
        if (at >= text_.size() || !isSpace(text_[at])) return false;
        while (at < text_.size() && isSpace(text_[at])) ++at;
      } else if (at >= text_.size() || base::lowered(text_.substr(at, 1)) != base::lowered(phrase.substr(i, 1))) {
        return false;
      } else {
        ++at;
      }
    }
    if (at < text_.size() && !isSpace(text_[at])) return false;
    at_ = at;
    return true;
  }

  /// The id of `ids` that is next, the longest of several; `what` it is goes into the error.
  std::string name(const std::vector<std::string>& ids, std::string_view what) {
    skipSpaces();
    std::string best;
    const std::size_t start = at_;
    std::size_t end = at_;
    for (const std::string& id : ids) {
      at_ = start;
      if (takes(nameOf(ids, id)) && at_ > end) best = id, end = at_;
    }
    at_ = end;
    if (best.empty()) {
      std::vector<std::string> names;
      for (const std::string& id : ids) names.push_back(nameOf(ids, id));
      refuse(std::string(what) + ": " + base::joined(names, ", "), ErrorCode::kReference);
    }
    return best;
  }

  double number(std::string_view what) {
    const std::size_t start = at_;
    const std::string_view token = nextToken();
    const auto value = base::parseNumber(token);
    if (value && std::abs(*value) < 1e150) return *value;
    at_ = start;
    refuse(std::string(what));
    return 0;
  }

  /// Takes a unit if it is next.
  void unit(const std::string& unit) {
    const std::string word = unitWord(unit);
    if (!word.empty()) takes(std::string_view(word).substr(1));
  }

  void wants(std::string_view phrase) {
    if (!takes(phrase)) refuse("'" + std::string(phrase) + "'");
  }

  void refuse(std::string wanted, ErrorCode code = ErrorCode::kSyntax) {
    if (error_) return;
    skipSpaces();
    const std::string_view rest = text_.substr(std::min(at_, text_.size()));
    error_ = base::Error{code,
                         {},
                         "character " + std::to_string(at_ + 1),
                         rest.empty() ? "the end of the sentence" : base::quoted(rest),
                         std::move(wanted)};
  }

  bool atEnd() {
    skipSpaces();
    return at_ >= text_.size();
  }
  const std::optional<base::Error>& error() const { return error_; }

 private:
  static bool isSpace(char c) { return c == ' ' || c == '\t'; }
  void skipSpaces() {
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
  }
  std::string_view nextToken() {
    skipSpaces();
    const std::size_t start = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::optional<base::Error> error_;
};

}  // namespace

std::string violationText(std::string_view sentence, std::size_t more) {
  return "found a violation of " + base::quoted(std::string(sentence)) +
         (more > 0 ? " and of " + std::to_string(more) + " more" : "") + ", wanted contracts that the model keeps";
}

std::string sentenceOf(const fuzzy::ForceModel& model, const Contract& contract) {
  const auto inputs = inputIds(model);
  const std::string input = nameOf(inputs, contract.input);
  const auto word = [&](const std::string& of, const std::string& id) { return nameOf(wordIds(model, of), id); };
  const std::string limit = base::formatNumber(contract.limit);
  const std::string limit_n = limit + unitWord(model.output.unit);
  std::string text;
  switch (contract.kind) {
    case Kind::kNeverRaises: text = "more " + input + " never raises the force"; break;
    case Kind::kNeverLowers: text = "more " + input + " never lowers the force"; break;
    case Kind::kNeverHarder:
      text = input + " in " + word(contract.input, contract.word) + " is never harder than in " +
             word(contract.input, contract.than);
      break;
    case Kind::kNoStep: {
      const fuzzy::Variable* const variable = findInput(model, contract.input);
      text = "the force never changes by more than " + (contract.limit_in_jnd ? limit + " JND" : limit_n) + " within " +
             base::formatNumber(contract.within) + (variable == nullptr ? "" : unitWord(variable->unit)) + " of " +
             input;
      break;
    }
    case Kind::kNeverAbove: text = "the force is never above " + limit_n; break;
    case Kind::kNeverBelow: text = "the force is never below " + limit_n; break;
    case Kind::kNeverSilent: text = "the model is never silent"; break;
  }
  std::string_view join = " where ";
  for (const fuzzy::Condition& one : contract.where) {
    text += join;
    text += nameOf(inputs, one.input) + " is " + word(one.input, one.term);
    join = " and ";
  }
  return text;
}

base::Result<Contract> parseContract(const fuzzy::ForceModel& model, std::string_view sentence) {
  constexpr std::string_view kInput = "an input";
  constexpr std::string_view kWord = "a word";
  const std::string_view text = base::trimmed(sentence);
  Reader in(text.ends_with('.') ? text.substr(0, text.size() - 1) : text);
  const auto inputs = inputIds(model);
  Contract out;
  if (in.takes("more")) {
    out.input = in.name(inputs, kInput);
    const bool raises = in.takes("never raises the force");
    if (!raises && !in.takes("never lowers the force"))
      in.refuse("'never raises the force' or 'never lowers the force'");
    out.kind = raises ? Kind::kNeverRaises : Kind::kNeverLowers;
  } else if (in.takes("the model is never silent")) {
    out.kind = Kind::kNeverSilent;
  } else if (in.takes("the force is never above")) {
    out.kind = Kind::kNeverAbove;
    out.limit = in.number("a force");
    in.unit(model.output.unit);
  } else if (in.takes("the force is never below")) {
    out.kind = Kind::kNeverBelow;
    out.limit = in.number("a force");
    in.unit(model.output.unit);
  } else if (in.takes("the force never changes by more than")) {
    out.kind = Kind::kNoStep;
    out.limit = in.number("a force, or a number and JND");
    out.limit_in_jnd = in.takes("JND");
    if (!out.limit_in_jnd) in.unit(model.output.unit);
    in.wants("within");
    out.within = in.number("a distance along an input");
    if (!(out.limit > 0) || !(out.within > 0)) in.refuse("a change and a distance above 0", ErrorCode::kValue);
    for (const auto& input : model.inputs) {
      const std::string unit = unitWord(input.unit);
      if (!unit.empty() && in.takes(std::string_view(unit).substr(1))) break;
    }
    in.wants("of");
    out.input = in.name(inputs, kInput);
  } else {
    out.kind = Kind::kNeverHarder;
    out.input = in.name(inputs, "'more', 'the force', 'the model' or an input");
    const auto words = wordIds(model, out.input);
    if (!in.error()) {
      in.wants("in");
      out.word = in.name(words, kWord);
      in.wants("is never harder than in");
      out.than = in.name(words, kWord);
    }
  }
  std::string_view join = "where";
  while (!in.error() && in.takes(join)) {
    fuzzy::Condition one;
    one.input = in.name(inputs, kInput);
    in.wants("is");
    one.term = in.name(wordIds(model, one.input), kWord);
    const bool twice =
        std::any_of(out.where.begin(), out.where.end(), [&](const auto& c) { return c.input == one.input; });
    if (twice) in.refuse("each input once after 'where'");
    out.where.push_back(std::move(one));
    join = "and";
  }
  if (!in.error() && !in.atEnd()) in.refuse(out.where.empty() ? "'where' or the end" : "'and' or the end");
  if (in.error()) return tl::unexpected(*in.error());
  return out;
}

}  // namespace tactus::contracts
