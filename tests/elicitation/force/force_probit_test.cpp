#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "core/base/random.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force/force_terms_from.h"

#include "tests/elicitation/force/judged_letters.h"
#include "tests/elicitation/table2.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

using Kind = study::ForceJudgement::Kind;
using Points = std::vector<double>;

fuzzy::Variable wordsOf(std::size_t count) {
  fuzzy::Variable out{.id = "force", .label = "", .unit = "N", .min = 0, .max = 1.1, .terms = {}};
  for (std::size_t k = 0; k < count; ++k) out.terms.push_back({"t" + std::to_string(k), "", {}, {}});
  return out;
}

ProbitTerms ofCounts(const std::vector<VoteCounts>& counts) {
  auto terms = probitTerms(wordsOf(counts.front().votes.size()), {}, "ascending", vote(counts));
  EXPECT_TRUE(terms);
  return std::move(*terms);
}

ProbitTerms ofJudgements(const std::vector<study::ForceJudgement>& judgements) {
  std::vector<std::string> ids;
  for (const auto& term : support::ngtOutput().terms) ids.push_back(term.id);
  const auto counts = countVotes(judgements, "ascending", ids);
  EXPECT_TRUE(counts);
  auto terms = probitTerms(support::ngtOutput(), judgements, "ascending", vote(*counts, countParticipants(judgements)));
  EXPECT_TRUE(terms);
  return std::move(*terms);
}

