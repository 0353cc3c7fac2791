#include "elicitation/force/force_voting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::formatNumber;
using base::quoted;
using base::Result;

constexpr long long kMostVotes = 1'000'000;

std::string listed(const std::set<std::string>& names) { return names.empty() ? "none" : base::joined(names, ", "); }

/// `error` about a judgement, said of its cell where it comes from a table.
tl::unexpected<base::Error> refused(base::Error error, const study::ForceJudgement& judgement, std::string_view column,
                                    std::string found) {
  return study::atCell(std::move(error), {study::kJudgementsTable, judgement.line, column}, std::move(found));
}

/// Whether one of `forces_n` is the same step as `force_n`.
bool isTaken(const std::set<double>& forces_n, double force_n) {
  const auto next = forces_n.lower_bound(force_n - kSameForceN);
  return next != forces_n.end() && *next - force_n <= kSameForceN;
}

std::string placeOf(const study::ForceJudgement& judgement) {
  return "judgement of participant " + judgement.participant + " at " + formatNumber(judgement.force_n) + " N";
}

}  // namespace

Result<std::vector<VoteCounts>> countVotes(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                           std::span<const std::string> terms) {
  std::vector<const study::ForceJudgement*> chosen;
  std::set<std::string> all_series;
  for (const auto& judgement : judgements) {
    all_series.insert(judgement.series);
    if (judgement.series != series) continue;
    if (!std::isfinite(judgement.force_n) || judgement.force_n < 0) {
      const std::string found = formatNumber(judgement.force_n) + " N";
      return refused(
          {ErrorCode::kValue, {}, "judgement of participant " + judgement.participant, found, "a force of 0 N or more"},
          judgement, "force_n", found);
    }
    chosen.push_back(&judgement);
  }
  if (chosen.empty()) {
    return study::inTable({ErrorCode::kData,
                           {},
                           "judgements",
                           "no row of series " + quoted(series),
                           "a series that was judged (there are: " + listed(all_series) + ")"},
                          study::kJudgementsTable, judgements.empty() ? study::TableLine{} : judgements.front().line);
  }
  std::stable_sort(chosen.begin(), chosen.end(), [](const auto* a, const auto* b) { return a->force_n < b->force_n; });

  std::vector<VoteCounts> steps;
  std::set<std::string_view> voters;
  for (const auto* judgement : chosen) {
    if (steps.empty() || judgement->force_n - steps.back().force_n > kSameForceN) {
      steps.push_back({judgement->force_n, std::vector<int>(terms.size())});
      voters.clear();
    }
    if (!voters.insert(judgement->participant).second) {
      const std::string found = "a second judgement in series " + quoted(series);
      return refused({ErrorCode::kData, {}, placeOf(*judgement), found, "one judgement per participant and force"},
                     *judgement, "force_n", found + " at " + formatNumber(judgement->force_n) + " N");
    }
    if (judgement->kind != study::ForceJudgement::Kind::kTerm) continue;
    const auto term = std::find(terms.begin(), terms.end(), judgement->term);
    if (term == terms.end()) {
      return refused({ErrorCode::kReference,
                      {},
                      placeOf(*judgement),
                      "term " + quoted(judgement->term),
                      "one of " + base::joined(terms, ", ")},
                     *judgement, "term", quoted(judgement->term));
    }
    ++steps.back().votes[static_cast<std::size_t>(term - terms.begin())];
  }
  return steps;
}

int countParticipants(std::span<const study::ForceJudgement> judgements) {
  std::set<std::string_view> participants;
  for (const auto& judgement : judgements) participants.insert(judgement.participant);
  return static_cast<int>(participants.size());
}

bool isVoteTable(const base::CsvTable& table, std::span<const std::string> terms) {
  return table.find("force_n") && !table.find("term") &&
         std::any_of(terms.begin(), terms.end(), [&table](const std::string& term) { return table.find(term); });
}

