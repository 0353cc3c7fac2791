// Four participants with the judgements that Table 2 splits into, paired with the rules of three invented experts and
// S4. Reference figures: another program in exact rational arithmetic, to six digits.
#include "elicitation/uncertainty/own_words.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/uncertainty/force_bands.h"

#include "tests/elicitation/four_people.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

const std::vector<std::vector<double>> kReferencePoints = {
    {1, 60, 70, 50}, {1, 60, 200, 50}, {1, 60, 300, 50}, {.3, 45, 170, 80}};  // B, A, E, C
constexpr double kSixDigits = 5.1e-7;  // half of the last digit printed, and rounding

study::Study withRulesOf(const std::string& expert) {
  auto study = fourPeople();
  std::erase_if(study.rules, [&](const auto& rule) { return rule.participant != expert; });
  return study;
}

BuiltModel builtFrom(const study::Study& study, const BuildSettings& settings = {}) {
  auto built = buildModel(study, {}, settings);
  EXPECT_TRUE(built) << built.error().message();
  return std::move(*built);
}

ForceBands wordBands(const study::Study& study, const BuiltModel& built) {
  auto bands = ForceBands::of(study, built, {}, {.points = kReferencePoints, .again = false, .others = false});
  EXPECT_TRUE(bands) << bands.error().message();
  EXPECT_EQ(bands->planned(), 0U) << "own words need no draws";
  return std::move(*bands);
}

void expectForces(const ForceBands& bands, const std::vector<std::vector<double>>& wanted) {
  const auto& forces = bands.underOwnWords();
  ASSERT_EQ(forces.size(), wanted.size());
  for (std::size_t who = 0; who < wanted.size(); ++who) {
    for (std::size_t p = 0; p < kReferencePoints.size(); ++p) {
      ASSERT_TRUE(forces[who][p]);
      EXPECT_NEAR(*forces[who][p], wanted[who][p], kSixDigits) << who << ' ' << p;
    }
  }
}

TEST(OwnWords, OfOneExpertGiveTheReferenceForces) {
  const auto study = withRulesOf("S4");
  const auto built = builtFrom(study);
  const auto bands = wordBands(study, built);
  expectForces(bands, {{.137879, .469343, .395741, .536945},
                       {.237719, .530397, .461275, .576731},
                       {.337654, .589444, .511790, .640855},
                       {.437619, .663730, .627621, .687930}});
  const auto band = bands.band(BandKind::kWords);
  ASSERT_EQ(band.points.size(), kReferencePoints.size());
  EXPECT_NEAR(band.points[1].low_n, .469343, kSixDigits);
  EXPECT_NEAR(band.points[1].high_n, .663730, kSixDigits);
  EXPECT_NEAR(*band.points[1].force_n, .589444, kSixDigits) << "under the voted words";
  EXPECT_EQ(band.points[1].abstains, 0);
}

TEST(OwnWords, OfAllExpertsGiveTheReferenceForces) {
  const auto study = fourPeople();
  expectForces(wordBands(study, builtFrom(study)), {{.125433, .261250, .210972, .491218},
                                                    {.212759, .445099, .355091, .582594},
                                                    {.312671, .584861, .490448, .710900},
                                                    {.387644, .678433, .623353, .745271}});
}

TEST(OwnWords, AWordThatWasNeverUsedDoesNotExist) {
  const auto study = fourPeople();
  const auto built = builtFrom(study);
  const auto words = ownWords(study, built, {});
  ASSERT_EQ(words.size(), 4U);
  EXPECT_EQ(words[0].missing, std::vector<std::string>{"very_small"});
  ASSERT_EQ(words[0].terms.size(), 4U);
  EXPECT_EQ(words[0].terms[0].points, (std::vector<double>{0, 0, .1, .2})) << "small reaches down to 0";
  EXPECT_EQ(words[0].terms[3].points, (std::vector<double>{.3, .4, 1.1, 1.1}));
  EXPECT_TRUE(words[3].missing.empty());
  const auto notes = missingWordNotes(words, built.model.output);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("Very small"), std::string::npos);
  EXPECT_NE(notes[0].find("E1"), std::string::npos);
  // All rules of S4 that fire here say very small: E1's words have no force for them.
  const auto under = underWords(builtFrom(withRulesOf("S4")).model, words[0]);
  ASSERT_TRUE(under);
  EXPECT_FALSE(fuzzy::compile(*under)->evaluate(std::vector<double>{1, 20, 20, 50}).fired);
  const auto band = wordBands(study, built).band(BandKind::kWords);
  EXPECT_EQ(band.not_included, notes);
}

TEST(OwnWords, ByEveryWayOfTheModel) {
  const auto study = fourPeople();
  for (const auto from : {ForceTermsFrom::kFrequency, ForceTermsFrom::kThresholds, ForceTermsFrom::kProbit}) {
    BuildSettings settings;
    settings.force_terms = from;
    const auto built = builtFrom(study, settings);
    for (const auto& one : ownWords(study, built, settings)) {
      EXPECT_EQ(one.terms.size(), one.participant == "E1" ? 4U : 5U) << name(from) << ' ' << one.participant;
      for (const auto& term : one.terms) EXPECT_LE(term.points.back(), built.model.output.max);
    }
  }
}

