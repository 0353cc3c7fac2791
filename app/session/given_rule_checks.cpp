#include "app/session/given_rule_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/base/text.h"
#include "core/study/data_finding.h"

namespace tactus::session {
namespace {

using study::DataFinding;
using study::GivenRule;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;

constexpr std::size_t kFewest = 10;
constexpr double kOneConsequentShare = 0.9;
constexpr double kCopiedShare = 0.95;

/// The rules of one participant: the words of the conditions, and what follows.
struct Book {
  std::vector<const GivenRule*> rules;
  std::set<std::pair<std::string, std::string>> sentences;

  const std::string& who() const { return rules.front()->participant; }
};

std::string conditionsOf(const GivenRule& rule) {
  std::vector<std::string> words;
  for (const auto& condition : rule.conditions) words.push_back(condition.input + '=' + condition.term);
  std::sort(words.begin(), words.end());
  return base::joined(words, ",");
}

std::vector<Book> booksOf(std::span<const GivenRule> rules) {
  std::vector<Book> books;
  std::unordered_map<std::string_view, std::size_t> places;
  for (const auto& rule : rules) {
    const auto [place, is_new] = places.try_emplace(rule.participant, books.size());
    if (is_new) books.emplace_back();
    auto& book = books[place->second];
    book.rules.push_back(&rule);
    book.sentences.emplace(conditionsOf(rule), rule.then);
  }
  return books;
}

bool addOneConsequent(const Book& book, std::vector<DataFinding>& out) {
  std::map<std::string_view, std::size_t> counts;
  for (const auto* rule : book.rules) ++counts[rule->then];
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (static_cast<double>(most->second) < kOneConsequentShare * static_cast<double>(book.rules.size())) return false;
  out.push_back(study::remark(Kind::kOneConsequent, Severity::kWarning, *book.rules.front(), "then",
                              std::to_string(most->second) + " of " + std::to_string(book.rules.size()) + " rules of " +
                                  book.who() + " say " + base::quoted(most->first) +
                                  ": the force would hardly depend on anything."));
  return true;
}

void addCopied(const Book& book, std::span<const Book> earlier, std::vector<DataFinding>& out) {
  for (const auto& other : earlier) {
    const std::size_t larger = std::max(book.sentences.size(), other.sentences.size());
    if (other.rules.size() < kFewest) continue;
    const auto alike = static_cast<std::size_t>(
        std::count_if(book.sentences.begin(), book.sentences.end(),
                      [&other](const auto& sentence) { return other.sentences.contains(sentence); }));
    if (static_cast<double>(alike) < kCopiedShare * static_cast<double>(larger)) continue;
    out.push_back(study::remark(Kind::kRulesCopied, Severity::kWarning, *book.rules.front(), "then",
                                "The rules of " + book.who() + " are those of " + other.who() + " in " +
                                    std::to_string(alike) + " of " + std::to_string(larger) + ": copied?"));
    return;
  }
}

}  // namespace

std::vector<DataFinding> givenRuleFindings(std::span<const GivenRule> rules) {
  const auto books = booksOf(rules);
  std::vector<DataFinding> out;
  for (std::size_t i = 0; i < books.size(); ++i) {
    if (books[i].rules.size() < kFewest || addOneConsequent(books[i], out)) continue;
    addCopied(books[i], std::span(books).first(i), out);
  }
  return out;
}

}  // namespace tactus::session
