#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/base/text.h"
#include "core/study/data_finding.h"
#include "experiments/force_series.h"
#include "experiments/judgement_checks.h"
#include "experiments/table_findings.h"

namespace tactus::experiments {
namespace {

using study::DataFinding;
using study::ForceJudgement;
using Answer = ForceJudgement::Kind;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;
using JudgementRows = std::vector<const ForceJudgement*>;

constexpr std::size_t kFewestForOneWord = 5;
constexpr std::size_t kFewestForReversed = 4;
constexpr std::size_t kFewestForCopies = 10;
constexpr std::size_t kFewestWordsForCopies = 3;
// A series ends at 1.7 N and the device at 3.3 N: from here on a force is odd, and beyond the second it is none.
constexpr double kOddForceN = 5;
constexpr double kLargestForceN = 20;
// Of the pairs of forces: one slip in a series of 11 gives 18 %, and simulated nurses with a slip in fifty stay below.
constexpr double kOftenFalling = 0.25;
constexpr double kNewtonsPerGram = 0.00980665;

std::string newtons(double force_n) { return base::formatNumber(std::round(force_n * 1e4) / 1e4) + " N"; }

/// 2.5 times the smallest difference of forces that a hand feels: sqrt(0.04^2 + (0.12 F)^2) N (King 2010, Feyzabadi
/// 2013).
double clearlyMore(double force_n) { return 2.5 * std::hypot(0.04, 0.12 * force_n); }

/// All judgements of one participant.
class OneParticipant {
 public:
  OneParticipant(JudgementRows judged, std::span<const std::string> terms)
      : judged_(std::move(judged)), terms_(terms) {}

  std::vector<DataFinding> findings() {
    checkSeries();
    checkTerms();
    checkUnit();
    checkOneWord();
    checkReversed();
    checkSides();
    checkOrder();
    addNotable();
    return std::move(out_);
  }

 private:
  std::optional<std::size_t> place(const ForceJudgement& row) const {
    const auto term = std::find(terms_.begin(), terms_.end(), row.term);
    if (row.kind != Answer::kTerm || term == terms_.end()) return std::nullopt;
    return static_cast<std::size_t>(term - terms_.begin());
  }

  void checkSeries() {
    static const std::vector<std::string> known = {kAscending, kDescending, kRandom, kFamiliarisation};
    const auto unknown = std::find_if(judged_.begin(), judged_.end(), [](const auto* row) {
      return std::find(known.begin(), known.end(), row->series) == known.end();
    });
    if (unknown == judged_.end()) return;
    const auto& row = **unknown;
    const std::string called = row.series.empty() ? "A judgement of " + row.participant + " is of no series"
                                                  : "The series " + base::quoted(row.series) + " of " +
                                                        row.participant + " is none of " + base::joined(known, ", ");
    out_.push_back(study::remark(Kind::kUnknownSeries, Severity::kWarning, row, "series",
                                 called + ": it has no vote on the words for forces" +
                                     (row.series.empty() ? " (merged cells? fill them down)." : ".")));
  }

  void checkTerms() {
    for (const auto* row : judged_) {
      if (row->kind != Answer::kTerm || place(*row)) continue;
      const std::string wanted = "one of " + base::joined(terms_, ", ") + base::suggestion(row->term, terms_);
      auto unknown = study::remark(Kind::kUnknownForceTerm, Severity::kRefused, *row, "term",
                                   "The term " + base::quoted(row->term) + " of " + row->participant + " is not " +
                                       wanted + ", not_felt, beyond_practice or empty.");
      unknown.found = base::quoted(row->term);
      unknown.wanted = wanted;
      out_.push_back(std::move(unknown));
      return;
    }
  }

