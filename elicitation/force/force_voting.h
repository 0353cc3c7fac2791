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

/// Why a step got its term.
enum class VoteReason {
  kMajority,     ///< one term has half of the votes or more
  kTieHigher,    ///< two terms have half each: the higher
  kNextLevel,    ///< no term has half: one above the last decided step's own term, because the series rises
  kClamped,      ///< the same, moved into the range of the levels that were voted for
  kFirstMedian,  ///< no term has half and no step was decided before: the lower median
  kNoVotes,      ///< nobody voted; no term
};

/// `majority`, `tie_higher`, `next_level`, `clamped`, `first_median`, `no_votes`.
std::string_view name(VoteReason reason) noexcept;

/// Forces closer than this are one step; commanded forces are 0.1 N apart.
inline constexpr double kSameForceN = 1e-9;

/// The votes at one force: how many for each term, lowest term first.
struct VoteCounts {
  double force_n = 0;
  std::vector<int> votes;
};

/// The outcome at one force.
struct VoteStep {
  double force_n = 0;
  std::vector<int> votes;
  std::optional<std::size_t> term;  ///< index of the term; absent where nobody voted
  VoteReason reason = VoteReason::kNoVotes;
  bool monotone_raised = false;  ///< raised to the level of an earlier step, because the levels must not fall
  bool below_quorum = false;     ///< less than half of the enrolled participants voted
};

/// Votes on every step: a term wins with half of the step's votes or more; the running maximum over the steps comes
/// last. `steps` in ascending force, all with the same number of terms (at least one) and votes >= 0. `enrolled`
/// participants make the quorum; without it, the largest number of votes at a step.
std::vector<VoteStep> vote(std::span<const VoteCounts> steps, std::optional<int> enrolled = std::nullopt);

/// Counts the judgements of one `series` at each commanded force; forces closer than kSameForceN are one step.
/// `not_felt`, `beyond_practice` and missing answers are no votes, their step stays. Refused: a series without
/// judgements, a term that is not in `terms` (ids, lowest first), a participant who judged a force twice, a force below
/// 0 N; a judgement from a table is named by its line.
base::Result<std::vector<VoteCounts>> countVotes(std::span<const study::ForceJudgement> judgements,
                                                 std::string_view series, std::span<const std::string> terms);

/// How many participants the judgements name, over all series.
int countParticipants(std::span<const study::ForceJudgement> judgements);

/// A table of vote counts as printed in Table 2: `force_n` and one column per term.
struct VoteTable {
  std::vector<VoteCounts> steps;     ///< ascending force
  std::vector<std::string> ignored;  ///< columns that are neither force_n nor a term
};

/// Whether `table` is a table of counts (it has force_n and a column for one of the terms) and not one of judgements.
bool isVoteTable(const base::CsvTable& table, std::span<const std::string> terms);

/// Reads a table of counts. Refused: a missing column, a count that is not a whole number from 0 to a million, a
/// negative force, a force twice, no rows.
base::Result<VoteTable> readVoteTable(const base::CsvTable& table, std::span<const std::string> terms);

}  // namespace tactus::elicitation