void expectNear(const std::vector<double>& values, const Points& wanted, double tolerance) {
  ASSERT_EQ(values.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(values[i], wanted[i], tolerance) << i;
}

// Two forces and two terms leave no room for error: P(low) is 3/4 at 0.2 N and 1/4 at 0.4 N. So the threshold is 0.3 N
// and 0.1 / sigma the 75 % quantile of the normal distribution, 0.6744897502. The last ramp ends with the forces.
TEST(ForceProbit, TwoForcesByHand) {
  const auto terms = ofCounts({{0.2, {3, 1}}, {0.4, {1, 3}}});
  EXPECT_EQ(terms.answers, 8);
  expectNear(terms.threshold_n, {0.3}, 1e-6);                    // rounded to a micronewton
  EXPECT_NEAR(terms.sigma_n.value(), 0.1 / 0.6744897502, 1e-6);  // where the search ends
  expectNear(terms.output.terms[0].points, {0, 0, 0.2, 0.4}, 2e-6);
  expectNear(terms.output.terms[1].points, {0.2, 0.4, 0.4, 0.4}, 2e-6);
  EXPECT_TRUE(terms.notes.empty());
  EXPECT_EQ(terms.output.max, 0.4);
}

// Reference: R 4.2, MASS::polr(term ~ force, method = "probit", reltol = 1e-15) on the 44 answers of Table 2.
TEST(ForceProbit, TheThresholdsOfTable2AgreeWithPolr) {
  const auto terms = ofCounts(table2());
  EXPECT_EQ(terms.answers, 44);
  const Points wanted = {0.14507406776, 0.32309355438, 0.57264420243, 0.77609569005};
  const double sigma_n = 0.21317904755;
  // polr ends by differences of the deviance: about six digits of the parameters
  expectNear(terms.threshold_n, wanted, 1e-5);
  EXPECT_NEAR(terms.sigma_n.value(), sigma_n, 1e-5);
  // sqrt(3) sigma is wider than the gaps: each ramp reaches to the middle of the nearer gap.
  ASSERT_EQ(terms.output.terms.size(), 5U);
  for (std::size_t k = 0; k < 4; ++k) {
    double side_n = std::sqrt(3.0) * sigma_n;
    if (k > 0) side_n = std::min(side_n, (wanted[k] - wanted[k - 1]) / 2);
    side_n = std::min({side_n, k < 3 ? (wanted[k + 1] - wanted[k]) / 2 : 1.1 - wanted[k], wanted[k]});
    EXPECT_NEAR(terms.output.terms[k + 1].points[0], wanted[k] - side_n, 3e-5) << k;
    EXPECT_NEAR(terms.output.terms[k + 1].points[1], wanted[k] + side_n, 3e-5) << k;
  }
  EXPECT_EQ(terms.output.max, 1.1);
}

// Everyone changes words at the same forces.
TEST(ForceProbit, WithoutOverlapTheWordsChangeBetweenTheForces) {
  std::vector<study::ForceJudgement> all;
  for (const char* who : {"A", "B"}) judge(all, who, "vvssmmllVV");
  const auto terms = ofJudgements(all);
  EXPECT_FALSE(terms.sigma_n.has_value());
  expectNear(terms.threshold_n, {0.25, 0.45, 0.65, 0.85}, 1e-9);
  expectNear(terms.output.terms[2].points, {0.4, 0.5, 0.6, 0.7}, 1e-9);  // half a step to both sides
  EXPECT_EQ(terms.notes, (std::vector<std::string>{
                             "Ordered probit: the answers of neighboring terms do not overlap in force, or the "
                             "terms fall while it rises. The likelihood has no maximum then; the terms change "
                             "in the middle between the forces, at 0.25, 0.45, 0.65, 0.85 N."}));
}

TEST(ForceProbit, BeyondIsAboveAllTermsAndNotFeltBelow) {
  // As if "n" were very small, and "b" very large: the same answers in words.
  std::vector<study::ForceJudgement> words;
  judge(words, "A", "vvsmsmlVVV");
  judge(words, "B", "vsvmmllVVV");
  std::vector<study::ForceJudgement> outside;
  judge(outside, "A", "nvsmsmlVVV");
  judge(outside, "B", "nsvmmllbVV");
  const auto wanted = ofJudgements(words);
  const auto found = ofJudgements(outside);
  ASSERT_TRUE(wanted.sigma_n.has_value());
  EXPECT_EQ(found.answers, 20);
  EXPECT_EQ(found.threshold_n, wanted.threshold_n);
  EXPECT_EQ(found.sigma_n, wanted.sigma_n);
}

TEST(ForceProbit, AThresholdWithoutAnswersAboveLiesHalfAStepOutside) {
  std::vector<study::ForceJudgement> all;
  for (const char* who : {"A", "B"}) judge(all, who, "vsmlb");
  // The forces count up to 0.4 N, so nothing is above large.
  const auto terms = ofJudgements(all);
  expectNear(terms.threshold_n, {0.15, 0.25, 0.35, 0.45}, 1e-9);
  EXPECT_NEAR(terms.output.max, 0.5, 1e-9);
  EXPECT_EQ(terms.end_reason, "one step above the last force with a term");
  ASSERT_EQ(terms.notes.size(), 2U);
  EXPECT_EQ(terms.notes[1],
            "Of 4 thresholds of the force 1 lies outside the forces that count; half a step beyond these is taken.");
}

TEST(ForceProbit, RandomAnswersGiveTermsThatSumToOne) {
  base::Random random(9);
  for (int round = 0; round < 300; ++round) {
    std::vector<study::ForceJudgement> all;
    for (const char* who : {"A", "B", "C", "D"}) {
      std::string answers = "v";
      for (int i = 0; i < 8; ++i) answers += "vsmlVbn."[random.below(8)];
      judge(all, who, answers);
    }
    const auto terms = ofJudgements(all);
    EXPECT_TRUE(std::is_sorted(terms.threshold_n.begin(), terms.threshold_n.end())) << round;
    for (double x = 0; x <= terms.output.max; x += 0.0137) {
      double sum = 0;
      for (const auto& term : terms.output.terms) sum += fuzzy::MembershipFunction::of(term)(x);
      EXPECT_NEAR(sum, 1, 1e-9) << round << ' ' << x;  // ramps as narrow as a micronewton times rounding
    }
  }
}

}  // namespace
}  // namespace tactus::elicitation
