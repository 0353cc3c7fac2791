#include <cmath>
#include <gtest/gtest.h>

#include "elicitation/speed/participant_speeds.h"
#include "elicitation/speed/speed_terms.h"

#include "tests/elicitation/golden_speeds.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

LevelSpeeds level(const char* name, std::size_t samples, double mean, double sd, std::vector<double> strokes = {}) {
  return {name, samples, mean, sd, std::move(strokes)};
}

TEST(LevelSpeeds, SeparationOfTable1ByHand) {
  // Table 1, equal numbers: |168.9 - 180.3| / sqrt((61.6^2 + 92.4^2) / 2) = 11.4 / 78.52.
  EXPECT_NEAR(*separation(level("medium", 2000, 168.9, 61.6), level("fast", 2000, 180.3, 92.4)), 0.1452, 5e-5);
  // S4, slow and fast: 13.3 / sqrt((8.9^2 + 18.7^2) / 2) = 13.3 / 14.644.
  EXPECT_NEAR(*separation(level("slow", 50, 31.1, 8.9), level("fast", 50, 44.4, 18.7)), 0.9082, 5e-5);
  // Unequal: pooled variance (2 * 4 + 1 * 16) / 3 = 8.
  EXPECT_DOUBLE_EQ(*separation(level("slow", 3, 10, 2), level("fast", 2, 14, 4)), 4 / std::sqrt(8.0));
}

TEST(LevelSpeeds, SeparationIsAbsentWhereNothingVaries) {
  EXPECT_FALSE(separation(level("slow", 3, 10, 0), level("fast", 2, 14, 0)));
  EXPECT_FALSE(separation(level("slow", 0, 0, 0), level("fast", 2, 14, 1)));
  EXPECT_FALSE(separation(level("slow", 1, 10, 0), level("fast", 1, 14, 0)));
}

TEST(LevelSpeeds, StrokesAreKeptApart) {
  const auto sample = [](const char* name, int stroke, double speed) {
    return study::SpeedSample{"S1", name, stroke, 0, 0, speed};
  };
  const std::vector<study::SpeedSample> samples{sample("slow", 2, 10), sample("fast", 2, 50), sample("slow", 1, 30),
                                                sample("slow", 2, 20), sample("other", 1, 7)};
  const auto found = levelSpeeds(samples, goldenLevels());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].samples, 3U);
  EXPECT_EQ(found[0].mean_mm_s, 20);
  EXPECT_EQ(found[0].sd_mm_s, 10);
  EXPECT_EQ(found[0].stroke_means_mm_s, (std::vector<double>{15, 30}));
  EXPECT_EQ(found[1].samples, 0U);
  EXPECT_EQ(found[2].stroke_means_mm_s, std::vector<double>{50});
}

TEST(LevelDiagnostics, EqualTheReference) {
  for (const auto& wanted : goldenSpeeds("subjects")) {
    const auto file = wanted.at("file").get<std::string>();
    const auto found =
        levelDiagnostics(goldenStrokes(file), goldenLevels(), wanted.at("centres").get<std::vector<double>>(), "S");
    for (std::size_t k = 0; k < 3; ++k) {
      // Sums of 24,000 speeds of a few hundred, in another order.
      EXPECT_NEAR(found.levels[k].mean_mm_s, wanted.at("level_means")[k].get<double>(), 1e-9);
      EXPECT_NEAR(found.levels[k].sd_mm_s, wanted.at("level_sds")[k].get<double>(), 1e-9);
      EXPECT_EQ(found.confusion.counts[k], wanted.at("confusion").at("counts")[k].get<std::vector<std::size_t>>());
    }
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(found.separations[k].value(), wanted.at("separations")[k].get<double>(), 1e-11);
    }
    EXPECT_NEAR(found.confusion.adjusted_rand_index, wanted.at("confusion").at("adjusted_rand_index").get<double>(),
                1e-12);
    EXPECT_DOUBLE_EQ(found.confusion.accuracy, wanted.at("confusion").at("accuracy").get<double>());
    EXPECT_EQ(found.trend->j, wanted.at("trend").at("j").get<double>());
    EXPECT_DOUBLE_EQ(found.trend->p, wanted.at("trend").at("p").get<double>());
  }
}

TEST(LevelDiagnostics, AParticipantWhoKeepsTheLevelsApartIsNotWarnedOf) {
  const auto reference = goldenSubject("S1_24k.csv");
  const auto found = levelDiagnostics(goldenStrokes("S1_24k.csv"), goldenLevels(),
                                      reference.at("centres").get<std::vector<double>>(), "S1");
  EXPECT_TRUE(found.warnings.empty());
}

