#include "experiments/duel_run.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <vector>

#include "tests/experiments/record_maker.h"

namespace tactus::experiments {
namespace {

using study::DuelAnswer;
using study::DuelChoice;
using study::DuelRule;
using study::DuelStart;
using study::DuelTrialKind;
using Outcome = DuelVerdict::Outcome;
using Stage = DuelRun::Stage;

DuelStart planned(int trials, DuelRule rule = DuelRule::kFixed, std::uint64_t seed = 7) {
  DuelStart start;
  start.entry.id = idOf(1);
  start.a.name = "before";
  start.b.name = "after";
  start.from_mm = 150;
  start.to_mm = 210;
  start.speed_mm_s = 60;
  start.trials = trials;
  start.rule = rule;
  start.seed = seed;
  return start;
}

DuelRun runOf(const DuelStart& start) {
  auto run = DuelRun::create(start);
  EXPECT_TRUE(run);
  return *run;
}

DuelStroke good(const DuelStart& start) { return {start.from_mm, start.to_mm, start.speed_mm_s, 1}; }

/// One trial, answered by `choose`, which gets the two forces.
template <class Choose>
void answerTrial(DuelRun& run, Choose choose) {
  const DuelForce first = run.felt();
  ASSERT_FALSE(run.stroke(good(run.start())));
  const DuelForce second = run.felt();
  ASSERT_FALSE(run.stroke(good(run.start())));
  run.answer(choose(first, second), 1);
}

TEST(DuelPlan, OrdersAndCatchTrials) {
  for (int trials = 1; trials <= 120; ++trials) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto plan = duelTrials(trials, seed);
      EXPECT_EQ(plan, duelTrials(trials, seed));
      int second_first = 0;
      int pairs = 0;
      int run = 0;
      bool last = false;
      for (std::size_t i = 0; i < plan.size(); ++i) {
        if (plan[i].kind != DuelTrialKind::kPair) {
          ASSERT_GT(i, 0U);
          ASSERT_LT(i + 1, plan.size());
          EXPECT_EQ(plan[i - 1].kind, DuelTrialKind::kPair);
          continue;
        }
        run = pairs > 0 && plan[i].second_first == last ? run + 1 : 1;
        last = plan[i].second_first;
        EXPECT_LE(run, 3);
        ++pairs;
        second_first += last ? 1 : 0;
        EXPECT_TRUE(pairs % 4 != 0 || 2 * second_first == pairs) << "after each block of four";
      }
      EXPECT_EQ(pairs, trials);
      EXPECT_LE(std::abs(2 * second_first - trials), trials % 2);
      const double share = 1 - static_cast<double>(pairs) / static_cast<double>(plan.size());
      if (trials >= 9) {
        EXPECT_GE(share, 0.05) << trials;
        EXPECT_LE(share, 0.1) << trials;
        const auto count = [&](DuelTrialKind kind) {
          return std::count_if(plan.begin(), plan.end(), [&](const DuelTrial& trial) { return trial.kind == kind; });
        };
        EXPECT_LE(count(DuelTrialKind::kLarge) - count(DuelTrialKind::kSame), 1);
        EXPECT_GE(count(DuelTrialKind::kLarge), count(DuelTrialKind::kSame));
      } else {
        EXPECT_EQ(share, 0);
      }
    }
  }
  EXPECT_NE(duelTrials(24, 1), duelTrials(24, 2));
}

TEST(DuelPlan, RefusesWhatCannotBeDone) {
  auto start = planned(10);
  start.trials = 0;
  EXPECT_FALSE(DuelRun::create(start));
  start = planned(10);
  start.to_mm = start.from_mm;
  EXPECT_FALSE(DuelRun::create(start));
  start = planned(10);
  start.speed_mm_s = std::nan("");
  EXPECT_FALSE(DuelRun::create(start));
  start = planned(10);
  start.sought_jnd = 0;
  EXPECT_FALSE(DuelRun::create(start));
}

TEST(DuelRun, BothStrokesThenTheQuestion) {
  auto run = runOf(planned(4));
  const bool b_first = duelTrials(4, 7)[0].second_first;
  EXPECT_EQ(run.stage(), Stage::kFirstStroke);
  EXPECT_EQ(run.felt(), (DuelForce{b_first, 0}));
  EXPECT_FALSE(run.stroke(good(run.start())));
  EXPECT_EQ(run.stage(), Stage::kSecondStroke);
  EXPECT_EQ(run.felt(), (DuelForce{!b_first, 0}));
  EXPECT_FALSE(run.stroke(good(run.start())));
  EXPECT_EQ(run.stage(), Stage::kQuestion);
  const DuelAnswer answer = run.answer(DuelChoice::kSecond, 2.5);
  EXPECT_EQ(answer.duel, idOf(1));
  EXPECT_EQ(answer.trial, 1);
  EXPECT_EQ(answer.second_first, b_first);
  EXPECT_EQ(answer.response_s, 2.5);
  EXPECT_EQ(run.done(), 1);
}

