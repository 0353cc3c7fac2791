#include "app/report/claims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/ngt_model.h"

namespace tactus::report {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;

const std::vector<std::string> kRegions = {"nasal_cavity",   "nasopharynx", "oropharynx",
                                           "laryngopharynx", "esophagus",   "stomach"};
// Alone, the middle terms have their centroids at .35, .55 and .7 N at whatever height they are clipped, because they
// are symmetric.
constexpr const char* kSmall = "small";
constexpr const char* kMedium = "medium";
constexpr const char* kLarge = "large";

/// An expert whose force depends on the region alone, one term per region.
Expert byRegion(const std::string& id, const std::array<const char*, 6>& forces) {
  Expert expert{.id = id, .label = id, .overrides = {}, .rules = {}};
  for (std::size_t i = 0; i < kRegions.size(); ++i) expert.rules.push_back({{{"depth", kRegions[i]}}, forces[i]});
  return expert;
}

/// An expert whose force depends on one input alone: its three terms, in every region.
Expert byInput(const std::string& id, const std::string& input, const std::array<const char*, 3>& terms,
               const std::array<const char*, 3>& forces) {
  Expert expert{.id = id, .label = id, .overrides = {}, .rules = {}};
  for (const std::string& region : kRegions) {
    for (std::size_t i = 0; i < 3; ++i) {
      expert.rules.push_back({{{input, terms[i]}, {"depth", region}}, forces[i]});
    }
  }
  return expert;
}

ForceModel modelOf(std::vector<Expert> experts) {
  ForceModel model = support::ngtVariables();
  model.experts = std::move(experts);
  return model;
}

Verdict verdictOf(const ForceModel& model, const std::string& id, const std::string& subject) {
  const auto claims = checkClaims(model, {});
  EXPECT_TRUE(claims);
  for (const Claim& claim : *claims) {
    if (claim.id != id) continue;
    for (const Verdict& verdict : claim.verdicts) {
      if (verdict.subject == subject) return verdict;
    }
  }
  ADD_FAILURE() << "no verdict " << id << " of " << subject;
  return {};
}

bool holds(const ForceModel& model, const std::string& id, const std::string& subject) {
  const Verdict verdict = verdictOf(model, id, subject);
  EXPECT_TRUE(verdict.holds) << id << ' ' << subject << ": " << verdict.reason;
  return verdict.holds.value_or(false);
}

TEST(Claims, LubricationLowersTheForceOrNot) {
  const auto yes = modelOf({byInput("S4", "lubrication", {"poor", "medium", "well"}, {kLarge, kMedium, kSmall})});
  EXPECT_TRUE(holds(yes, "10a", "S4"));
  EXPECT_TRUE(holds(yes, "10a", "mean"));
  EXPECT_NE(verdictOf(yes, "10a", "S4").numbers.find("0.700, 0.550, 0.350 N"), std::string::npos);
  const auto no = modelOf({byInput("S4", "lubrication", {"poor", "medium", "well"}, {kSmall, kMedium, kLarge})});
  EXPECT_FALSE(holds(no, "10a", "S4"));
  EXPECT_FALSE(holds(no, "10a", "mean"));
}

TEST(Claims, AForceThatDoesNotMoveIsNoConfirmation) {
  const auto flat = modelOf({byRegion("S4", {kSmall, kSmall, kSmall, kSmall, kSmall, kSmall})});
  for (const char* id : {"10a", "10b", "10c", "11a", "11b"}) EXPECT_FALSE(holds(flat, id, "S4")) << id;
}

TEST(Claims, NeckFlexionLowersTheForceOrNot) {
  const auto yes = modelOf({byInput("S4", "neck_flexion", {"small", "medium", "large"}, {kLarge, kMedium, kSmall})});
  EXPECT_TRUE(holds(yes, "10b", "S4"));
  const auto no = modelOf({byInput("S4", "neck_flexion", {"small", "medium", "large"}, {kSmall, kMedium, kMedium})});
  EXPECT_FALSE(holds(no, "10b", "S4"));
  // The rules themselves are named, in the words of the model.
  EXPECT_NE(verdictOf(no, "10b", "S4").reason.find("esophagus (small: small, medium: medium)"), std::string::npos);
}

TEST(Claims, SpeedRaisesTheForceOrNot) {
  EXPECT_TRUE(
      holds(modelOf({byInput("S4", "speed", {"slow", "medium", "fast"}, {kSmall, kMedium, kLarge})}), "10c", "S4"));
  EXPECT_FALSE(
      holds(modelOf({byInput("S4", "speed", {"slow", "medium", "fast"}, {kLarge, kMedium, kSmall})}), "10c", "S4"));
}

TEST(Claims, TheMeanSaysWhoGoesAgainstIt) {
  const auto model = modelOf({byInput("S1", "speed", {"slow", "medium", "fast"}, {kMedium, kMedium, kMedium}),
                              byInput("S4", "speed", {"slow", "medium", "fast"}, {kLarge, kMedium, kSmall})});
  const Verdict mean = verdictOf(model, "10c", "mean");
  ASSERT_TRUE(mean.holds);
  EXPECT_FALSE(*mean.holds);
  EXPECT_EQ(mean.reason, "Against it: S4 (0.350 N on average).");
}

TEST(Claims, TheRulesOfS4ContradictTheTextOnNeckFlexion) {
  // Table A2: a large flexion makes the force Large in the laryngopharynx, a small one Medium.
  const Verdict verdict = verdictOf(support::s4AsPrinted(), "10b", "S4");
  ASSERT_TRUE(verdict.holds);
  EXPECT_FALSE(*verdict.holds);
  EXPECT_EQ(verdict.basis, ClaimBasis::kPublishedRules);
  EXPECT_NE(verdict.reason.find("laryngopharynx"), std::string::npos);
}

TEST(Claims, AShoulderFromZeroCannotRiseInTheNasalCavity) {
  const auto model = modelOf({byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kMedium, kMedium})});
  const Verdict verdict = verdictOf(model, "11a", "S4");
  ASSERT_TRUE(verdict.holds);
  EXPECT_FALSE(*verdict.holds);
  EXPECT_NE(verdict.reason.find("shoulder: 1 from 0 mm to 60 mm"), std::string::npos);
}