TEST(LevelDiagnostics, EveryWarningNamesTheParticipantAndTheNumbers) {
  // reference.json: index .2288, accuracy .4067, d' .594 and .389, center 9.50 at a level of 31.10 ± 8.90.
  const auto reference = goldenSubject("S4_600.csv");
  const auto found = levelDiagnostics(goldenStrokes("S4_600.csv"), goldenLevels(),
                                      reference.at("centres").get<std::vector<double>>(), "S4");
  ASSERT_EQ(found.warnings.size(), 4U);
  for (const auto& warning : found.warnings) EXPECT_EQ(warning.find("Participant S4: "), 0U) << warning;
  EXPECT_NE(found.warnings[0].find("adjusted Rand index 0.23, below 0.3; accuracy 0.41, below 0.6"), std::string::npos);
  EXPECT_NE(found.warnings[1].find("slow and medium are hardly apart (d' 0.59"), std::string::npos);
  EXPECT_NE(found.warnings[2].find("medium and fast are hardly apart (d' 0.39"), std::string::npos);
  EXPECT_NE(found.warnings[3].find("slow, 9.5 mm/s, lies outside the mean ± SD of that level, 31.1 ± 8.9 mm/s"),
            std::string::npos);
}

TEST(LevelDiagnostics, StrokesThatDoNotRiseAreSaidOnlyWhereTheyCouldShowIt) {
  std::vector<study::SpeedSample> samples;
  for (int stroke = 1; stroke <= 4; ++stroke) {
    for (const auto& [name, speed] : {std::pair{"slow", 30.0}, {"medium", 20.0}, {"fast", 10.0}}) {
      for (const double offset : {-1.0, 1.0}) {
        samples.push_back({"S9", name, stroke, 0, 0, speed + offset + 0.1 * stroke});
      }
    }
  }
  const std::vector<double> centres{10.25, 20.25, 30.25};
  const auto four = levelDiagnostics(samples, goldenLevels(), centres, "S9");
  EXPECT_NE(four.warnings.back().find("J 0 of 48, p 1.00"), std::string::npos) << four.warnings.back();
  // One stroke per level: the best order has p = 1/6, so nothing can be said.
  std::erase_if(samples, [](const study::SpeedSample& sample) { return sample.stroke > 1; });
  const auto one = levelDiagnostics(samples, goldenLevels(), centres, "S9");
  EXPECT_DOUBLE_EQ(one.trend->least_p, 1.0 / 6);
  for (const auto& warning : one.warnings) EXPECT_EQ(warning.find("Jonckheere"), std::string::npos);
}

TEST(LevelDiagnostics, LevelsThatReadAsOneTermAreSaid) {
  fuzzy::Variable averaged = support::ngtInputs()[3];
  averaged.terms = speedTerms(averaged, std::vector<Ramp>{{51.5, 102}, {126.6, 187}});
  fuzzy::Variable own = averaged;
  own.terms = speedTerms(own, std::vector<Ramp>{{32, 34}, {40, 43}});
  EXPECT_EQ(termAt(averaged, 76), 0U);
  EXPECT_EQ(termAt(averaged, 77), 1U);
  EXPECT_EQ(termAt(averaged, 1000), 2U);  // clamped to the universe
  EXPECT_EQ(termAt(averaged, -3), 0U);

  const std::vector<LevelSpeeds> s4{level("slow", 9, 31.1, 8.9), level("medium", 9, 38, 13.8),
                                    level("fast", 9, 44.4, 18.7)};
  const auto note = sameTermNote(s4, averaged, own, "S4");
  ASSERT_TRUE(note);
  EXPECT_NE(note->find("S4"), std::string::npos);
  EXPECT_NE(note->find("slow 31.1, medium 38.0, fast 44.4 mm/s) read as slow;"), std::string::npos) << *note;
  EXPECT_NE(note->find("they read as slow, medium, fast."), std::string::npos) << *note;

  const std::vector<LevelSpeeds> s3{level("slow", 9, 57.9, 18.1), level("medium", 9, 106, 25),
                                    level("fast", 9, 170.7, 55)};
  EXPECT_FALSE(sameTermNote(s3, averaged, own, "S3"));
  EXPECT_FALSE(sameTermNote(std::vector<LevelSpeeds>{s4[0], level("fast", 0, 0, 0)}, averaged, own, "S4"));
}

}  // namespace
}  // namespace tactus::elicitation