Result<VoteTable> readVoteTable(const base::CsvTable& table, std::span<const std::string> terms) {
  TACTUS_TRY(const auto force, table.require("force_n"));
  std::vector<std::size_t> columns;
  for (const auto& term : terms) {
    TACTUS_TRY(const auto column, table.require(term));
    columns.push_back(column);
  }

  VoteTable out;
  std::set<double> taken;  // forces of the rows so far
  for (std::size_t column = 0; column < table.columns().size(); ++column) {
    if (column != force && std::find(columns.begin(), columns.end(), column) == columns.end()) {
      out.ignored.push_back(table.columns()[column]);
    }
  }
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    TACTUS_TRY(const auto force_n, table.number(row, force));
    if (force_n < 0) return table.refuse(row, force, ErrorCode::kValue, "a force of 0 N or more");
    VoteCounts step{force_n, {}};
    for (const std::size_t column : columns) {
      TACTUS_TRY(const auto votes, table.integer(row, column));
      if (votes < 0 || votes > kMostVotes) {
        return table.refuse(row, column, ErrorCode::kValue,
                            "a number of votes from 0 to " + std::to_string(kMostVotes));
      }
      step.votes.push_back(static_cast<int>(votes));
    }
    if (isTaken(taken, step.force_n)) return table.refuse(row, force, ErrorCode::kData, "each force once");
    taken.insert(step.force_n);
    out.steps.push_back(std::move(step));
  }
  if (out.steps.empty()) return base::inFile({ErrorCode::kData, {}, {}, "no rows", "one row per force"}, table.file());
  std::sort(out.steps.begin(), out.steps.end(), [](const auto& a, const auto& b) { return a.force_n < b.force_n; });
  return out;
}

namespace {

struct Decision {
  std::optional<std::size_t> term;
  VoteReason reason;
};

/// The lower median of the votes: the first term at which half of them is reached.
std::size_t lowerMedian(const std::vector<int>& votes, int total) {
  std::size_t term = 0;
  for (int sum = votes[0]; 2 * sum < total; sum += votes[term]) ++term;
  return term;
}

/// One step on its own; `last` is the level of the last decided step, before any running maximum.
Decision decide(const std::vector<int>& votes, std::optional<std::size_t> last) {
  const int total = std::accumulate(votes.begin(), votes.end(), 0);
  if (total == 0) return {std::nullopt, VoteReason::kNoVotes};

  std::size_t winners = 0;
  std::size_t highest_winner = 0;
  std::size_t lowest = votes.size();
  std::size_t highest = 0;
  for (std::size_t k = 0; k < votes.size(); ++k) {
    if (votes[k] == 0) continue;
    lowest = std::min(lowest, k);
    highest = k;
    if (2 * votes[k] >= total) {
      ++winners;
      highest_winner = k;
    }
  }
  if (winners > 0) return {highest_winner, winners == 1 ? VoteReason::kMajority : VoteReason::kTieHigher};
  if (!last) return {lowerMedian(votes, total), VoteReason::kFirstMedian};
  const std::size_t next = *last + 1;
  const std::size_t inside = std::clamp(next, lowest, highest);
  return {inside, inside == next ? VoteReason::kNextLevel : VoteReason::kClamped};
}

}  // namespace

std::string_view name(VoteReason reason) noexcept {
  switch (reason) {
    case VoteReason::kMajority: return "majority";
    case VoteReason::kTieHigher: return "tie_higher";
    case VoteReason::kNextLevel: return "next_level";
    case VoteReason::kClamped: return "clamped";
    case VoteReason::kFirstMedian: return "first_median";
    case VoteReason::kNoVotes: return "no_votes";
  }
  return "";
}

std::vector<VoteStep> vote(std::span<const VoteCounts> steps, std::optional<int> enrolled) {
  const auto votes_at = [](const VoteCounts& step) { return std::accumulate(step.votes.begin(), step.votes.end(), 0); };
  int quorum_of = enrolled.value_or(0);
  if (!enrolled) {
    for (const auto& step : steps) quorum_of = std::max(quorum_of, votes_at(step));
  }

  std::vector<VoteStep> out;
  std::optional<std::size_t> last;
  std::size_t level = 0;
  for (const auto& step : steps) {
    TACTUS_CHECK(!step.votes.empty() && step.votes.size() == steps.front().votes.size());
    TACTUS_CHECK(out.empty() || out.back().force_n < step.force_n);
    const auto [term, reason] = decide(step.votes, last);
    VoteStep result{step.force_n, step.votes, term, reason, false, 2 * votes_at(step) < quorum_of};
    if (term) {
      last = term;
      result.monotone_raised = *term < level;
      level = std::max(level, *term);
      result.term = level;
    }
    out.push_back(std::move(result));
  }
  return out;
}

bool isUnsaid(const VoteStep& step) { return step.term && step.votes[*step.term] == 0; }

bool isMostFrequent(const VoteStep& step) {
  return !step.term || step.votes[*step.term] == *std::max_element(step.votes.begin(), step.votes.end());
}

}  // namespace tactus::elicitation
