#include "experiments/order_effects.h"

#include <cmath>
#include <gtest/gtest.h>

#include "experiments/force_series.h"

#include "tests/experiments/record_maker.h"

namespace tactus::experiments {
namespace {

using Kind = study::ForceJudgement::Kind;

const std::vector<std::string> kWords = {"very_small", "small", "medium", "large", "very_large"};

study::JudgementRecord judged(const std::string& series, double force_n, int term, bool catch_trial = false) {
  static std::uint64_t ids = 0;
  study::JudgementRecord record;
  record.entry.id = idOf(++ids);
  record.series = series;
  record.commanded_n = force_n;
  record.kind = term < 0 ? Kind::kNotFelt : Kind::kTerm;
  if (term >= 0) record.term = kWords[static_cast<std::size_t>(term)];
  record.scored = true;
  record.catch_trial = catch_trial;
  return record;
}

TEST(OrderEffects, CountsCatchTrialsOfEachPerson) {
  DoneInOrder one{"P1", true, {}, {}, {}};
  one.judgements = {judged(kAscending, 0.1, 0),        judged(kAscending, 0.2, 1),
                    judged(kAscending, 0, -1, true),   judged(kAscending, 0.3, 2),
                    judged(kAscending, 0.1, 0, true),  judged(kDescending, 0.3, 1),
                    judged(kDescending, 0, 0, true),   judged(kDescending, 0.2, 1),
                    judged(kDescending, 0.3, 2, true), judged(kDescending, 0.1, 0)};
  const auto effects = orderEffects(std::vector{one}, kWords);
  ASSERT_EQ(effects.persons.size(), 1U);
  const auto& person = effects.persons[0];
  EXPECT_TRUE(person.simulated);
  EXPECT_EQ(person.blanks, 2U);
  EXPECT_EQ(person.felt_blanks, 1U);
  EXPECT_EQ(person.repeats, 2U);
  EXPECT_EQ(person.same_repeats, 1U);
  // 0.1: 0 - 0, 0.2: 1 - 1, 0.3: 2 - 1; the catch trials are left out.
  EXPECT_EQ(person.both_ways, 3U);
  EXPECT_DOUBLE_EQ(*person.up_minus_down, 1.0 / 3);
  EXPECT_EQ(effects.up_minus_down.persons, 1U);
  EXPECT_FALSE(effects.up_minus_down.standard_error);
}

// Each level takes 10 % more at its second place than at its first.
TEST(OrderEffects, FindsThePlaceInTheSpeeds) {
  const std::vector<DoneInOrder> done = {{"P1", false, {{"slow", 40}, {"fast", 110}}, {}, {}},
                                         {"P2", false, {{"fast", 100}, {"slow", 44}}, {}, {}}};
  const auto places = orderEffects(done, kWords).speed_at_place;
  ASSERT_EQ(places.size(), 2U);
  EXPECT_NEAR(places[0].mean, (40 / 42.0 + 100 / 105.0) / 2, 1e-12);
  EXPECT_NEAR(places[1].mean, (110 / 105.0 + 44 / 42.0) / 2, 1e-12);
  EXPECT_NEAR(*places[0].standard_error, 0, 1e-12);
  // One order for all: nothing to tell.
  const std::vector<DoneInOrder> alike = {done[0], {"P3", false, {{"slow", 50}, {"fast", 90}}, {}, {}}};
  EXPECT_TRUE(orderEffects(alike, kWords).speed_at_place.empty());
}

// Both say the same of each of six items, but for one word more in the last third of their own order.
TEST(OrderEffects, FindsADriftOfTheAnswers) {
  DoneInOrder one{"P1", false, {}, {}, {}};
  DoneInOrder other{"P2", false, {}, {}, {}};
  for (int position = 1; position <= 6; ++position) {
    const std::size_t more = position > 4 ? 1 : 0;
    one.answers.push_back({position, position, 2 + more});
    other.answers.push_back({7 - position, position, 2 + more});
  }
  // Items 1, 2, 5 and 6 have means of 2.5: late 0.5 above, early 0.5 below.
  const auto drift = orderEffects(std::vector{one, other}, kWords).late_minus_early;
  EXPECT_EQ(drift.persons, 2U);
  EXPECT_DOUBLE_EQ(drift.mean, 1);
  EXPECT_EQ(orderEffects(std::vector{one, one}, kWords).late_minus_early.persons, 0U);
  EXPECT_EQ(orderEffects({}, kWords).persons.size(), 0U);
}

}  // namespace
}  // namespace tactus::experiments