TEST(DuelRun, AStrokeOutsideOfTheBandComesAgainAndCountsForNothing) {
  struct Row {
    DuelStroke stroke;
    DuelRepeat repeat;
  };
  const double edge = 1e-9;
  for (const Row& row :
       {Row{{150, 210, 60 * 0.8 - edge, 1}, DuelRepeat::kTooSlow},
        Row{{150, 210, 60 * 1.2 + edge, 1}, DuelRepeat::kTooFast}, Row{{151, 210, 60, 1}, DuelRepeat::kNotWhole},
        Row{{150, 209, 60, 1}, DuelRepeat::kNotWhole}, Row{{150, 210, 60, 2.1}, DuelRepeat::kPause},
        Row{{150, 210, std::nan(""), 1}, DuelRepeat::kTooSlow}}) {
    auto run = runOf(planned(4));
    const DuelForce first = run.felt();
    EXPECT_FALSE(run.stroke(good(run.start())));
    const auto record = run.stroke(row.stroke);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->repeated, name(row.repeat));
    EXPECT_FALSE(record->choice);
    EXPECT_EQ(run.repeat(), row.repeat);
    EXPECT_EQ(run.stage(), Stage::kFirstStroke);
    EXPECT_EQ(run.felt(), first) << "in the same order";
    answerTrial(run, [](auto, auto) { return DuelChoice::kFirst; });
    EXPECT_EQ(run.answers().back().attempt, 2);
    const auto verdict = verdictOf(run.start(), run.answers());
    EXPECT_EQ(verdict.trials, 1);
    EXPECT_EQ(verdict.repeated, 1);
  }
  // A pause before the first stroke is no pause within a trial.
  auto run = runOf(planned(4));
  EXPECT_FALSE(run.stroke({150, 210, 60, 100}));
}

TEST(DuelRun, RecordsRestoreItAtEachPlace) {
  for (const DuelRule rule : {DuelRule::kFixed, DuelRule::kSequential, DuelRule::kOwnJnd}) {
    const DuelStart start = planned(20, rule);
    const auto answers = simulatedAnswers(start, {1.5, 1, 0.2, 0.1, 0.2}, 3);
    for (std::size_t count = 0; count <= answers.size(); ++count) {
      const auto part = std::span(answers).first(count);
      auto run = DuelRun::create(start, part);
      ASSERT_TRUE(run);
      EXPECT_EQ(std::vector(part.begin(), part.end()), run->answers());
      EXPECT_EQ(run->stage() == Stage::kFinished, count == answers.size());
      EXPECT_EQ(verdictOf(start, part).outcome == Outcome::kUnfinished, count < answers.size());
    }
    // Another order than that of the plan.
    auto wrong = answers;
    wrong[0].second_first = !wrong[0].second_first;
    EXPECT_FALSE(DuelRun::create(start, wrong));
    auto more = answers;
    more.push_back(answers.back());
    EXPECT_FALSE(DuelRun::create(start, more));
  }
}

// The share of runs that find a difference, with a person who feels `difference_jnd`.
double foundShare(const DuelStart& start, const DuelResponder& responder, int runs) {
  int found = 0;
  for (int i = 0; i < runs; ++i) {
    DuelStart one = start;
    one.seed = static_cast<std::uint64_t>(i);
    const auto answers = simulatedAnswers(one, responder, static_cast<std::uint64_t>(1'000'000 + i));
    found += verdictOf(one, answers).outcome == Outcome::kDiffer ? 1 : 0;
  }
  return static_cast<double>(found) / runs;
}

// Exact chances of the plan against 4,000 simulated runs: four standard errors are 0.014 and 0.026.
TEST(DuelRun, SizeAndPowerAreWhatThePlanSays) {
  constexpr int kRuns = 4000;
  for (const int trials : {13, 23, 37}) {
    const BinomialTest test = testOf(trials, shareRight(1));
    const DuelStart start = planned(trials);
    EXPECT_NEAR(foundShare(start, {}, kRuns), test.size, 0.014) << trials;
    EXPECT_NEAR(foundShare(start, {1}, kRuns), test.power, 0.026) << trials;
    // "Can't tell" never adds to the size; an order bias alone is balanced out.
    EXPECT_LE(foundShare(start, {0, 1, 0, 0.3, 0}, kRuns), 0.05 + 0.014) << trials;
    EXPECT_LE(foundShare(start, {0, 1, 1, 0, 0.1}, kRuns), 0.05 + 0.014) << trials;
  }
  auto expects_a = planned(23);
  expects_a.expects_b = false;
  EXPECT_NEAR(foundShare(expects_a, {1}, kRuns), testOf(23, 0.75).power, 0.026);
}

