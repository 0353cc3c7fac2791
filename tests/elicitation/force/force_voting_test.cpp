#include "elicitation/force/force_voting.h"

#include <gtest/gtest.h>

#include "tests/elicitation/table2.h"

namespace tactus::elicitation {
namespace {

using Votes = std::vector<std::vector<int>>;

/// Steps 0.1, 0.2, … N with these votes.
std::vector<VoteStep> voteOn(const Votes& votes, std::optional<int> enrolled = std::nullopt) {
  std::vector<VoteCounts> steps;
  for (const auto& step : votes) steps.push_back({0.1 * static_cast<double>(steps.size() + 1), step});
  return vote(steps, enrolled);
}

TEST(ForceVoting, TableTwoHasItsElevenWinners) {
  const auto steps = vote(table2());
  ASSERT_EQ(steps.size(), 11U);
  using enum VoteReason;
  // Winners of the paper's rule; the reasons follow by hand from the printed votes.
  const std::vector<std::size_t> terms{0, 0, 1, 1, 2, 2, 3, 4, 4, 4, 4};
  const std::vector<VoteReason> reasons{kMajority, kMajority, kNextLevel, kMajority, kMajority, kMajority,
                                        kMajority, kMajority, kTieHigher, kMajority, kMajority};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    SCOPED_TRACE(steps[i].force_n);
    EXPECT_EQ(steps[i].term, terms[i]);
    EXPECT_EQ(steps[i].reason, reasons[i]);
    EXPECT_FALSE(steps[i].monotone_raised);
    EXPECT_FALSE(steps[i].below_quorum);
  }
}

TEST(ForceVoting, HalfOfTheVotesWin) {
  const auto steps = voteOn({{2, 1, 1}, {3, 3, 0}});
  EXPECT_EQ(steps[0].term, 0U);
  EXPECT_EQ(steps[0].reason, VoteReason::kMajority);
  EXPECT_EQ(steps[1].term, 1U);
  EXPECT_EQ(steps[1].reason, VoteReason::kTieHigher);
}

TEST(ForceVoting, FirstStepWithoutWinnerTakesTheLowerMedian) {
  EXPECT_EQ(voteOn({{1, 1, 1, 1, 0}})[0].term, 1U);
  EXPECT_EQ(voteOn({{1, 1, 1, 0, 1}})[0].reason, VoteReason::kFirstMedian);
  EXPECT_EQ(voteOn({{0, 2, 1, 1, 1}})[0].term, 2U);  // five votes: the third
  // A step without votes decides nothing, so the next one is still the first.
  const auto steps = voteOn({{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(steps[0].reason, VoteReason::kNoVotes);
  EXPECT_FALSE(steps[0].term);
  EXPECT_EQ(steps[1].reason, VoteReason::kFirstMedian);
  EXPECT_EQ(steps[1].term, 1U);
}

TEST(ForceVoting, WithoutWinnerTheNextLevelInsideTheVotedRange) {
  // After level 0 the next is 1, but the votes run from 2 to 4.
  auto steps = voteOn({{4, 0, 0, 0, 0}, {0, 0, 1, 1, 1}});
  EXPECT_EQ(steps[1].term, 2U);
  EXPECT_EQ(steps[1].reason, VoteReason::kClamped);
  // After level 4 there is none above; the votes end at 4.
  steps = voteOn({{0, 0, 0, 0, 4}, {0, 0, 1, 1, 1}});
  EXPECT_EQ(steps[1].term, 4U);
  EXPECT_EQ(steps[1].reason, VoteReason::kClamped);
  steps = voteOn({{0, 4, 0, 0, 0}, {1, 1, 1, 1, 0}});
  EXPECT_EQ(steps[1].term, 2U);
  EXPECT_EQ(steps[1].reason, VoteReason::kNextLevel);
}

TEST(ForceVoting, LevelsNeverFallButTheRuleLooksAtTheUnraisedLevel) {
  // Decided 3, 1 (raised to 3), then no winner: 1 + 1 = 2, raised to 3 again.
  const auto steps = voteOn({{0, 0, 0, 4}, {0, 4, 0, 0}, {1, 1, 1, 1}, {0, 0, 0, 4}});
  EXPECT_EQ(steps[1].term, 3U);
  EXPECT_TRUE(steps[1].monotone_raised);
  EXPECT_EQ(steps[2].reason, VoteReason::kNextLevel);
  EXPECT_EQ(steps[2].term, 3U);
  EXPECT_TRUE(steps[2].monotone_raised);
  EXPECT_FALSE(steps[3].monotone_raised);
}

TEST(ForceVoting, QuorumIsHalfOfTheEnrolled) {
  const auto steps = voteOn({{2, 0}, {1, 0}, {0, 0}}, 4);
  EXPECT_FALSE(steps[0].below_quorum);
  EXPECT_TRUE(steps[1].below_quorum);
  EXPECT_EQ(steps[1].reason, VoteReason::kMajority);
  EXPECT_TRUE(steps[2].below_quorum);
  EXPECT_TRUE(voteOn({{3, 0}, {1, 0}})[1].below_quorum);  // without enrolment: three voted at most
}

study::ForceJudgement judged(const char* who, double force_n, const char* term, const char* series = "ascending") {
  return {who, series, 1, force_n, study::ForceJudgement::Kind::kTerm, term};
}

const std::vector<std::string> kForceWords{"low", "high"};

TEST(ForceVoting, CountsOneSeriesByCommandedForce) {
  std::vector<study::ForceJudgement> judgements{judged("P1", 0.3, "high"), judged("P1", 0.1, "low"),
                                                judged("P2", 0.1 + 0.2, "high"), judged("P2", 0.1, "high", "random")};
  judgements.push_back({"P2", "ascending", 1, 0.1, study::ForceJudgement::Kind::kNotFelt, ""});
  judgements.push_back({"P1", "ascending", 4, 0.4, study::ForceJudgement::Kind::kBeyondPractice, ""});
  judgements.push_back({"P2", "ascending", 4, 0.4, study::ForceJudgement::Kind::kNoAnswer, ""});
  const auto steps = countVotes(judgements, "ascending", kForceWords);
  ASSERT_TRUE(steps);
  ASSERT_EQ(steps->size(), 3U);
  EXPECT_EQ((*steps)[0].votes, (std::vector<int>{1, 0}));
  EXPECT_EQ((*steps)[1].force_n, 0.3);
  EXPECT_EQ((*steps)[1].votes, (std::vector<int>{0, 2}));
  EXPECT_EQ((*steps)[2].votes, (std::vector<int>{0, 0}));
  EXPECT_EQ(countParticipants(judgements), 2);
}

TEST(ForceVoting, RefusesWhatCannotBeCounted) {
  const auto message = [](std::vector<study::ForceJudgement> judgements) {
    const auto steps = countVotes(judgements, "ascending", kForceWords);
    return steps ? std::string("no error") : steps.error().message();
  };
  EXPECT_EQ(message({judged("P1", 0.1, "huge")}),
            "judgement of participant P1 at 0.1 N: found term 'huge', wanted one of low, high");
  EXPECT_EQ(
      message({judged("P1", 0.1, "low"), judged("P1", 0.1, "high")}),
      "judgement of participant P1 at 0.1 N: found a second judgement in series 'ascending', wanted one judgement "
      "per participant and force");
  EXPECT_EQ(message({judged("P1", 0.1, "low", "random")}),
            "judgements: found no row of series 'ascending', wanted a series that was judged (there are: random)");
  EXPECT_EQ(message({judged("P1", -0.1, "low")}).find("judgement of participant P1: found -0.1 N"), 0U);
}

TEST(ForceVoting, ReadsATableOfCounts) {
  const auto table = base::CsvTable::parse("force_n,low,high,remark\n0.2,1,3,x\n0.1,4,0,\n", "votes.csv");
  ASSERT_TRUE(table);
  EXPECT_TRUE(isVoteTable(*table, kForceWords));
  const auto read = readVoteTable(*table, kForceWords);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->ignored, std::vector<std::string>{"remark"});
  ASSERT_EQ(read->steps.size(), 2U);
  EXPECT_EQ(read->steps[0].force_n, 0.1);
  EXPECT_EQ(read->steps[1].votes, (std::vector<int>{1, 3}));
}

TEST(ForceVoting, RefusesABrokenTableOfCounts) {
  for (const char* text :
       {"force_n,low\n0.1,1\n", "force_n,low,high\n0.1,1,-1\n", "force_n,low,high\n0.1,1,1.5\n",
        "force_n,low,high\n0.1,1,1\n0.1,2,0\n", "force_n,low,high\n0.3,1,1\n0.30000000000000004,2,0\n",
        "force_n,low,high\n", "low,high\n1,1\n", "force_n,low,high\n-0.1,1,1\n",
        "force_n,low,high\n0.1,1,99999999999\n"}) {
    const auto table = base::CsvTable::parse(text, "votes.csv");
    ASSERT_TRUE(table);
    const auto read = readVoteTable(*table, kForceWords);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().file, "votes.csv");
  }
}

}  // namespace
}  // namespace tactus::elicitation
