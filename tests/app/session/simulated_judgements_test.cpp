#include <algorithm>
#include <gtest/gtest.h>
#include <map>

#include "app/session/simulated_nurse.h"
#include "experiments/published_tables.h"

namespace tactus::session {
namespace {

using Kind = study::ForceJudgement::Kind;

TEST(SimulatedJudgements, GiveTheVotesOfTable2) {
  const auto terms = experiments::publishedVoteTerms();
  std::map<int, std::vector<int>> counts;
  for (const auto& judgement : simulatedJudgements()) {
    if (judgement.kind != Kind::kTerm) continue;
    auto& row = counts.try_emplace(judgement.step, terms.size(), 0).first->second;
    ++row[static_cast<std::size_t>(std::find(terms.begin(), terms.end(), judgement.term) - terms.begin())];
  }
  const auto table = experiments::publishedVotes();
  ASSERT_EQ(counts.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) EXPECT_EQ(counts[static_cast<int>(i) + 1], table[i].votes);
}

// The split of Table 2 into four monotone participants, by hand.
TEST(SimulatedJudgements, AreTheFourMonotoneParticipants) {
  const std::map<std::string, std::vector<std::string>> wanted = {
      {"S1", {"S", "M", "L", "VL", "VL", "VL", "VL", "VL", "VL", "VL", "VL"}},
      {"S2", {"VS", "S", "M", "M", "L", "L", "L", "VL", "VL", "VL", "VL"}},
      {"S3", {"VS", "VS", "S", "S", "M", "M", "L", "L", "L", "VL", "VL"}},
      {"S4", {"VS", "VS", "VS", "S", "M", "M", "M", "M", "L", "L", "VL"}}};
  const std::map<std::string, std::string> abbreviations = {
      {"very_small", "VS"}, {"small", "S"}, {"medium", "M"}, {"large", "L"}, {"very_large", "VL"}};
  std::map<std::string, std::vector<std::string>> said;
  for (const auto& judgement : simulatedJudgements()) {
    if (judgement.kind == Kind::kTerm) said[judgement.participant].push_back(abbreviations.at(judgement.term));
  }
  EXPECT_EQ(said, wanted);
}

TEST(SimulatedJudgements, GoOnBeyondPracticeTo1700Millinewtons) {
  const auto judgements = simulatedJudgements();
  ASSERT_EQ(judgements.size(), 4U * 17U);
  for (const auto& judgement : judgements) {
    EXPECT_EQ(judgement.series, "ascending");
    EXPECT_EQ(judgement.force_n, judgement.step / 10.0);
    EXPECT_EQ(judgement.kind, judgement.step <= 11 ? Kind::kTerm : Kind::kBeyondPractice);
  }
}

}  // namespace
}  // namespace tactus::session
