#include "app/session/data_checks.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "app/session/study_source.h"
#include "core/base/tables/odd_cell.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/store/person_codes.h"
#include "core/study/csv_tables.h"
#include "core/study/data_finding.h"
#include "core/study/record_id.h"
#include "core/study/records.h"
#include "experiments/force_series.h"
#include "experiments/stroke_units.h"
#include "experiments/table_findings.h"
#include "experiments/table_strokes.h"
#include "questionnaires/answer_checks.h"

namespace tactus::session {
namespace {

// Checks the participants of a study: distinct codes, plausible profiles, complete data.

using study::DataFinding;
using study::Participant;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;
using Codes = std::unordered_set<std::string_view>;

constexpr double kManyYears = 60;
constexpr double kMostYears = 80;
constexpr double kFirstCalendarYear = 1900;
constexpr double kLastCalendarYear = 2100;

void addAlike(const study::Study& study, std::vector<DataFinding>& out) {
  std::map<std::string, const Participant*> first_with;
  for (const auto& participant : study.participants) {
    const auto [first, is_new] = first_with.try_emplace(study::codeKey(participant.code), &participant);
    if (is_new) continue;
    out.push_back(study::remark(Kind::kCodesAlike, Severity::kWarning, participant, "participant",
                                "The codes " + base::quoted(first->second->code) + " and " +
                                    base::quoted(participant.code) +
                                    " differ only in capitals, spaces, dashes or zeros: one person under two codes?"));
  }
}

/// Two words of three letters or more, or an address: a code is random and never a name.
bool looksLikeName(std::string_view code) {
  if (code.find('@') != std::string_view::npos) return true;
  std::size_t words = 0;
  std::size_t letters = 0;
  for (const char c : std::string(code) + ' ') {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isdigit(byte) != 0) return false;
    const bool letter = std::isalpha(byte) != 0 || byte >= 0x80;
    if (!letter && letters >= 3) ++words;
    letters = letter ? letters + 1 : 0;
  }
  return words >= 2;
}

/// Two words of our own list, as the program draws them.
bool isDrawn(const std::string& code, const store::PersonCodes& codes) {
  const std::size_t dash = code.find('-');
  if (dash == std::string::npos) return false;
  const auto holds = [](const std::vector<std::string_view>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  return holds(codes.firstWords(), std::string_view(code).substr(0, dash)) &&
         holds(codes.secondWords(), std::string_view(code).substr(dash + 1));
}

void addNames(const study::Study& study, std::vector<DataFinding>& out) {
  const store::PersonCodes codes(0);
  for (const auto& participant : study.participants) {
    if (!looksLikeName(participant.code) || isDrawn(participant.code, codes)) continue;
    out.push_back(study::remark(Kind::kCodeLikeName, Severity::kWarning, participant, "participant",
                                "The code " + base::quoted(participant.code) +
                                    " looks like a name: give a random code, which every file then shows."));
  }
}

void addYears(const study::Study& study, std::vector<DataFinding>& out) {
  for (const auto& participant : study.participants) {
    if (!participant.years_experience || *participant.years_experience <= kManyYears) continue;
    const double years = *participant.years_experience;
    const std::string said = base::formatNumber(years) + " years of experience";
    if (years <= kMostYears) {
      out.push_back(study::remark(Kind::kYearsUnlikely, Severity::kWarning, participant, "years_experience",
                                  participant.code + " has " + said + ": an age?"));
      continue;
    }
    const bool calendar = years >= kFirstCalendarYear && years <= kLastCalendarYear;
    out.push_back(study::refusal(Kind::kYearsUnlikely, participant.code, study::cellOf(participant, "years_experience"),
                                 "the participant " + participant.code + " has " + said,
                                 calendar ? "give the years since then instead of a year of the calendar"
                                          : "give years (months? divide by 12), or leave the cell empty"));
  }
}

template <class Records>
Codes codesOf(const Records& records) {
  Codes codes;
  for (const auto& record : records) codes.insert(record.participant);
  return codes;
}

Codes codesWithRules(const study::Study& study) {
  Codes codes = codesOf(study.rules);
  for (const auto& answer : study.answers) {
    if (answer.status == study::Answer::Status::kAnswered) codes.insert(answer.participant);
  }
  return codes;
}

/// The participants who gave a term in a series that votes, or in an unknown series, which has a finding of its own.
Codes codesWithTerms(const study::Study& study) {
  Codes codes;
  for (const auto& judgement : study.judgements) {
    const bool other = judgement.series == experiments::kDescending || judgement.series == experiments::kRandom;
    if (judgement.kind == study::ForceJudgement::Kind::kTerm && !other) codes.insert(judgement.participant);
  }
  return codes;
}

struct TableBlock {
  Kind kind;
  Codes codes;
  std::string what, consequence;
};

void addAbsent(const study::Study& study, std::vector<DataFinding>& out) {
  const std::vector<TableBlock> blocks = {
      {Kind::kWithoutStrokes, codesOf(study.speeds), "strokes", "the speeds of the others are used"},
      {Kind::kWithoutJudgements, codesWithTerms(study), "force judgements in an ascending series",
       "the words for forces are the others'"},
      {Kind::kWithoutAnswers, codesWithRules(study), "answers and no rules", "no expert of the model"}};
  for (const auto& block : blocks) {
    if (block.codes.empty()) continue;  // an absent table is said once, not of each participant
    for (const auto& participant : study.participants) {
      if (block.codes.contains(participant.code)) continue;
      out.push_back(study::remark(block.kind, Severity::kWarning, participant, "participant",
                                  participant.code + " has no " + block.what + ": " + block.consequence + '.'));
    }
  }
}

void addMixed(const study::Study& study, std::vector<DataFinding>& out) {
  std::vector<std::string> simulated;
  const Participant* first = nullptr;
  for (const auto& participant : study.participants) {
    if (!participant.simulated) continue;
    if (first == nullptr) first = &participant;
    simulated.push_back(participant.code);
  }
  if (first == nullptr || simulated.size() == study.participants.size()) return;
  auto mixed = study::remark(Kind::kSimulatedAndReal, Severity::kWarning, *first, "simulated",
                             "Simulated participants stand beside real ones: " + base::joined(simulated, ", ") + '.');
  mixed.participant.clear();
  out.push_back(std::move(mixed));
}

void addVirtual(const study::Study& study, std::vector<DataFinding>& out) {
  for (const auto& participant : study.participants) {
    if (!participant.virtual_device) continue;
    out.push_back(study::remark(Kind::kVirtualDevice, Severity::kWarning, participant, "participant",
                                participant.code + ": VIRTUAL, a device that gives no force. What was judged there was "
                                                   "not felt and does not count; repeat it with a device."));
  }
}

void addUnchecked(const study::Study& study, std::vector<DataFinding>& out) {
  for (const auto& participant : study.participants) {
    if (!participant.setup_unchecked) continue;
    out.push_back(study::remark(Kind::kSetupUnchecked, Severity::kNote, participant, "participant",
                                participant.code + ": the set-up was not checked before the session (device, force, "
                                                   "latency, screens, sound, texts, disk)."));
  }
}

void addSummaries(const study::Study& study, std::vector<DataFinding>& out) {
  for (const auto& participant : study.participants) {
    if (!study::isSummaryWord(participant.code)) continue;
    out.push_back(study::remark(Kind::kSummaryRow, Severity::kWarning, participant, "participant",
                                "The participant " + base::quoted(participant.code) +
                                    " looks like a line below the table: remove it, it counts as a person."));
  }
}

void addDates(const study::Study& study, std::vector<DataFinding>& out) {
  for (const auto& participant : study.participants) {
    if (!base::looksLikeDate(participant.code)) continue;
    out.push_back(study::remark(Kind::kCodeLikeDate, Severity::kNote, participant, "participant",
                                "The code " + base::quoted(participant.code) +
                                    " looks like a date that a spreadsheet made of another code, such as 1-5."));
  }
}

/// Shares beside percent: both above 0, the larger above 1, the smaller at most 1 and less than a twentieth of it.
void addWeights(const study::Study& study, std::vector<DataFinding>& out) {
  const Participant* least = nullptr;
  const Participant* most = nullptr;
  for (const auto& participant : study.participants) {
    if (participant.weight.value_or(0) <= 0) continue;
    if (least == nullptr || *participant.weight < *least->weight) least = &participant;
    if (most == nullptr || *participant.weight > *most->weight) most = &participant;
  }
  if (least == nullptr || *least->weight > 1 || *most->weight <= 1 || *most->weight < 20 * *least->weight) return;
  out.push_back(study::remark(Kind::kWeightsMixed, Severity::kWarning, *most, "weight",
                              "The weight of " + most->code + " is " + base::formatNumber(*most->weight) +
                                  ", that of " + least->code + ' ' + base::formatNumber(*least->weight) +
                                  ": percent beside shares?"));
}

/// Findings about the participants: codes that differ only in capitals, spaces, dashes or leading zeros; codes that
/// look like names; impossible years of experience (above 80 refused, above 60 named); participants without
/// strokes, judgements or answers where others have them; simulated participants beside real ones; codes that look like
/// dates or like a line of means below the table; weights in percent beside shares.
std::vector<DataFinding> participantFindings(const study::Study& study) {
  std::vector<DataFinding> out;
  addAlike(study, out);
  addNames(study, out);
  addDates(study, out);
  addSummaries(study, out);
  addYears(study, out);
  addWeights(study, out);
  addAbsent(study, out);
  addMixed(study, out);
  addVirtual(study, out);
  addUnchecked(study, out);
  return out;
}

// Whether the rules that participants gave directly can be meant.

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

/// Findings about the given rules of each participant, of 10 rules or more: nine tenths with one consequent; the rules
/// of an earlier participant in 19 of 20.
std::vector<DataFinding> givenRuleFindings(std::span<const GivenRule> rules) {
  const auto books = booksOf(rules);
  std::vector<DataFinding> out;
  for (std::size_t i = 0; i < books.size(); ++i) {
    if (books[i].rules.size() < kFewest || addOneConsequent(books[i], out)) continue;
    addCopied(books[i], std::span(books).first(i), out);
  }
  return out;
}

using Findings = std::vector<study::DataFinding>;

std::vector<std::string> termIds(const std::vector<fuzzy::Term>& terms) {
  std::vector<std::string> ids;
  for (const auto& term : terms) ids.push_back(term.id);
  return ids;
}

std::vector<std::string> speedLevels(const study::Study& study) {
  const fuzzy::Variable* const rate = procedure::of(study).rateInput();
  return rate == nullptr ? std::vector<std::string>{} : termIds(rate->terms);
}

Findings strokeFindings(const study::Study& study) {
  const auto strokes = experiments::tableStrokes(study.speeds);
  const auto participants = experiments::byParticipant(strokes);
  const std::size_t usual = experiments::usualStrokes(strokes);
  const auto levels = speedLevels(study);
  Findings out;
  for (const auto& of_one : participants) {
    append(out, experiments::levelFindings(of_one, levels, usual));
    if (auto swapped = experiments::swappedColumns(of_one)) {
      out.push_back(std::move(*swapped));
      continue;  // what the columns say under the wrong names means nothing
    }
    append(out, experiments::unitFindings(of_one));
    append(out, experiments::rowFindings(of_one));
    append(out, experiments::valueFindings(of_one));
  }
  for (auto& finding : experiments::scaleFindings(participants)) {
    // Who has another unit is of another scale for that reason.
    const bool said = std::any_of(out.begin(), out.end(), [&finding](const study::DataFinding& other) {
      return other.participant == finding.participant && other.severity == study::DataFinding::Severity::kRefused;
    });
    if (!said) out.push_back(std::move(finding));
  }
  append(out, experiments::strokeCopyFindings(strokes));
  return out;
}

}  // namespace

Findings dataFindings(const study::Study& study) {
  Findings findings = participantFindings(study);
  append(findings, strokeFindings(study));
  append(findings, experiments::judgementFindings(study.judgements, termIds(procedure::of(study).output.terms)));
  append(findings, questionnaires::answerFindings(study.answers, knownForms(procedure::of(study))));
  append(findings, givenRuleFindings(study.rules));

  std::unordered_map<std::string, std::size_t> place;
  for (const auto& participant : study.participants) place.try_emplace(participant.code, place.size() + 1);
  std::stable_sort(findings.begin(), findings.end(), [&place](const auto& a, const auto& b) {
    const auto at = [&place](const study::DataFinding& finding) {
      const auto found = place.find(finding.participant);
      return found == place.end() ? std::size_t{0} : found->second;
    };
    return std::pair(-static_cast<int>(a.severity), at(a)) < std::pair(-static_cast<int>(b.severity), at(b));
  });
  return findings;
}

}  // namespace tactus::session