  void checkUnit() {
    const auto largest = std::max_element(judged_.begin(), judged_.end(),
                                          [](const auto* a, const auto* b) { return a->force_n < b->force_n; });
    const double most = (*largest)->force_n;
    if (most <= kOddForceN) return;
    if (most <= kLargestForceN) {
      out_.push_back(study::remark(Kind::kForceUnit, Severity::kWarning, **largest, "force_n",
                                   (*largest)->participant + " judged " + newtons(most) +
                                       ", more than the device of the study gives: a misplaced decimal point?"));
      return;
    }
    const auto large =
        std::count_if(judged_.begin(), judged_.end(), [](const auto* row) { return row->force_n > kOddForceN; });
    if (judged_.size() > 2 && 2 * static_cast<std::size_t>(large) < judged_.size()) {
      out_.push_back(study::refusal(Kind::kForceUnit, (*largest)->participant, study::cellOf(**largest, "force_n"),
                                    "the force of " + newtons(most) + " that " + (*largest)->participant +
                                        " judged is more than any device of the study gives",
                                    "correct the row: a misplaced decimal point?"));
      return;
    }
    const bool grams = most * kNewtonsPerGram > 0.3 && most * 1e-3 < 0.3;
    out_.push_back(study::refusal(
        Kind::kForceUnit, (*largest)->participant, study::cellOf(*judged_.front(), "force_n"),
        "the forces of " + (*largest)->participant + " reach " + newtons(most) + " and look like " +
            (grams ? "grams" : "mN"),
        grams ? "multiply force_n by 0.00980665, so that it is in N" : "divide force_n by 1000, so that it is in N"));
  }

  void checkOneWord() {
    std::set<std::string_view> words;
    std::size_t count = 0;
    const ForceJudgement* first = nullptr;
    for (const auto* row : judged_) {
      if (!place(*row)) continue;
      words.insert(row->term);
      if (first == nullptr) first = row;
      ++count;
    }
    if (count < kFewestForOneWord || words.size() != 1) return;
    out_.push_back(study::remark(Kind::kOneWord, Severity::kWarning, *first, "term",
                                 first->participant + " calls all " + std::to_string(count) + " forces " +
                                     base::quoted(first->term) + ": such judgements say nothing of the force."));
  }

  void checkReversed() {
    std::size_t rising = 0;
    std::size_t falling = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < judged_.size(); ++i) {
      const auto a = place(*judged_[i]);
      if (!a) continue;
      ++count;
      for (std::size_t k = 0; k < i; ++k) {
        const auto b = place(*judged_[k]);
        const double step_n = judged_[i]->force_n - judged_[k]->force_n;
        if (!b || *a == *b || step_n == 0) continue;
        ++((step_n > 0) == (*a > *b) ? rising : falling);
      }
    }
    if (count < kFewestForReversed || falling <= 2 * rising) return;
    reversed_ = true;
    out_.push_back(study::remark(Kind::kScaleReversed, Severity::kWarning, *judged_.front(), "term",
                                 judged_.front()->participant + " calls larger forces smaller in " +
                                     std::to_string(falling) + " of " + std::to_string(rising + falling) +
                                     " pairs: the scale the other way round?"));
  }

