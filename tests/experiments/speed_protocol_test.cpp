#include "experiments/speed_protocol.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/base/random.h"

#include "tests/experiments/record_maker.h"

namespace tactus::experiments {
namespace {

/// 100 samples that go from 0 by `length_mm`.
study::Recording recordingOf(double length_mm) {
  study::Channel depth{"depth", "mm", {}};
  for (int i = 0; i < 100; ++i) depth.values.push_back(length_mm * i / 99);
  return {1000, {depth}};
}

study::StrokeRecord answer(const SpeedProtocol& protocol, StrokeVerdict verdict, double length_mm = 60) {
  static std::uint64_t ids = 0;
  Stroke stroke;
  stroke.first = 1000;
  stroke.last = 1100;
  stroke.end_mm = length_mm;
  stroke.verdict = verdict;
  auto record = protocol.record(stroke, recordingOf(length_mm), 1000);
  record.entry.id = idOf(++ids);
  return record;
}

std::string told(const SpeedPlan& plan) {
  if (plan.finished) return "finished";
  return plan.level + (plan.practice ? " practice " : " ") + std::to_string(plan.number) + "/" +
         std::to_string(plan.count) + " attempt " + std::to_string(plan.attempt);
}

TEST(SpeedProtocol, AsksAsInThePaperWithPracticeFirst) {
  auto protocol = *SpeedProtocol::create({}, 1);
  std::vector<std::string> asked;
  while (!protocol.next().finished) {
    const auto plan = protocol.next();
    EXPECT_TRUE(plan.repeat_reason.empty());
    asked.push_back(told(plan));
    ASSERT_TRUE(protocol.add(answer(protocol, StrokeVerdict::kAccepted)).has_value());
  }
  std::vector<std::string> wanted;
  for (const std::string level : {"slow", "medium", "fast"}) {
    wanted.push_back(level + " practice 1/1 attempt 1");
    for (int number = 1; number <= 4; ++number) wanted.push_back(level + " " + std::to_string(number) + "/4 attempt 1");
  }
  EXPECT_EQ(asked, wanted);
  EXPECT_EQ(protocol.next().accepted, 12);
  EXPECT_EQ(protocol.next().wanted, 12);
}

TEST(SpeedProtocol, ABadStrokeIsNamedAndRepeated) {
  SpeedSettings settings;
  settings.practice = 0;
  auto protocol = *SpeedProtocol::create(settings, 1);
  ASSERT_TRUE(protocol.add(answer(protocol, StrokeVerdict::kTooShort, 12.5)).has_value());
  EXPECT_EQ(told(protocol.next()), "slow 1/4 attempt 2");
  EXPECT_EQ(protocol.next().repeat_reason, "Too short: 12 mm, at least 30 mm wanted.");
  EXPECT_EQ(protocol.next().repeat, StrokeVerdict::kTooShort);
  ASSERT_TRUE(protocol.add(answer(protocol, StrokeVerdict::kInterrupted)).has_value());
  EXPECT_EQ(told(protocol.next()), "slow 1/4 attempt 3");
  EXPECT_EQ(protocol.next().repeat_reason, "Interrupted: part of the movement was not recorded.");
  EXPECT_EQ(protocol.next().accepted, 0);
  ASSERT_TRUE(protocol.add(answer(protocol, StrokeVerdict::kAccepted)).has_value());
  EXPECT_EQ(told(protocol.next()), "slow 2/4 attempt 1");
  EXPECT_EQ(protocol.next().repeat_reason, "");
  EXPECT_EQ(protocol.next().repeat, StrokeVerdict::kAccepted);
}

TEST(SpeedProtocol, AStrokeThatIsTakenBackIsAskedForAgain) {
  SpeedSettings settings;
  settings.practice = 0;
  auto protocol = *SpeedProtocol::create(settings, 1);
  const auto first = answer(protocol, StrokeVerdict::kAccepted);
  ASSERT_TRUE(protocol.add(first).has_value());
  ASSERT_TRUE(protocol.add(answer(protocol, StrokeVerdict::kAccepted)).has_value());
  auto taken_back = first;
  taken_back.entry.id = idOf(900);
  taken_back.entry.supersedes = first.entry.id;
  taken_back.verdict = "rejected";
  ASSERT_TRUE(protocol.add(taken_back).has_value());
  EXPECT_EQ(told(protocol.next()), "slow 1/4 attempt 2");
  EXPECT_EQ(protocol.next().repeat_reason, "Taken back: this stroke is done once more.");
  ASSERT_TRUE(protocol.add(answer(protocol, StrokeVerdict::kAccepted)).has_value());
  EXPECT_EQ(told(protocol.next()), "slow 3/4 attempt 1");
}

TEST(SpeedProtocol, WhatDoesNotFitIsRefusedAndChangesNothing) {
  auto protocol = *SpeedProtocol::create({}, 1);
  const auto plan = protocol.next();
  const auto refused = [&](auto change) {
    auto record = answer(protocol, StrokeVerdict::kAccepted);
    change(record);
    return !protocol.add(record).has_value();
  };
  EXPECT_TRUE(refused([](auto& record) { record.level = "fast"; }));
  EXPECT_TRUE(refused([](auto& record) { record.level = "hasty"; }));
  EXPECT_TRUE(refused([](auto& record) { record.number = 2; }));
  EXPECT_TRUE(refused([](auto& record) { record.attempt = 2; }));
  EXPECT_TRUE(refused([](auto& record) { record.practice = false; }));
  EXPECT_TRUE(refused([](auto& record) { record.verdict = "fine"; }));
  EXPECT_TRUE(refused([](auto& record) { record.entry.supersedes = idOf(999999); }));
  EXPECT_EQ(protocol.next(), plan);
}

TEST(SpeedProtocol, TheShuffledOrderFollowsFromTheSeed) {
  SpeedSettings settings;
  settings.order = SpeedSettings::Order::kShuffled;
  std::set<std::vector<std::string>> orders;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto order = SpeedProtocol::create(settings, seed)->levels();
    EXPECT_EQ(order, SpeedProtocol::create(settings, seed)->levels());
    EXPECT_TRUE(std::is_permutation(order.begin(), order.end(), settings.levels.begin(), settings.levels.end()));
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 6U);
  EXPECT_EQ(SpeedProtocol::create({}, 5)->levels(), (std::vector<std::string>{"slow", "medium", "fast"}));
}

// Williams (1949): over the rows each level stands equally often at each place and after each other level.
TEST(SpeedProtocol, TheRowsOfTheLatinSquareAreBalanced) {
  for (std::size_t count = 1; count <= 6; ++count) {
    SpeedSettings settings;
    settings.order = SpeedSettings::Order::kLatinSquare;
    settings.levels.clear();
    for (std::size_t i = 0; i < count; ++i) settings.levels.push_back(std::string(1, static_cast<char>('a' + i)));
    const int rows = static_cast<int>(count % 2 == 0 ? count : 2 * count);
    std::map<std::pair<std::string, std::size_t>, int> at_place;
    std::map<std::pair<std::string, std::string>, int> after;
    for (settings.latin_row = 0; settings.latin_row < rows; ++settings.latin_row) {
      const auto order = SpeedProtocol::create(settings, 1)->levels();
      ASSERT_TRUE(std::is_permutation(order.begin(), order.end(), settings.levels.begin(), settings.levels.end()));
      for (std::size_t place = 0; place < count; ++place) {
        ++at_place[{order[place], place}];
        if (place > 0) ++after[{order[place - 1], order[place]}];
      }
      auto again = settings;
      again.latin_row += rows;
      EXPECT_EQ(SpeedProtocol::create(again, 2)->levels(), order);
    }
    for (const auto& [key, times] : at_place) EXPECT_EQ(times, rows / static_cast<int>(count));
    EXPECT_EQ(after.size(), count * (count - 1));
    for (const auto& [key, times] : after) EXPECT_EQ(times, count % 2 == 0 ? 1 : 2);
  }
}

TEST(SpeedProtocol, ResumedAnywhereItGoesOnTheSame) {
  SpeedSettings settings;
  settings.order = SpeedSettings::Order::kShuffled;
  settings.practice = 2;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    base::Random random(seed);
    auto protocol = *SpeedProtocol::create(settings, seed);
    std::vector<study::StrokeRecord> records;
    while (!protocol.next().finished) {
      const auto resumed = SpeedProtocol::create(settings, seed, records);
      ASSERT_TRUE(resumed.has_value());
      ASSERT_EQ(resumed->next(), protocol.next());
      auto record = answer(protocol, random.below(3) == 0 ? StrokeVerdict::kTooBrief : StrokeVerdict::kAccepted);
      if (!records.empty() && random.below(6) == 0 && records.back().verdict == "accepted") {
        record = records.back();  // the researcher takes the last one back
        record.entry.supersedes = record.entry.id;
        record.entry.id = idOf(100000 + seed * 1000 + records.size());
        record.verdict = "rejected";
      }
      ASSERT_TRUE(protocol.add(record).has_value());
      records.push_back(record);
    }
    EXPECT_TRUE(SpeedProtocol::create(settings, seed, records)->next().finished);
    EXPECT_FALSE(protocol.add(records.back()).has_value());
  }
}

TEST(SpeedSettings, NonsenseIsRefusedWithOneSentence) {
  const auto refused = [](auto change) {
    SpeedSettings settings;
    change(settings);
    const auto result = validate(settings);
    return result ? std::string("accepted") : result.error().message();
  };
  EXPECT_EQ(refused([](auto&) {}), "accepted");
  EXPECT_EQ(refused([](auto& s) { s.levels.clear(); }), "levels: found none, wanted at least one level");
  EXPECT_EQ(refused([](auto& s) {
              s.levels = {"slow", "slow"};
            }),
            "levels: found 'slow' twice, wanted each level once");
  EXPECT_EQ(refused([](auto& s) { s.strokes = 0; }), "strokes: found 0, wanted 1 to 50");
  EXPECT_EQ(refused([](auto& s) { s.practice = -1; }), "practice: found -1, wanted 0 to 20");
  EXPECT_EQ(refused([](auto& s) { s.stroke.briefest_s = -1; }), "briefest_s: found -1, wanted a number above 0");
}

}  // namespace
}  // namespace tactus::experiments