TEST(Claims, AVestibuleWithLessForceMakesTheNasalBump) {
  ForceModel model = modelOf({byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kMedium, kMedium})});
  auto& terms = model.inputs[2].terms;
  terms[0].points = {20, 30, 60, 80};
  terms.insert(terms.begin(), {"vestibule", "Vestibule", fuzzy::Shape::kTrapezoid, {0, 0, 20, 30}});
  model.experts[0].rules.push_back({{{"depth", "vestibule"}}, kSmall});
  EXPECT_TRUE(holds(model, "11a", "S4"));
  EXPECT_TRUE(holds(model, "11a", "mean"));
}

TEST(Claims, PeakInTheOropharynxOrElsewhere) {
  EXPECT_TRUE(holds(modelOf({byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kMedium, kMedium})}), "11b", "S4"));
  EXPECT_FALSE(holds(modelOf({byRegion("S4", {kMedium, kSmall, kMedium, kLarge, kMedium, kMedium})}), "11b", "S4"));
}

TEST(Claims, AnExpertWithoutTheOropharynxIsSaidToBe) {
  // The published reading without that region peaks at 200 mm, with 0.58944 N.
  const Verdict verdict = verdictOf(support::s4FiveRegions(), "11b", "S4");
  ASSERT_TRUE(verdict.holds);
  EXPECT_FALSE(*verdict.holds);
  EXPECT_NE(verdict.numbers.find("0.589 N at 200 mm"), std::string::npos);
  EXPECT_EQ(verdict.reason, "No rule of this expert is about the oropharynx.");
}

TEST(Claims, TheHighestPeakIsThatOfS2OrNot) {
  const auto high = [](const char* id) {
    return byRegion(id, {kMedium, kSmall, "very_large", kMedium, kMedium, kMedium});
  };
  const auto low = [](const char* id) { return byRegion(id, {kMedium, kSmall, kLarge, kMedium, kMedium, kMedium}); };
  EXPECT_TRUE(holds(modelOf({low("S1"), high("S2"), low("S4")}), "11c", "all experts"));
  EXPECT_FALSE(holds(modelOf({high("S1"), low("S2"), low("S4")}), "11c", "all experts"));
  EXPECT_FALSE(holds(modelOf({high("S1"), high("S2"), low("S4")}), "11c", "all experts"));
  EXPECT_FALSE(verdictOf(modelOf({low("S4")}), "11c", "all experts").holds);
}

