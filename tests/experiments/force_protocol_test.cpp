#include "experiments/force_protocol.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/base/random.h"

#include "tests/experiments/record_maker.h"

namespace tactus::experiments {
namespace {

using Kind = study::ForceJudgement::Kind;

ForceAnswer term(const std::string& id) { return {Kind::kTerm, id, 0, 25, 40, 1.5}; }
ForceAnswer only(Kind kind) { return {kind, "", 0, 25, 40, 1.5}; }
ForceAnswer standingStill(ForceAnswer answer) {
  answer.forward_mm = 3;
  answer.forward_speed_mm_s = 15;
  return answer;
}

study::JudgementRecord give(ForceProtocol& protocol, const ForceAnswer& answer) {
  static std::uint64_t ids = 0;
  auto record = *protocol.record(answer);
  record.entry.id = idOf(++ids);
  const auto added = protocol.add(record);
  EXPECT_TRUE(added.has_value()) << added.error().message();
  return record;
}

/// Gets used to the forces without answers.
ForceProtocol readyToJudge(const ForceSettings& settings, std::uint64_t seed = 1) {
  auto protocol = *ForceProtocol::create(settings, seed);
  while (protocol.next().step.series == kFamiliarisation) give(protocol, only(Kind::kNoAnswer));
  return protocol;
}

// Practice shows the whole question with one middle force; neither its word nor a refusal to give one counts.
TEST(ForceProtocol, FamiliarisationAsksLikeTheSeriesAndIsNotScored) {
  ForceSettings settings;
  EXPECT_EQ(settings.familiarisation_n, std::vector<double>{0.5});
  settings.familiarisation_n = {0.4, 0.6};
  auto protocol = *ForceProtocol::create(settings, 1);
  for (const double force_n : settings.familiarisation_n) {
    const auto plan = protocol.next();
    EXPECT_EQ(plan.step.force_n, force_n);
    EXPECT_EQ(plan.question.answers.size(), 7U);
    const auto record = give(protocol, force_n < 0.5 ? only(Kind::kNoAnswer) : only(Kind::kBeyondPractice));
    EXPECT_FALSE(record.scored);
    EXPECT_EQ(protocol.lastScored(), nullptr);
  }
  EXPECT_EQ(protocol.next().step.series, kAscending);
}

TEST(ForceProtocol, OffersThePapersTermsAndTwoAdditionsThatAreMarked) {
  const auto answers = readyToJudge({}).next().question.answers;
  ASSERT_EQ(answers.size(), 7U);
  const char* const ids[] = {"very_small", "small", "medium", "large", "very_large", "not_felt", "beyond_practice"};
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(answers[i].id, ids[i]);
    EXPECT_EQ(answers[i].our_addition, i >= 5);
  }
}

TEST(ForceProtocol, TheAscendingSeriesGoesToItsEnd) {
  auto protocol = readyToJudge({});
  std::vector<double> forces;
  while (!protocol.next().finished) forces.push_back(give(protocol, term("large")).commanded_n);
  ASSERT_EQ(forces.size(), 17U);
  EXPECT_EQ(forces.front(), 0.1);
  EXPECT_EQ(forces.back(), 1.7);
}

TEST(ForceProtocol, TheAscendingSeriesStopsBeyondPractice) {
  auto protocol = readyToJudge({});
  for (int i = 0; i < 11; ++i) give(protocol, term("medium"));
  const auto last = give(protocol, only(Kind::kBeyondPractice));
  EXPECT_EQ(last.commanded_n, 1.2);
  EXPECT_TRUE(last.scored);
  EXPECT_TRUE(protocol.next().finished);
  EXPECT_FALSE(protocol.add(last).has_value());
}

TEST(ForceProtocol, ACatchTrialIsAskedLikeAnyForceAndNeverEndsTheSeries) {
  ForceSettings settings;
  settings.ladder_catches = 2;
  settings.descending = true;
  auto protocol = readyToJudge(settings);
  int catches = 0;
  std::vector<double> descended;
  std::vector<study::JudgementRecord> given;
  while (!protocol.next().finished) {
    const auto plan = protocol.next();
    EXPECT_EQ(plan.question.answers.size(), 7U);
    const bool beyond = plan.step.catch_trial || (plan.step.series == kAscending && plan.step.force_n >= 1.5);
    const auto record = give(protocol, beyond ? only(Kind::kBeyondPractice) : term("medium"));
    EXPECT_TRUE(record.scored);
    EXPECT_EQ(record.catch_trial, plan.step.catch_trial);
    if (record.catch_trial) ++catches;
    if (record.series == kDescending && !record.catch_trial) descended.push_back(record.commanded_n);
    given.push_back(record);
  }
  EXPECT_EQ(catches, 4);
  const auto top = std::find_if(given.begin(), given.end(),
                                [](const auto& one) { return one.kind == Kind::kBeyondPractice && !one.catch_trial; });
  ASSERT_NE(top, given.end());
  EXPECT_EQ(top->commanded_n, 1.5);
  EXPECT_LE(descended.front(), 1.5);
  EXPECT_GE(descended.front(), 1.3);
  EXPECT_EQ(descended.back(), 0.1);
}

TEST(ForceProtocol, AStepWithoutForwardMotionIsRepeatedAndNotScored) {
  auto protocol = readyToJudge({});
  const auto still = give(protocol, standingStill(only(Kind::kBeyondPractice)));
  EXPECT_FALSE(still.scored);
  EXPECT_EQ(still.kind, Kind::kBeyondPractice);  // on record, but it ends nothing
  const auto plan = protocol.next();
  EXPECT_EQ(plan.step.step, 1);
  EXPECT_EQ(plan.attempt, 2);
  EXPECT_EQ(plan.question.repeat_reason, "Once more, please: push forward while you feel the force.");
  EXPECT_TRUE(give(protocol, term("very_small")).scored);
  EXPECT_EQ(protocol.next().step.step, 2);
  EXPECT_EQ(protocol.next().attempt, 1);

  auto slow = term("small");
  slow.forward_speed_mm_s = 9;
  EXPECT_FALSE(protocol.record(slow)->scored);
}

TEST(ForceProtocol, AForceThatWasNotDeliveredIsRepeatedAndNotScored) {
  ForceSettings settings;
  settings.device_friction_n = 0.15;
  auto protocol = readyToJudge(settings);
  auto stalled = only(Kind::kBeyondPractice);
  stalled.delivered = false;
  const auto record = give(protocol, stalled);
  EXPECT_FALSE(record.scored);
  EXPECT_FALSE(record.felt_n.has_value());
  EXPECT_EQ(record.kind, Kind::kBeyondPractice);  // on record, but it ends nothing
  EXPECT_EQ(record.forward_mm, 25);
  const auto plan = protocol.next();
  EXPECT_EQ(plan.step.step, 1);
  EXPECT_EQ(plan.attempt, 2);
  EXPECT_EQ(plan.question.repeat_reason, "Once more, please: the device did not give the whole force.");
  give(protocol, standingStill(stalled));
  EXPECT_EQ(protocol.next().question.repeat_reason, "Once more, please: push forward while you feel the force.");
  EXPECT_TRUE(give(protocol, term("very_small")).scored);
  EXPECT_EQ(protocol.next().step.step, 2);
}

TEST(ForceProtocol, OnlyTheWholeForceIsScoredAndTheShareIsStored) {
  auto protocol = readyToJudge({});
  auto cut = term("large");
  cut.delivered_share = 0.53;  // 0.90 N of 1.7 N
  const auto record = give(protocol, cut);
  EXPECT_FALSE(record.scored);
  EXPECT_EQ(record.delivered_share, 0.53);
  EXPECT_EQ(protocol.next().question.repeat, RepeatReason::kNotDelivered);
  EXPECT_EQ(name(protocol.next().question.repeat), "not_delivered");
  auto whole = term("large");
  whole.delivered_share = 1;
  EXPECT_TRUE(give(protocol, whole).scored);
  EXPECT_EQ(protocol.next().question.repeat, RepeatReason::kNone);
  for (const double impossible : {-0.1, 1.1}) {
    whole.delivered_share = impossible;
    EXPECT_FALSE(protocol.record(whole).has_value()) << impossible;
  }
}

TEST(ForceProtocol, AStepThatIsNeverScoredIsLeftOutAfterSomeAttempts) {
  ForceSettings settings;
  settings.attempts_most = 3;
  auto protocol = readyToJudge(settings);
  auto cut = term("large");
  cut.delivered = false;
  for (int attempt = 1; attempt <= 3; ++attempt) {
    EXPECT_EQ(protocol.next().attempt, attempt);
    EXPECT_EQ(protocol.next().step.step, 1);
    give(protocol, cut);
  }
  EXPECT_EQ(protocol.next().step.step, 2);
  int steps = 1;
  while (!protocol.next().finished) {
    give(protocol, standingStill(term("small")));
    ASSERT_LE(++steps, 3 * 17);
  }
}

// A study from before attempts were limited must open.
TEST(ForceProtocol, MoreAttemptsOfAnOlderSessionAreTaken) {
  ForceSettings older;
  older.attempts_most = 20;
  auto recorded = readyToJudge(older);
  std::vector<study::JudgementRecord> records;
  for (int i = 0; i < 9; ++i) records.push_back(give(recorded, standingStill(term("small"))));
  records.push_back(give(recorded, term("very_small")));
  records.push_back(give(recorded, term("small")));
  auto protocol = readyToJudge({});
  for (const auto& record : records) {
    const auto added = protocol.add(record);
    ASSERT_TRUE(added) << added.error().message();
  }
  EXPECT_EQ(protocol.next().step.step, 3);
}

TEST(ForceProtocol, TheFeltForceHasTheDevicesFrictionOnTop) {
  ForceSettings settings;
  EXPECT_FALSE(readyToJudge(settings).record(term("small"))->felt_n.has_value());
  settings.device_friction_n = 0.15;
  const auto protocol = readyToJudge(settings);
  const auto record = *protocol.record(term("small"));
  EXPECT_EQ(record.commanded_n, 0.1);
  EXPECT_DOUBLE_EQ(record.felt_n.value(), 0.25);
  EXPECT_FALSE(protocol.record(standingStill(term("small")))->felt_n.has_value());
}

TEST(ForceProtocol, TimingIsDataForTheScreenAndTheServo) {
  auto protocol = readyToJudge({});
  for (int i = 1; i <= 17; ++i) {
    const auto plan = protocol.next();
    EXPECT_EQ(plan.ramp_s, 0.15);
    EXPECT_EQ(plan.pause_before_s, 2);
    EXPECT_EQ(plan.hold_limit_s.has_value(), i >= 9) << i;  // 0.9 N is above 0.88 N
    EXPECT_EQ(plan.hold_limit_s.value_or(3), 3);
    give(protocol, term("medium"));
  }
}

TEST(ForceProtocol, ARestIsOfferedEveryTwentySteps) {
  ForceSettings settings;
  settings.random = true;
  auto protocol = *ForceProtocol::create(settings, 1);
  for (int felt = 0; !protocol.next().finished; ++felt) {
    EXPECT_EQ(protocol.next().question.rest_first, felt == 20 || felt == 40) << felt;
    give(protocol, felt < 3 ? only(Kind::kNoAnswer) : term("medium"));
  }
}

TEST(ForceProtocol, AllSeriesComeOneAfterAnother) {
  ForceSettings settings;
  settings.descending = true;
  settings.random = true;
  auto protocol = readyToJudge(settings, 4);
  for (int i = 0; i < 5; ++i) give(protocol, term("medium"));
  give(protocol, only(Kind::kBeyondPractice));
  const double start_n = descendingStart(settings, 0.6, 4);
  EXPECT_EQ(protocol.next().step, (SeriesStep{kDescending, 1, start_n, false}));
  while (protocol.next().step.series == kDescending) give(protocol, term("small"));
  int judged = 0;
  while (!protocol.next().finished) {
    EXPECT_EQ(protocol.next().step.series, kRandom);
    const auto record = give(protocol, only(Kind::kNotFelt));
    EXPECT_EQ(record.catch_trial,
              protocol.steps()[protocol.steps().size() - 38 + static_cast<std::size_t>(judged)].catch_trial);
    ++judged;
  }
  EXPECT_EQ(judged, 38);
}

TEST(ForceProtocol, ACorrectionOfTheEndLetsTheSeriesGoOn) {
  auto protocol = readyToJudge({});
  give(protocol, term("small"));
  const auto ended = give(protocol, only(Kind::kBeyondPractice));
  ASSERT_TRUE(protocol.next().finished);
  auto corrected = ended;
  corrected.entry.id = idOf(5000);
  corrected.entry.supersedes = ended.entry.id;
  corrected.kind = Kind::kTerm;
  corrected.term = "large";
  ASSERT_TRUE(protocol.add(corrected).has_value());
  EXPECT_EQ(protocol.next().step.step, 3);
  auto elsewhere = corrected;
  elsewhere.entry.supersedes = corrected.entry.id;
  elsewhere.step = 1;
  EXPECT_FALSE(protocol.add(elsewhere).has_value());
}

TEST(ForceProtocol, WhatDoesNotFitIsRefusedAndChangesNothing) {
  auto protocol = readyToJudge({});
  const auto plan = protocol.next();
  EXPECT_FALSE(protocol.record(term("huge")).has_value());
  auto impossible = term("small");
  impossible.response_s = -1;
  EXPECT_FALSE(protocol.record(impossible).has_value());
  const auto good = *protocol.record(term("small"));
  const auto refused = [&](auto change) {
    auto record = good;
    change(record);
    return !protocol.add(record).has_value();
  };
  EXPECT_TRUE(refused([](auto& record) { record.step = 2; }));
  EXPECT_TRUE(refused([](auto& record) { record.attempt = 2; }));
  EXPECT_TRUE(refused([](auto& record) { record.series = kRandom; }));
  EXPECT_TRUE(refused([](auto& record) { record.commanded_n = 0.2; }));
  EXPECT_TRUE(refused([](auto& record) { record.term = "huge"; }));
  EXPECT_TRUE(refused([](auto& record) { record.entry.supersedes = idOf(123456); }));
  EXPECT_EQ(protocol.next(), plan);
}

TEST(ForceProtocol, ResumedAnywhereItGoesOnTheSame) {
  ForceSettings settings;
  settings.descending = true;
  settings.random = true;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    base::Random random(seed);
    auto protocol = *ForceProtocol::create(settings, seed);
    std::vector<study::JudgementRecord> records;
    while (!protocol.next().finished) {
      const auto resumed = ForceProtocol::create(settings, seed, records);
      ASSERT_TRUE(resumed.has_value()) << resumed.error().message();
      ASSERT_EQ(resumed->next(), protocol.next());
      ASSERT_EQ(resumed->steps(), protocol.steps());
      const bool asked = !protocol.next().question.answers.empty();
      ForceAnswer answer = only(Kind::kNoAnswer);
      if (asked)
        answer = random.below(12) == 0 ? only(Kind::kBeyondPractice)
                                       : term(settings.terms[static_cast<std::size_t>(random.below(5))]);
      if (random.below(5) == 0) answer = standingStill(answer);
      answer.delivered = random.below(8) != 0;
      records.push_back(give(protocol, answer));
      if (random.below(8) != 0 || !asked) continue;
      auto correction = records.back();
      correction.entry.supersedes = correction.entry.id;
      correction.entry.id = idOf(1000000 + seed * 1000 + records.size());
      correction.kind = Kind::kTerm;
      correction.term = "large";
      ASSERT_TRUE(protocol.add(correction).has_value());
      records.push_back(correction);
    }
    EXPECT_TRUE(ForceProtocol::create(settings, seed, records)->next().finished);
  }
}

}  // namespace
}  // namespace tactus::experiments
