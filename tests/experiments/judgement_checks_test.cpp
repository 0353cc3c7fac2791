#include "experiments/judgement_checks.h"

#include <gtest/gtest.h>

#include "experiments/force_series.h"

#include "tests/experiments/record_maker.h"

namespace tactus::experiments {
namespace {

using Kind = study::ForceJudgement::Kind;

const std::vector<std::string> kTerms = {"very_small", "small", "medium", "large", "very_large"};

class Session {
 public:
  study::JudgementRecord& add(const std::string& series, double force_n, std::size_t term) {
    auto& record = add(series, force_n, Kind::kTerm);
    record.term = kTerms[term];
    return record;
  }
  study::JudgementRecord& add(const std::string& series, double force_n, Kind kind) {
    study::JudgementRecord record;
    record.entry.id = idOf(records_.size() + 1);
    record.series = series;
    record.commanded_n = force_n;
    record.kind = kind;
    record.forward_speed_mm_s = 40;
    record.response_s = 2;
    records_.push_back(record);
    return records_.back();
  }
  JudgementChecks check() const { return checkJudgements(records_, kTerms); }
  const JudgementFinding& finding(const JudgementChecks& checks, const std::string& check) const {
    for (const auto& finding : checks.findings) {
      if (finding.check == check) return finding;
    }
    ADD_FAILURE() << "no finding " << check;
    return checks.findings.front();
  }