TEST(DuelRun, SequentialChances) {
  constexpr int kRuns = 4000;
  const DuelStart start = planned(kMostSequentialTrials, DuelRule::kSequential);
  EXPECT_NEAR(foundShare(start, {}, kRuns), .0438, 0.014);
  EXPECT_NEAR(foundShare(start, {1}, kRuns), .8169, 0.026);
  const auto answers = simulatedAnswers(start, {3}, 5);
  EXPECT_LT(answers.size(), 20U);
  EXPECT_NE(sentenceOf(start, verdictOf(start, answers)).find("Sequential"), std::string::npos);
}

// An ideal person: names the heavier one, and says so where there is none.
TEST(DuelVerdict, CountsOrdersAndCatchTrials) {
  auto run = runOf(planned(18));
  while (run.stage() != Stage::kFinished) {
    answerTrial(run, [](const DuelForce& first, const DuelForce& second) {
      const auto weight = [](const DuelForce& force) { return force.is_b ? 1 : force.heavier_jnd; };
      if (weight(first) == weight(second)) return DuelChoice::kCantTell;
      return weight(first) > weight(second) ? DuelChoice::kFirst : DuelChoice::kSecond;
    });
  }
  const auto verdict = verdictOf(run.start(), run.answers());
  EXPECT_EQ(verdict.outcome, Outcome::kDiffer);
  EXPECT_EQ(verdict.right, 18);
  EXPECT_EQ(verdict.large, 1);
  EXPECT_EQ(verdict.large_right, 1);
  EXPECT_EQ(verdict.same, 1);
  EXPECT_EQ(verdict.same_named, 0);
  EXPECT_FALSE(verdict.marked);
  ASSERT_TRUE(verdict.order);
  EXPECT_NEAR(verdict.order->order, 0, 1e-12);
  EXPECT_EQ(sentenceOf(run.start(), verdict), "'after' is felt as heavier: 18 of 18 (95 % interval 81 to 100 %).");
  EXPECT_EQ(endOf(run).outcome, "differ");

  // Always the first one: an order effect, no difference, and the large catch trial is missed or not by chance.
  auto biased = runOf(planned(18));
  while (biased.stage() != Stage::kFinished) answerTrial(biased, [](auto, auto) { return DuelChoice::kFirst; });
  const auto none = verdictOf(biased.start(), biased.answers());
  EXPECT_EQ(none.outcome, Outcome::kNotShown);
  EXPECT_EQ(none.right, 9);
  ASSERT_TRUE(none.order);
  EXPECT_NEAR(none.order->preference, 0, 1e-12);
  EXPECT_GT(none.order->order, 2);
  EXPECT_EQ(none.same_named, 1);
}

TEST(DuelVerdict, MissedLargeDifferencesMarkIt) {
  auto run = runOf(planned(40));
  while (run.stage() != Stage::kFinished) {
    answerTrial(run, [](const DuelForce& first, const DuelForce& second) {
      if (first.heavier_jnd != second.heavier_jnd)  // says the lighter one
        return first.heavier_jnd < second.heavier_jnd ? DuelChoice::kFirst : DuelChoice::kSecond;
      return first.is_b ? DuelChoice::kFirst : DuelChoice::kSecond;
    });
  }
  const auto verdict = verdictOf(run.start(), run.answers());
  EXPECT_EQ(verdict.large, 2);
  EXPECT_TRUE(verdict.marked);
  EXPECT_NE(sentenceOf(run.start(), verdict).find("Marked: only 0 of 2"), std::string::npos);
}

TEST(DuelVerdict, NotShownSaysWhatWouldHaveBeenFound) {
  const DuelStart start = planned(23);
  const auto answers = simulatedAnswers(start, {}, 11);
  const auto verdict = verdictOf(start, answers);
  ASSERT_EQ(verdict.outcome, Outcome::kNotShown);
  EXPECT_NEAR(testOf(23, shareRight(verdict.detectable_jnd)).power, 0.8, 1e-6);
  EXPECT_NE(sentenceOf(start, verdict).find("a difference of 1.0 JND or more would have been found with 80 %"),
            std::string::npos);
  EXPECT_EQ(sentenceOf(start, verdictOf(start, std::span(answers).first(5))),
            "Not finished: nothing is said of the answers so far.");
}

// A person whose own JND is 1.6 times the usual one; 70 trials leave it within a third in all but a few runs.
TEST(DuelVerdict, OwnJnd) {
  int near = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const DuelStart start = planned(70, DuelRule::kOwnJnd, seed);
    const auto answers = simulatedAnswers(start, {0, 1.6, 0.3, 0.05, 0.1}, seed);
    const auto verdict = verdictOf(start, answers);
    ASSERT_EQ(verdict.outcome, Outcome::kMeasured);
    EXPECT_EQ(verdict.trials, 70);
    near += std::abs(verdict.own->factor / 1.6 - 1) < 0.34 ? 1 : 0;
  }
  EXPECT_GE(near, 32);
}

}  // namespace
}  // namespace tactus::experiments
