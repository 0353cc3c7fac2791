#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "app/session/simulated_nurse.h"
#include "experiments/published_tables.h"

namespace tactus::session {
namespace {

using Kind = study::ForceJudgement::Kind;

ResponderTraits noiseless(ResponderTraits traits) {
  traits.noise = 0;
  traits.lapse = 0;
  return traits;
}

TEST(SimulatedResponder, TheJustNoticeableDifference) {
  EXPECT_DOUBLE_EQ(justNoticeableN(0), 0.04);
  EXPECT_DOUBLE_EQ(justNoticeableN(1), std::sqrt(0.0016 + 0.0144));  // 0.1265 N: 0.8 of them are one step of 0.1 N
}

TEST(SimulatedResponder, NoiselessRespondersReproduceTable2) {
  const auto terms = experiments::publishedVoteTerms();
  const auto responders = respondersOfTable2();
  ASSERT_EQ(responders.size(), 4U);
  base::Random random(1);
  for (const auto& row : experiments::publishedVotes()) {
    std::map<std::string, int> votes;
    for (const auto& traits : responders) {
      const auto response = SimulatedResponder(noiseless(traits), terms).judge(row.force_n, random);
      ASSERT_EQ(response.kind, Kind::kTerm);
      ++votes[response.term];
    }
    for (std::size_t term = 0; term < terms.size(); ++term)
      EXPECT_EQ(votes[terms[term]], row.votes[term]) << row.force_n;
  }
}

TEST(SimulatedResponder, NoiselessRespondersReproduceTheSimulatedJudgements) {
  base::Random random(1);
  std::map<std::string, SimulatedResponder> responders;
  for (const auto& traits : respondersOfTable2()) {
    responders.emplace(traits.code, SimulatedResponder(noiseless(traits), experiments::publishedVoteTerms()));
  }
  for (const auto& judgement : simulatedJudgements()) {
    const auto response = responders.at(judgement.participant).judge(judgement.force_n, random);
    EXPECT_EQ(response.kind, judgement.kind) << judgement.participant << " " << judgement.force_n;
    EXPECT_EQ(response.term, judgement.term) << judgement.participant << " " << judgement.force_n;
  }
}

TEST(SimulatedResponder, ThresholdsLieBetweenTheForcesOfTable2) {
  // S4 of the split (facts: R-low): VS to 0.3 N, S at 0.4 N, M to 0.8 N, L to 1.0 N.
  const auto last = respondersOfTable2().back();
  const double wanted[] = {0.35, 0.45, 0.85, 1.05};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(last.threshold_n[i], wanted[i], 1e-12);
  // S1 calls 0.1 N small already: its first threshold is the middle to no force.
  EXPECT_NEAR(respondersOfTable2().front().threshold_n[0], 0.05, 1e-12);
}

TEST(SimulatedResponder, NoForceIsMostlyNotFelt) {
  SimulatedResponder responder(respondersOfTable2()[1], experiments::publishedVoteTerms());
  base::Random random(5);
  int not_felt = 0;
  for (int i = 0; i < 1000; ++i) not_felt += responder.judge(0, random).kind == Kind::kNotFelt ? 1 : 0;
  // P(N(0, 0.04) < 0.04) = 0.8413 without lapses (0.02): 824 expected, five standard deviations of 12
  EXPECT_NEAR(not_felt, 824, 60);
}

TEST(SimulatedResponder, LapsesAndAssimilation) {
  auto traits = noiseless(respondersOfTable2()[0]);
  traits.lapse = 1;
  base::Random random(2);
  std::map<std::string, int> terms;
  SimulatedResponder lapsing(traits, experiments::publishedVoteTerms());
  for (int i = 0; i < 1000; ++i) ++terms[lapsing.judge(0.1, random).term];
  for (const auto& term : experiments::publishedVoteTerms()) EXPECT_NEAR(terms[term], 200, 63);  // five deviations

  traits.lapse = 0;
  traits.assimilation = 0.1;
  SimulatedResponder drawn(traits, experiments::publishedVoteTerms());
  EXPECT_EQ(drawn.judge(1.0, random).percept_n, 1.0);
  EXPECT_DOUBLE_EQ(drawn.judge(0.5, random).percept_n, 0.55);  // 0.5 + 0.1 * (1.0 - 0.5)
}

}  // namespace
}  // namespace tactus::session
