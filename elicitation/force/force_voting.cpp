#include "elicitation/force/force_voting.h"

#include <algorithm>
#include <numeric>

#include "core/base/check.h"

namespace tactus::elicitation {
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
    case VoteReason::kMajority:
      return "majority";
    case VoteReason::kTieHigher:
      return "tie_higher";
    case VoteReason::kNextLevel:
      return "next_level";
    case VoteReason::kClamped:
      return "clamped";
    case VoteReason::kFirstMedian:
      return "first_median";
    case VoteReason::kNoVotes:
      return "no_votes";
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
