// The vote that gives each force a term (paper, Section 3.3, Table 2).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/study/records.h"

namespace tactus::elicitation {

/// The reason for a step's term.
enum class VoteReason {
  kMajority,     ///< one term has at least half of the votes
  kTieHigher,    ///< two terms have half each: the higher one wins
  kNextLevel,    ///< no term has half: one term above that of the last decided step, because the forces rise
  kClamped,      ///< as kNextLevel, but moved into the range of the terms with votes
  kFirstMedian,  ///< no term has half and no earlier step was decided: the lower median
  kNoVotes,      ///< no votes; no term
};

/// `majority`, `tie_higher`, `next_level`, `clamped`, `first_median`, `no_votes`.
std::string_view name(VoteReason reason) noexcept;

/// Forces closer than this are one step; commanded forces are 0.1 N apart.
inline constexpr double kSameForceN = 1e-9;

/// The number of votes for each term at one force, lowest term first.
struct VoteCounts {
  double force_n = 0;
  std::vector<int> votes;
};

/// The outcome at one force.
struct VoteStep {
  double force_n = 0;
  std::vector<int> votes;
  std::optional<std::size_t> term;  ///< index of the term; empty without votes
  VoteReason reason = VoteReason::kNoVotes;
  bool monotone_raised = false;  ///< raised to the term of an earlier step, because terms must not fall
  bool below_quorum = false;     ///< less than half of the enrolled participants voted
};

/// Votes on every step. A term wins with at least half of the step's votes. The running maximum over the steps is
/// applied last. `steps`: in ascending force, all with the same number of terms (at least one) and votes >= 0.
/// `enrolled`: number of participants for the quorum; without it, the largest number of votes at a step.
std::vector<VoteStep> vote(std::span<const VoteCounts> steps, std::optional<int> enrolled = std::nullopt);

/// Whether the step's term has no vote at all: it follows from the rule alone. Such a term is named wherever it is
/// used.
bool isUnsaid(const VoteStep& step);
/// Whether no other term has more votes than the step's. True for a step without a term.
bool isMostFrequent(const VoteStep& step);

/// Counts the judgements of one `series` at each commanded force. Forces closer than kSameForceN are one step.
/// `not_felt`, `beyond_practice` and missing answers are not votes, but their step stays. Returns an error for: a
/// series without judgements, a term that is not in `terms` (ids, lowest first), a participant with two judgements of
/// one force, a force below 0 N. The error has the line of a judgement from a table.
base::Result<std::vector<VoteCounts>> countVotes(std::span<const study::ForceJudgement> judgements,
                                                 std::string_view series, std::span<const std::string> terms);

/// The number of participants in the judgements, over all series.
int countParticipants(std::span<const study::ForceJudgement> judgements);

/// A table of vote counts as printed in Table 2: `force_n` and one column per term.
struct VoteTable {
  std::vector<VoteCounts> steps;     ///< ascending force
  std::vector<std::string> ignored;  ///< columns that are neither force_n nor a term
};

/// Whether `table` is a table of counts (force_n and a column for one of the terms), not one of judgements.
bool isVoteTable(const base::CsvTable& table, std::span<const std::string> terms);

/// Reads a table of counts. Returns an error for: a missing column, a count that is not an integer from 0 to a million,
/// a negative force, a duplicate force, no rows.
base::Result<VoteTable> readVoteTable(const base::CsvTable& table, std::span<const std::string> terms);

}  // namespace tactus::elicitation
