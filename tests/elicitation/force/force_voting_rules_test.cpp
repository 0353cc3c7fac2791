// The vote against a slow restatement of its rules, on generated votes.
#include <algorithm>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {
namespace {

struct Expected {
  std::optional<std::size_t> term;
  VoteReason reason;
  bool raised;
  bool below_quorum;
};

/// Every vote cast at a step, written out: 0 0 0 1 for three votes for the lowest term and one for the next.
std::vector<std::size_t> ballots(const VoteCounts& step) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < step.votes.size(); ++k) {
    for (int vote = 0; vote < step.votes[k]; ++vote) out.push_back(k);
  }
  return out;
}

/// The rules as one would tell them to a person, step by step.
std::vector<Expected> restated(const std::vector<VoteCounts>& steps, int enrolled) {
  std::vector<Expected> out;
  std::vector<std::size_t> decided;  // before any raising
  for (const auto& step : steps) {
    const auto cast = ballots(step);
    const bool below_quorum = static_cast<double>(cast.size()) < enrolled / 2.0;
    if (cast.empty()) {
      out.push_back({std::nullopt, VoteReason::kNoVotes, false, below_quorum});
      continue;
    }
    std::vector<std::size_t> winners;
    for (std::size_t k = 0; k < step.votes.size(); ++k) {
      const auto share =
          static_cast<double>(std::count(cast.begin(), cast.end(), k)) / static_cast<double>(cast.size());
      if (share >= 0.5) winners.push_back(k);
    }
    std::size_t term = 0;
    VoteReason reason = VoteReason::kMajority;
    if (winners.size() == 1) {
      term = winners.front();
    } else if (winners.size() == 2) {
      term = winners.back();
      reason = VoteReason::kTieHigher;
    } else if (decided.empty()) {
      term = cast[(cast.size() - 1) / 2];
      reason = VoteReason::kFirstMedian;
    } else {
      term = decided.back() + 1;
      reason = VoteReason::kNextLevel;
      if (term < cast.front() || term > cast.back()) {
        term = term < cast.front() ? cast.front() : cast.back();
        reason = VoteReason::kClamped;
      }
    }
    decided.push_back(term);
    const std::size_t level = *std::max_element(decided.begin(), decided.end());
    out.push_back({level, reason, level > term, below_quorum});
  }
  return out;
}

void expectAsRestated(const std::vector<VoteCounts>& steps, int enrolled) {
  const auto expected = restated(steps, enrolled);
  const auto found = vote(steps, enrolled);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].term, expected[i].term) << i;
    EXPECT_EQ(found[i].reason, expected[i].reason) << i;
    EXPECT_EQ(found[i].monotone_raised, expected[i].raised) << i;
    EXPECT_EQ(found[i].below_quorum, expected[i].below_quorum) << i;
    EXPECT_EQ(found[i].votes, steps[i].votes) << i;
  }
}

TEST(ForceVotingRules, GeneratedVotesGoAsTheRulesSay) {
  base::Random random(11);
  std::vector<int> reasons(6);
  int raised = 0;
  for (int study = 0; study < 20'000; ++study) {
    const auto terms = static_cast<std::size_t>(1 + random.below(7));
    const int voters = 1 + random.below(study % 10 == 0 ? 40 : 6);
    const double missing = random.uniform() < 0.5 ? 0 : random.uniform(0, 0.7);
    std::vector<VoteCounts> steps;
    for (int i = 1, count = 1 + random.below(12); i <= count; ++i) {
      VoteCounts step{0.1 * i, std::vector<int>(terms)};
      for (int voter = 0; voter < voters; ++voter) {
        if (random.uniform() >= missing) ++step.votes[static_cast<std::size_t>(random.below(static_cast<int>(terms)))];
      }
      steps.push_back(std::move(step));
    }
    expectAsRestated(steps, voters);
    if (HasFailure()) FAIL() << "study " << study;
    for (const auto& step : vote(steps, voters)) {
      ++reasons[static_cast<std::size_t>(step.reason)];
      raised += step.monotone_raised ? 1 : 0;
    }
  }
  for (const int times : reasons) EXPECT_GT(times, 500) << "a rule was hardly tried";
  EXPECT_GT(raised, 500);
}

TEST(ForceVotingRules, EveryVoteOfFourPersonsOnThreeTermsAfterEveryLevel) {
  for (std::size_t before = 0; before < 3; ++before) {
    VoteCounts first{0.1, std::vector<int>(3)};
    first.votes[before] = 4;
    for (int low = 0; low <= 4; ++low) {
      for (int middle = 0; low + middle <= 4; ++middle) {
        for (int high = 0; low + middle + high <= 4; ++high) {
          expectAsRestated({first, {0.2, {low, middle, high}}}, 4);
          expectAsRestated({{0.2, {low, middle, high}}}, 4);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tactus::elicitation