// Whatever people answer, in any order: the words are a model that can be evaluated, and say what is missing.
TEST(OwnWords, OfAnyAnswersMakeAModel) {
  base::Random random(5);
  const auto all = support::ngtOutput().terms;
  for (int round = 0; round < 40; ++round) {
    auto study = fourPeople();
    for (auto& one : study.judgements) {
      const int answer = random.below(8);
      if (answer >= 5) one.kind = static_cast<study::ForceJudgement::Kind>(1 + answer - 5);
      one.term = answer < 5 ? all[static_cast<std::size_t>(answer)].id : std::string();
    }
    BuildSettings settings;
    settings.force_terms = static_cast<ForceTermsFrom>(round % 4);
    const auto built = buildModel(study, {}, settings);
    if (!built) continue;  // no room for a word of the rules
    for (const auto& own : ownWords(study, *built, settings)) {
      EXPECT_EQ(own.terms.size() + own.missing.size(), built->model.output.terms.size());
      const auto under = underWords(built->model, own);
      if (!under) continue;
      const auto compiled = fuzzy::compile(*under);
      ASSERT_TRUE(compiled) << compiled.error().message();
      const auto force = compiled->evaluate(kReferencePoints[1]);
      EXPECT_LE(force.fired ? force.force_n : 0, built->model.output.max);
    }
  }
}

TEST(OwnWords, ThereAreNoneWithoutJudgements) {
  auto study = fourPeople();
  std::erase_if(study.judgements, [](const auto& one) { return one.participant == "E2"; });
  const auto words = ownWords(study, builtFrom(study), {});
  EXPECT_TRUE(words[1].terms.empty());
  EXPECT_FALSE(underWords(builtFrom(study).model, words[1]));
  EXPECT_EQ(missingWordNotes(words, support::ngtOutput()).size(), 2U);
  study.judgements.clear();
  const auto built = builtFrom(study);
  EXPECT_TRUE(ownWords(study, built, {}).empty());
  EXPECT_TRUE(wordBands(study, built).band(BandKind::kWords).points.empty());
  const auto compared = wordsAndRules(study, built, {});
  ASSERT_TRUE(compared);
  EXPECT_TRUE(compared->participants.empty());
  EXPECT_NE(wordsAndRulesSentence(*compared).find("nothing to compare"), std::string::npos);
}

TEST(WordsAndRules, GiveTheReferenceDeviationsAtAPoint) {
  const auto study = fourPeople();
  const auto built = builtFrom(study);
  // Own rules under the voted words; own words with the averaged rules; both.
  const std::vector<double> rules_n = {.049968, .072201, .055963, .082759};
  const std::vector<double> words_n = {.114610, .181498, .177220, .117353};
  const std::vector<double> both_n = {.125731, .234889, .210050, .234599};
  for (std::size_t p = 0; p < kReferencePoints.size(); ++p) {
    WordsAndRulesSettings how;
    how.points = {kReferencePoints[p]};
    const auto found = wordsAndRules(study, built, {}, how);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_EQ(found->participants.size(), 4U);
    EXPECT_EQ(found->points, 1U);
    EXPECT_NEAR(found->rules.sd_n, rules_n[p], kSixDigits) << p;
    EXPECT_NEAR(found->words.sd_n, words_n[p], kSixDigits) << p;
    EXPECT_NEAR(found->both.sd_n, both_n[p], kSixDigits) << p;
  }
  WordsAndRulesSettings at;
  at.points = {kReferencePoints[1]};
  EXPECT_NEAR(wordsAndRules(study, built, {}, at)->both.largest_n, .663730 - .137879, 2 * kSixDigits);
}

TEST(WordsAndRules, MeanSquareOverThePointsAndNothingWherePeopleAgree) {
  const auto study = fourPeople();
  const auto built = builtFrom(study);
  WordsAndRulesSettings how;
  how.points = kReferencePoints;
  const auto all = wordsAndRules(study, built, {}, how).value();
  double squares = 0;
  for (const double sd_n : {.114610, .181498, .177220, .117353}) squares += sd_n * sd_n;
  EXPECT_NEAR(all.words.sd_n, std::sqrt(squares / 4), 2 * kSixDigits);

  // All judge alike: no disagreement of words, and that of both is that of the rules.
  auto alike = study;
  for (auto& one : alike.judgements) {
    one.term = std::find_if(study.judgements.begin(), study.judgements.end(), [&](const auto& first) {
                 return first.participant == "S4" && first.step == one.step;
               })->term;
  }
  const auto same_words = wordsAndRules(alike, builtFrom(alike), {}).value();
  EXPECT_NEAR(same_words.words.sd_n, 0, 1e-12);
  EXPECT_NEAR(same_words.both.sd_n, same_words.rules.sd_n, 1e-12);
  EXPECT_GT(same_words.rules.sd_n, .05);
  EXPECT_EQ(same_words.points, same_words.tried);
}

TEST(WordsAndRules, LeavesOutThoseWithoutRulesAndStops) {
  const auto study = withRulesOf("S4");
  const auto found = wordsAndRules(study, builtFrom(study), {}).value();
  EXPECT_EQ(found.participants, std::vector<std::string>{"S4"});
  EXPECT_EQ(found.notes.size(), 4U) << "E1 lacks a word, and three have no rules";
  const auto four = fourPeople();
  std::stop_source stop;
  stop.request_stop();
  WordsAndRulesSettings how;
  how.stop = stop.get_token();
  const auto stopped = wordsAndRules(four, builtFrom(four), {}, how);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
}

}  // namespace
}  // namespace tactus::elicitation
