#include <gtest/gtest.h>

#include "elicitation/force/force_end.h"

namespace tactus::elicitation {
namespace {

study::ForceJudgement judged(const char* who, int step, double force_n, std::uint32_t line = 0,
                             const char* series = "ascending") {
  return {who, series, step, force_n, study::ForceJudgement::Kind::kTerm, "small", {line}};
}

TEST(StepForces, TheSameForcesNeedNoNote) {
  const std::vector<study::ForceJudgement> judgements = {judged("A", 1, 0.1), judged("B", 1, 0.1 + 1e-12),
                                                         judged("A", 2, 0.2), judged("B", 1, 0.7, 0, "random")};
  EXPECT_TRUE(stepForceNotes(judgements, "ascending").empty());
}

TEST(StepForces, WhoDiffersFromMostIsNamedOnce) {
  const std::vector<study::ForceJudgement> judgements = {
      judged("A", 1, 0.15, 2), judged("B", 1, 0.1, 3), judged("C", 1, 0.1, 4),  judged("A", 2, 0.25, 5),
      judged("B", 2, 0.2, 6),  judged("C", 2, 0.2, 7), judged("C", 3, 0.35, 8), judged("A", 3, 0.1 + 0.2, 9)};
  EXPECT_EQ(stepForceNotes(judgements, "ascending"),
            (std::vector<std::string>{
                "Participant A judged other forces than most participants in series 'ascending': step 1 "
                "(judgements.csv, line 2) is at 0.15 N, for most at 0.1 N; 2 steps differ in all.",
                "Participant C judged other forces than most participants in series 'ascending': step 3 "
                "(judgements.csv, line 8) is at 0.35 N, for most at 0.3 N."}));
}

}  // namespace
}  // namespace tactus::elicitation
