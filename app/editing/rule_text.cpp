#include "app/editing/rule_text.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/editing/edit_text.h"
#include "core/base/close_match.h"
#include "core/base/text.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using fuzzy::Condition;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Term;
using fuzzy::Variable;

constexpr std::size_t kMostRules = 10'000;

/// Words with one space between them.
std::string spaced(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\r';
    if (!space) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

/// Reads one line from left to right. A label may hold the words of the language itself (`Well and wet`): of all names
/// that fit the longest one counts.
class LineReader {
 public:
  LineReader(const ForceModel& model, const Expert& expert, const std::string& line, std::size_t number)
      : model_(model), expert_(expert), line_(line), low_(base::lowered(line)), number_(number) {}

  base::Result<Rule> read() {
    Rule rule;
    rule.enabled = !take("off ");
    if (!take("if ")) return wanted("IF or OFF IF");
    do {
      auto condition = readCondition();
      if (!condition) return tl::unexpected(condition.error());
      rule.conditions.push_back(std::move(*condition));
    } while (take(" and "));
    if (!take(" then ")) return wanted("AND or THEN");
    // The output's name may be left out, as on the screen.
    if (const auto length = nameLength(model_.output)) {
      at_ += length;
      if (!take(" is ")) return wanted("\"is\" behind " + labelOf(model_.output));
    }
    const auto then = readTerm(model_.output);
    if (!then) return tl::unexpected(then.error());
    rule.then = *then;
    if (take(" with ")) {
      const auto weight = base::parseNumber(std::string_view(line_).substr(at_));
      if (!weight) return wanted("a weight from 0 to 1");
      rule.weight = *weight;
      at_ = line_.size();
    }
    if (at_ < line_.size()) return wanted("WITH a weight, or the end of the line");
    return rule;
  }

 private:
  bool take(std::string_view word) {
    if (low_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }

  bool endsAt(std::size_t end) const { return end == low_.size() || low_[end] == ' '; }

  /// Length of `name` where it stands here as whole words; 0 if it does not.
  std::size_t fits(const std::string& name) const {
    const std::string wanted = spaced(base::lowered(name));
    return !wanted.empty() && low_.compare(at_, wanted.size(), wanted) == 0 && endsAt(at_ + wanted.size())
               ? wanted.size()
               : 0;
  }

  template <class Named>
  std::size_t nameLength(const Named& named) const {
    return std::max(fits(named.id), fits(named.label));
  }

  base::Result<Condition> readCondition() {
    const Variable* input = nullptr;
    std::size_t longest = 0;
    for (const Variable& one : model_.inputs) {
      const std::size_t length = nameLength(one);
      if (length <= longest) continue;
      longest = length;
      input = &one;
    }
    if (input == nullptr) return unknown("an input", namesOf(model_.inputs), " is ");
    at_ += longest;
    if (!take(" is ")) return wanted("\"is\" behind " + labelOf(*input));
    auto term = readTerm(*input);
    if (!term) return tl::unexpected(term.error());
    return Condition{input->id, *term};
  }

  base::Result<std::string> readTerm(const Variable& variable) {
    const std::vector<Term>& terms = termsFor(expert_, variable);
    const Term* found = nullptr;
    std::size_t longest = 0;
    for (const Term& one : terms) {
      const std::size_t length = nameLength(one);
      if (length <= longest) continue;
      longest = length;
      found = &one;
    }
    if (found == nullptr) return unknown("a term of " + labelOf(variable), namesOf(terms), " ");
    at_ += longest;
    return found->id;
  }

  template <class Named>
  static std::vector<std::string> namesOf(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) names.push_back(labelOf(one));
    return names;
  }

  tl::unexpected<base::Error> wanted(const std::string& what) const {
    const std::string rest = at_ < line_.size() ? base::quoted(line_.substr(at_)) : std::string("the end of the line");
    return fail(ErrorCode::kSyntax, place(), rest, what);
  }

  tl::unexpected<base::Error> unknown(const std::string& what, const std::vector<std::string>& names,
                                      std::string_view end) const {
    const std::string rest = line_.substr(std::min(at_, line_.size()));
    const std::string word = rest.substr(0, base::lowered(rest).find(end));
    const std::string found = word.empty() ? std::string("the end of the line") : base::quoted(word);
    return fail(ErrorCode::kReference, place(), found, what + base::suggestion(word, names));
  }

  std::string place() const { return "line " + std::to_string(number_); }

  const ForceModel& model_;
  const Expert& expert_;
  const std::string& line_;
  const std::string low_;
  std::size_t number_;
  std::size_t at_ = 0;
};

}  // namespace

std::string rulesAsText(const ForceModel& model, const Expert& expert, std::span<const std::size_t> indices) {
  std::string out;
  for (const std::size_t index : indices) {
    const Rule& rule = expert.rules[index];
    if (!rule.enabled) out += "OFF ";
    out += conditionsText(model, expert, rule) + " THEN " + labelOf(model.output) + " is " +
           consequentText(model, expert, rule.then);
    if (rule.weight != 1) out += " WITH " + base::formatNumber(rule.weight);
    out += '\n';
  }
  return out;
}

base::Result<std::vector<Rule>> rulesFromText(const ForceModel& model, const Expert& expert, std::string_view text) {
  std::vector<Rule> rules;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line = spaced(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.empty()) continue;
    if (rules.size() == kMostRules) {
      return fail(ErrorCode::kLimit, "line " + std::to_string(number), "one more rule",
                  "at most " + std::to_string(kMostRules));
    }
    auto rule = LineReader(model, expert, line, number).read();
    if (!rule) return tl::unexpected(rule.error());
    rules.push_back(std::move(*rule));
  }
  if (rules.empty()) return fail(ErrorCode::kData, "text", "no line with a rule", "IF … THEN …, one rule a line");
  return rules;
}

}  // namespace tactus::editing