TEST(Claims, CloseInTheEsophagusMeansTooCloseToFeel) {
  const auto near = modelOf({byRegion("S1", {kSmall, kSmall, kLarge, kMedium, kMedium, kMedium}),
                             byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kMedium, kSmall})});
  EXPECT_TRUE(holds(near, "11d", "all experts"));
  // .7 against .35 N, where .08 N can be felt.
  const auto far = modelOf({byRegion("S1", {kSmall, kSmall, kLarge, kMedium, kLarge, kMedium}),
                            byRegion("S2", {kSmall, kSmall, kLarge, kMedium, kLarge, kMedium}),
                            byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kSmall, kSmall})});
  EXPECT_FALSE(holds(far, "11d", "all experts"));
  EXPECT_NE(verdictOf(far, "11d", "all experts").reason.find("S4 contradicts it"), std::string::npos);
}

TEST(Claims, SimilarProfilesRiseAndFallTogether) {
  const std::array<const char*, 6> up = {kSmall, kMedium, kLarge, kMedium, kMedium, kSmall};
  const std::array<const char*, 6> down = {kLarge, kMedium, kSmall, kMedium, kMedium, kLarge};
  EXPECT_TRUE(holds(modelOf({byRegion("S1", up), byRegion("S4", up)}), "11e", "all experts"));
  EXPECT_FALSE(holds(modelOf({byRegion("S1", up), byRegion("S4", down)}), "11e", "all experts"));
}

TEST(Claims, TheMeanIsTheWeightedMeanOfTheExperts) {
  auto model = modelOf({byRegion("S1", {kSmall, kMedium, kLarge, kMedium, kMedium, kSmall}),
                        byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kSmall, kSmall})});
  model.experts[0].weight = 3;
  EXPECT_TRUE(holds(model, "11f", "mean"));
}

TEST(Claims, ExpertsAreMarkedByWhereTheirRulesComeFrom) {
  const auto model = modelOf({byRegion("S1", {kSmall, kMedium, kLarge, kMedium, kMedium, kSmall}),
                              byRegion("S4", {kMedium, kSmall, kLarge, kMedium, kSmall, kSmall})});
  EXPECT_EQ(verdictOf(model, "11b", "S1").basis, ClaimBasis::kSimulated);
  EXPECT_EQ(verdictOf(model, "11b", "S4").basis, ClaimBasis::kPublishedRules);
  EXPECT_EQ(verdictOf(model, "11b", "mean").basis, ClaimBasis::kByConstruction);
}

TEST(Claims, AModelWithoutThePublishedExpertIsRefused) {
  const auto claims = checkClaims(modelOf({byRegion("S1", {kSmall, kSmall, kSmall, kSmall, kSmall, kSmall})}), {});
  ASSERT_FALSE(claims);
  EXPECT_NE(claims.error().message().find("S4"), std::string::npos);
}

TEST(Claims, AModelWithOtherInputsIsRefused) {
  ForceModel model = modelOf({byRegion("S4", {kSmall, kSmall, kSmall, kSmall, kSmall, kSmall})});
  model.inputs[1].id = "angle";
  const auto claims = checkClaims(model, {});
  ASSERT_FALSE(claims);
  EXPECT_NE(claims.error().message().find("neck_flexion"), std::string::npos);
}

TEST(Claims, TheOrderOfTheInputsDoesNotMatter) {
  ForceModel model = support::s4FiveRegions();
  const std::string numbers = verdictOf(model, "11b", "S4").numbers;
  std::swap(model.inputs[0], model.inputs[3]);
  EXPECT_EQ(verdictOf(model, "11b", "S4").numbers, numbers);
}

TEST(Claims, JustNoticeableDifferenceJoinsThresholdAndWeberFraction) {
  EXPECT_DOUBLE_EQ(justNoticeableDifference(0), 0.04);
  EXPECT_NEAR(justNoticeableDifference(0.25), 0.05, 1e-15);  // sides 0.04 and 0.03; rounding only
}

}  // namespace
}  // namespace tactus::report
