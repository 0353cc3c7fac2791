#include "elicitation/force/force_thresholds.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <span>
#include <string>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/membership.h"

#include "tests/elicitation/force/judged_letters.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

using Kind = study::ForceJudgement::Kind;
using Points = std::vector<double>;

/// What the table of judgements gives, with all who judged enrolled.
ThresholdTerms found(const std::vector<study::ForceJudgement>& judgements, std::optional<double> end_n = std::nullopt) {
  std::vector<std::string> ids;
  for (const auto& term : support::ngtOutput().terms) ids.push_back(term.id);
  const auto counts = countVotes(judgements, "ascending", ids);
  EXPECT_TRUE(counts);
  auto terms = thresholdTerms(support::ngtOutput(), judgements, "ascending",
                              vote(*counts, countParticipants(judgements)), end_n);
  EXPECT_TRUE(terms);
  return std::move(*terms);
}

void expectNear(const std::vector<double>& values, const Points& wanted) {
  ASSERT_EQ(values.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(values[i], wanted[i], 1e-9) << i;  // sums of tenths
}

void expectTerms(const ThresholdTerms& terms, const std::vector<Points>& wanted) {
  ASSERT_EQ(terms.output.terms.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    SCOPED_TRACE(terms.output.terms[k].id);
    expectNear(terms.output.terms[k].points, wanted[k]);
  }
}

/// Four monotone participants whose votes are the paper's Table 2.
std::vector<study::ForceJudgement> table2Split() {
  std::vector<study::ForceJudgement> all;
  judge(all, "P1", "smlVVVVVVVV");
  judge(all, "P2", "vsmmlllVVVV");
  judge(all, "P3", "vvssmmlllVV");
  judge(all, "P4", "vvvsmmmmllV");
  return all;
}

TEST(ForceThresholds, MeansOfFourParticipantsByHand) {
  // 0.05 N plus 0.1 N for each force with that term or a lower one.
  const auto terms = found(table2Split());
  ASSERT_EQ(terms.participants.size(), 4U);
  expectNear(terms.participants[0].threshold_n, {0.05, 0.15, 0.25, 0.35});
  expectNear(terms.participants[1].threshold_n, {0.15, 0.25, 0.45, 0.75});
  expectNear(terms.participants[2].threshold_n, {0.25, 0.45, 0.65, 0.95});
  expectNear(terms.participants[3].threshold_n, {0.35, 0.45, 0.85, 1.05});
  expectNear(terms.mean_n, {0.2, 0.325, 0.55, 0.775});
  expectTerms(terms, {{0, 0, 0.15, 0.25},
                      {0.15, 0.25, 0.275, 0.375},
                      {0.275, 0.375, 0.5, 0.6},
                      {0.5, 0.6, 0.725, 0.825},
                      {0.725, 0.825, 1.1, 1.1}});
  EXPECT_EQ(terms.output.max, 1.1);
  EXPECT_TRUE(terms.absent.empty());
  EXPECT_EQ(terms.participants[0].outside, 1);  // very small at no force
  EXPECT_EQ(terms.notes,
            (std::vector<std::string>{"Of 16 thresholds of the force 1 lies outside the forces that count and that the "
                                      "participant judged; half a step beyond these is taken."}));
}

/// The averaged model of four experts with rules of one condition and a region, on these force terms: rows well, medium
/// and poor lubrication, small, medium and large flexion, slow, medium and fast; columns the five regions of form_a2.
fuzzy::ForceModel averaged(const fuzzy::Variable& output, const std::vector<std::vector<std::string>>& experts) {
  const std::vector<fuzzy::Condition> rows = {
      {"lubrication", "well"},   {"lubrication", "medium"},  {"lubrication", "poor"},
      {"neck_flexion", "small"}, {"neck_flexion", "medium"}, {"neck_flexion", "large"},
      {"speed", "slow"},         {"speed", "medium"},        {"speed", "fast"}};
  fuzzy::ForceModel model;
  model.inputs = support::ngtInputs();
  model.inputs[2].terms = support::findDepthTerms("form_a2")->terms;
  model.output = output;
  for (const auto& words : experts) {
    fuzzy::Expert expert;
    expert.id = "E" + std::to_string(model.experts.size() + 1);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t region = 0; region < 5; ++region) {
        fuzzy::Rule rule;
        rule.conditions = {rows[row], {"depth", model.inputs[2].terms[region].id}};
        rule.then = output.terms[static_cast<std::size_t>(words[row][region] - '1')].id;
        expert.rules.push_back(rule);
      }
    }
    model.experts.push_back(std::move(expert));
  }
  return model;
}

TEST(ForceThresholds, TheForcesOfAnotherProgram) {
  // Computed elsewhere for these four tables of words (1 very small to 5 very large) and these thresholds.
  const auto model = averaged(found(table2Split()).output,
                              {{"12221", "13332", "34443", "23432", "23332", "22321", "13331", "23332", "33443"},
                               {"13333", "34442", "45554", "34443", "33433", "13432", "23332", "33443", "34544"},
                               {"12222", "33432", "24543", "23443", "22432", "22332", "22332", "23432", "23533"},
                               {"12231", "12242", "45554", "13332", "13332", "13453", "13321", "24442", "35554"}});
  const auto compiled = fuzzy::compile(model);
  ASSERT_TRUE(compiled) << compiled.error().message();
  const std::vector<std::pair<std::vector<double>, double>> wanted = {{{1, 60, 70, 50}, 0.25959},
                                                                      {{1, 60, 200, 50}, 0.49263},
                                                                      {{1, 60, 300, 50}, 0.42294},
                                                                      {{0.3, 45, 170, 80}, 0.62474}};
  for (const auto& [in, force_n] : wanted) EXPECT_NEAR(compiled->evaluate(in).force_n, force_n, 6e-6);  // five digits
}