  std::map<std::string, JudgementRows> bySeries() const {
    std::map<std::string, JudgementRows> series;
    for (const auto* row : judged_) series[row->series].push_back(row);
    for (auto& [name, rows] : series) {
      std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->step < b->step; });
    }
    return series;
  }

  /// `beyond_practice` below a term, `not_felt` above one.
  void checkSides() {
    const ForceJudgement* early = nullptr;
    const ForceJudgement* term_above = nullptr;
    const ForceJudgement* unfelt = nullptr;
    const ForceJudgement* term_below = nullptr;
    for (const auto& [name, rows] : bySeries()) {
      for (const auto* row : rows) {
        for (const auto* other : rows) {
          const double above_n = other->force_n - row->force_n;
          if (other->kind != Answer::kTerm) continue;
          if (row->kind == Answer::kBeyondPractice && above_n > clearlyMore(row->force_n) && early == nullptr) {
            early = row;
            term_above = other;
          }
          if (row->kind == Answer::kNotFelt && -above_n > clearlyMore(other->force_n) && unfelt == nullptr) {
            unfelt = row;
            term_below = other;
          }
        }
      }
    }
    if (early != nullptr) {
      out_.push_back(study::remark(Kind::kBeyondTooEarly, Severity::kWarning, *early, "term",
                                   early->participant + " calls " + newtons(early->force_n) +
                                       " beyond practice, and the larger " + newtons(term_above->force_n) + ' ' +
                                       base::quoted(term_above->term) + lineOf(*term_above) + '.'));
    }
    if (unfelt != nullptr) {
      out_.push_back(study::remark(Kind::kNotFeltAboveFelt, Severity::kWarning, *unfelt, "term",
                                   unfelt->participant + " did not feel " + newtons(unfelt->force_n) +
                                       ", and calls the smaller " + newtons(term_below->force_n) + ' ' +
                                       base::quoted(term_below->term) + lineOf(*term_below) + '.'));
    }
  }

  static std::string lineOf(const ForceJudgement& row) {
    return row.line.number == 0 ? std::string() : " (line " + std::to_string(row.line.number) + ")";
  }

  void checkOrder() {
    for (const auto& [name, rows] : bySeries()) {
      const bool up = name == kAscending;
      if (!up && name != kDescending) continue;
      for (std::size_t i = 1; i < rows.size(); ++i) {
        const double step_n = rows[i]->force_n - rows[i - 1]->force_n;
        if (up ? step_n > 0 : step_n < 0) continue;
        out_.push_back(study::remark(Kind::kForceOrder, Severity::kWarning, *rows[i], "force_n",
                                     "In the " + name + " series of " + rows[i]->participant + " step " +
                                         std::to_string(rows[i]->step) + " is at " + newtons(rows[i]->force_n) +
                                         ", after " + newtons(rows[i - 1]->force_n) +
                                         ": the series goes another way."));
        return;
      }
    }
  }

  /// What the checks of the experiment call notable of these judgements.
  void addNotable() {
    std::vector<study::JudgementRecord> records;
    for (const auto* row : judged_) {
      study::JudgementRecord record;
      record.series = row->series;
      record.step = row->step;
      record.commanded_n = row->force_n;
      record.kind = row->kind;
      record.term = row->term;
      records.push_back(std::move(record));
    }
    static const std::map<std::string_view, Kind> kinds = {{"monotonicity", Kind::kTermsFall},
                                                           {"hysteresis", Kind::kSeriesDiffer},
                                                           {"repeats", Kind::kRepeatsDiffer},
                                                           {"blanks", Kind::kBlanksFelt}};
    const auto checks = checkJudgements(records, terms_);
    const bool often = std::any_of(checks.monotonicity.begin(), checks.monotonicity.end(), [](const auto& series) {
      return static_cast<double>(series.violations) > kOftenFalling * static_cast<double>(series.pairs);
    });
    for (const auto& said : checks.findings) {
      const auto kind = kinds.find(said.check);
      if (!said.notable || kind == kinds.end()) continue;
      if (kind->second == Kind::kTermsFall && (reversed_ || !often)) continue;
      const bool again = std::any_of(out_.begin(), out_.end(),
                                     [kind](const DataFinding& other) { return other.kind == kind->second; });
      if (again) continue;
      out_.push_back(study::remark(kind->second, Severity::kNote, *judged_.front(), "term",
                                   judged_.front()->participant + ": " + said.sentence));
    }
  }

  JudgementRows judged_;
  std::span<const std::string> terms_;
  bool reversed_ = false;
  std::vector<DataFinding> out_;
};

using Words = std::map<std::pair<std::string_view, int>, std::pair<Answer, std::string_view>>;

Words wordsOf(const JudgementRows& judged) {
  Words words;
  for (const auto* row : judged) words[{row->series, row->step}] = {row->kind, row->term};
  return words;
}

bool sayEnough(const Words& words) {
  std::set<std::string_view> different;
  for (const auto& [step, word] : words) {
    if (word.first == Answer::kTerm) different.insert(word.second);
  }
  return words.size() >= kFewestForCopies && different.size() >= kFewestWordsForCopies;
}

}  // namespace

std::vector<DataFinding> judgementFindings(std::span<const ForceJudgement> judgements,
                                           std::span<const std::string> terms) {
  std::vector<JudgementRows> participants;
  std::unordered_map<std::string_view, std::size_t> places;
  for (const auto& row : judgements) {
    const auto [place, is_new] = places.try_emplace(row.participant, participants.size());
    if (is_new) participants.emplace_back();
    participants[place->second].push_back(&row);
  }
  std::vector<DataFinding> out;
  std::map<Words, const ForceJudgement*> first_with;
  for (const auto& judged : participants) {
    auto own = OneParticipant(judged, terms).findings();
    out.insert(out.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
    const auto words = wordsOf(judged);
    if (!sayEnough(words)) continue;
    const auto [original, is_new] = first_with.try_emplace(words, judged.front());
    if (is_new) continue;
    out.push_back(study::remark(Kind::kJudgementsCopied, Severity::kNote, *judged.front(), "term",
                                judged.front()->participant + " gave the same words as " +
                                    original->second->participant + " at all " + std::to_string(words.size()) +
                                    " steps: copied, or chance?"));
  }
  return out;
}

}  // namespace tactus::experiments