 private:
  std::vector<study::JudgementRecord> records_;
};

TEST(JudgementChecks, CountsPairsWhoseTermFalls) {
  Session session;
  const std::size_t terms[] = {0, 2, 1, 1, 3};  // 0.2 N above 0.3 N and 0.4 N: two of ten pairs
  for (std::size_t i = 0; i < 5; ++i) session.add(kAscending, static_cast<double>(i + 1) / 10, terms[i]);
  session.add(kAscending, 0.6, Kind::kBeyondPractice);
  session.add(kAscending, 0.05, Kind::kNotFelt);
  session.add(kAscending, 0.7, 0).scored = false;
  const auto checks = session.check();
  ASSERT_EQ(checks.monotonicity.size(), 1U);
  EXPECT_EQ(checks.monotonicity[0].pairs, 10U);
  EXPECT_EQ(checks.monotonicity[0].violations, 2U);
  const auto& finding = session.finding(checks, "monotonicity");
  EXPECT_TRUE(finding.notable);
  EXPECT_EQ(finding.sentence,
            "In the ascending series the term falls though the force rises in 2 of 10 pairs of forces.");
}

TEST(JudgementChecks, HysteresisIsTheMeanDifferenceUpMinusDown) {
  Session session;
  for (int i = 1; i <= 4; ++i) session.add(kAscending, i / 10.0, static_cast<std::size_t>(i));
  for (int i = 4; i >= 2; --i) session.add(kDescending, i / 10.0, static_cast<std::size_t>(i == 3 ? 3 : i - 1));
  const auto checks = session.check();
  EXPECT_EQ(checks.hysteresis.forces, 3U);
  EXPECT_DOUBLE_EQ(checks.hysteresis.index.value(), 2.0 / 3);  // 1, 0, 1
  EXPECT_TRUE(session.finding(checks, "hysteresis").notable);
  EXPECT_EQ(session.finding(checks, "hysteresis").sentence,
            "On the way up forces were called 0.67 terms higher than on the way down, as the mean of 3 forces.");
}

TEST(JudgementChecks, RepeatsAndHiddenRepeats) {
  Session session;
  session.add(kRandom, 0.2, std::size_t{0});
  session.add(kRandom, 0.5, 2);
  session.add(kRandom, 0.2, 1);
  session.add(kRandom, 0.5, 2);
  session.add(kRandom, 0.2, 2).catch_trial = true;
  const auto checks = session.check();
  // 0.2 N: (0,1) (0,2) (1,2); 0.5 N: (2,2)
  EXPECT_EQ(checks.repeats.pairs, 4U);
  EXPECT_DOUBLE_EQ(checks.repeats.within_one.value(), 0.75);
  EXPECT_EQ(checks.repeats.hidden_pairs, 2U);
  EXPECT_EQ(checks.repeats.hidden_same, 0);
  // Squares 1 4 1 0 = 6. Chance: firsts 0 0 1 2 against seconds 1 2 2 2: 13 + 13 + 3 + 1 = 30. 1 - 6 * 4 / 30
  EXPECT_DOUBLE_EQ(checks.repeats.kappa.value(), 0.2);
  EXPECT_TRUE(session.finding(checks, "repeats").notable);
}

TEST(JudgementChecks, FalseAlarmsOnBlanks) {
  Session session;
  session.add(kRandom, 0, Kind::kNotFelt).catch_trial = true;
  session.add(kRandom, 0, std::size_t{0}).catch_trial = true;
  session.add(kRandom, 0, Kind::kNotFelt).catch_trial = true;
  session.add(kRandom, 0.5, 2);
  const auto checks = session.check();
  EXPECT_EQ(checks.blanks.blanks, 3U);
  EXPECT_EQ(checks.blanks.false_alarms, 1U);
  EXPECT_FALSE(session.finding(checks, "blanks").notable);
  EXPECT_EQ(checks.repeats.pairs, 0U);                         // a blank is no force that comes again
  EXPECT_FALSE(checks.thresholds.threshold_n[0].has_value());  // nor one that has a term
}

TEST(JudgementChecks, ResponseTimesAndSpeedsAreDescribed) {
  Session session;
  const double times_s[] = {1, 2, 2, 2, 2.5, 2, 2, 2, 20};
  for (int i = 0; i < 9; ++i) {
    auto& record = session.add(kAscending, (i + 1) / 10.0, 2);
    record.response_s = times_s[i];
    record.forward_speed_mm_s = 30 + i;
  }
  session.add(kAscending, 1.0, 3).scored = false;
  session.add(kFamiliarisation, 0.6, Kind::kNoAnswer).scored = false;
  const auto checks = session.check();
  EXPECT_EQ(checks.response_time.judgements, 9U);
  EXPECT_EQ(checks.response_time.median_s, 2);
  // Both quartiles are 2 s: all others lie outside.
  EXPECT_EQ(checks.response_time.outliers, (std::vector<std::size_t>{0, 4, 8}));
  EXPECT_EQ(checks.motion.judgements, 9U);
  EXPECT_EQ(checks.motion.median_mm_s, 34);
  EXPECT_EQ(checks.motion.slowest_mm_s, 30);
  EXPECT_EQ(checks.motion.fastest_mm_s, 38);
  EXPECT_EQ(checks.motion.repeated, 1U);
}

TEST(JudgementChecks, AStepThatWasNeverScoredIsNamed) {
  Session session;
  const auto attempt = [&](int step, bool scored) {
    auto& record = session.add(kAscending, step / 10.0, 2);
    record.step = step;
    record.scored = scored;
  };
  attempt(1, true);
  attempt(2, false);
  attempt(2, false);
  attempt(3, false);
  attempt(3, true);
  attempt(4, false);  // the session ends here, and may go on
  const auto checks = session.check();
  EXPECT_EQ(checks.motion.left_out, 1U);
  const auto finding = session.finding(checks, "motion");
  EXPECT_TRUE(finding.notable);
  EXPECT_NE(finding.sentence.find("1 step was left out"), std::string::npos) << finding.sentence;
}

TEST(JudgementChecks, CorrectedRecordsAreLeftOut) {
  Session session;
  session.add(kAscending, 0.1, 4);
  session.add(kAscending, 0.2, 1);
  session.add(kAscending, 0.1, std::size_t{0}).entry.supersedes = idOf(1);
  const auto checks = session.check();
  EXPECT_EQ(checks.monotonicity[0].pairs, 1U);
  EXPECT_EQ(checks.monotonicity[0].violations, 0U);
  EXPECT_DOUBLE_EQ(checks.thresholds.threshold_n[0].value(), 0.15);
  EXPECT_EQ(session.finding(checks, "thresholds").sentence,
            "The terms change at 0.15, ?, ?, ? N (midpoints between neighboring forces).");
}

TEST(JudgementChecks, NothingIsSaidOfNothing) {
  const auto checks = checkJudgements({}, kTerms);
  EXPECT_TRUE(checks.findings.empty());
  EXPECT_TRUE(checks.monotonicity.empty());
  EXPECT_FALSE(checks.hysteresis.index.has_value());
}

}  // namespace
}  // namespace tactus::experiments