TEST(ForceThresholds, BeyondIsAboveAllTermsAndNotFeltBelow) {
  std::vector<study::ForceJudgement> all;
  judge(all, "A", "nvsmlbb");
  judge(all, "B", "vssmlb");
  const auto terms = found(all);
  expectNear(terms.participants[0].threshold_n, {0.25, 0.35, 0.45, 0.55});
  expectNear(terms.participants[1].threshold_n, {0.15, 0.35, 0.45, 0.55});
  // No judgement is very large: it begins where both said "beyond", and the universe has room for it.
  expectTerms(
      terms,
      {{0, 0, 0.15, 0.25}, {0.15, 0.25, 0.3, 0.4}, {0.3, 0.4, 0.4, 0.5}, {0.4, 0.5, 0.5, 0.6}, {0.5, 0.6, 0.6, 0.6}});
  EXPECT_NEAR(terms.output.max, 0.6, 1e-9);
  EXPECT_EQ(terms.end_reason, "one step above the last force with a term");
}

TEST(ForceThresholds, AnswersOutOfOrderCancel) {
  // Small at 0.2 and 0.4, very small at 0.3: as if very small ended at 0.25.
  std::vector<study::ForceJudgement> all;
  judge(all, "A", "vsvsmlV");
  expectNear(found(all).participants[0].threshold_n, {0.25, 0.45, 0.55, 0.65});
}

TEST(ForceThresholds, AMissingAnswerBelongsToItsNeighbors) {
  // Nothing at 0.3 N: the stretches of 0.2 and 0.4 meet there.
  std::vector<study::ForceJudgement> all;
  judge(all, "A", "vs.mlV");
  expectNear(found(all).participants[0].threshold_n, {0.15, 0.3, 0.45, 0.55});
}

TEST(ForceThresholds, TermsThatNobodyUsedShareTheWidthOfTheirRamps) {
  // Small and medium are skipped by both: three equal thresholds at 0.25 N, each ramp a third of 0.1 N.
  std::vector<study::ForceJudgement> all;
  judge(all, "A", "vvlllVV");
  judge(all, "B", "vvlllVV");
  const auto terms = found(all);
  ASSERT_EQ(terms.output.terms.size(), 5U);
  EXPECT_NEAR(terms.output.terms[1].points[1], 0.2 + 0.1 / 3, 1e-6);  // rounded to a micronewton
  EXPECT_NEAR(terms.output.terms[2].points[1], 0.2 + 0.2 / 3, 1e-6);
  EXPECT_NEAR(terms.output.terms[3].points[1], 0.3, 1e-6);
}

TEST(ForceThresholds, WhoGoesOnAloneMovesNothingAboveTheQuorum) {
  std::vector<study::ForceJudgement> all;
  for (const char* who : {"A", "B", "C"}) judge(all, who, "vsmlb");
  judge(all, "D", "vsmllllV");
  const auto terms = found(all);
  // Up to 0.4 N all give terms, from 0.5 N on one: for all of them large ends half a step above 0.4 N.
  expectNear(terms.mean_n, {0.15, 0.25, 0.35, 0.45});
  EXPECT_NEAR(terms.output.max, 0.5, 1e-9);
  // Asked for, D's answers count: large ends at 0.75 N for D, at 0.45 N for the others.
  const auto all_of_them = found(all, 0.8);
  expectNear(all_of_them.mean_n, {0.15, 0.25, 0.35, 0.525});
  EXPECT_EQ(all_of_them.output.max, 0.8);
}

TEST(ForceThresholds, RandomAnswersGiveTermsThatSumToOne) {
  base::Random random(8);
  for (int round = 0; round < 600; ++round) {
    std::vector<study::ForceJudgement> all;
    // Sevenths of a step: ramps that touch in the middle of two micronewtons.
    const std::vector<std::string> participants = {"A", "B", "C", "D", "E", "F", "G"};
    for (const auto& who : std::span(participants).first(round % 2 == 0 ? 3 : 7)) {
      std::string answers = "v";
      for (int i = 0; i < 8; ++i) answers += "vsmlVbn."[random.below(8)];
      judge(all, who, answers);
    }
    const auto terms = found(all);
    for (const auto& term : terms.output.terms) {
      EXPECT_TRUE(std::is_sorted(term.points.begin(), term.points.end())) << round << ' ' << term.id;
    }
    for (double x = 0; x <= terms.output.max; x += 0.0137) {
      double sum = 0;
      for (const auto& term : terms.output.terms) sum += fuzzy::MembershipFunction::of(term)(x);
      EXPECT_NEAR(sum, 1, 1e-9) << x;  // ramps as narrow as a micronewton times rounding
    }
  }
}

}  // namespace
}  // namespace tactus::elicitation
