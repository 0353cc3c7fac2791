#include "experiments/stroke.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tactus::experiments {
namespace {

constexpr StrokeVerdict kAll[] = {StrokeVerdict::kAccepted,  StrokeVerdict::kTooShort,   StrokeVerdict::kTooBrief,
                                  StrokeVerdict::kBackwards, StrokeVerdict::kOutOfRange, StrokeVerdict::kInterrupted,
                                  StrokeVerdict::kRejected};

TEST(Stroke, VerdictsAreKnownByTheirNames) {
  for (const StrokeVerdict verdict : kAll) EXPECT_EQ(strokeVerdict(name(verdict)), verdict);
  EXPECT_EQ(name(StrokeVerdict::kTooShort), "too_short");
  EXPECT_FALSE(strokeVerdict("fine").has_value());
}

TEST(Stroke, SaysWhatWasWrongAndWhatIsWanted) {
  Stroke stroke;
  stroke.start_mm = 3;
  stroke.end_mm = 15.9;
  stroke.verdict = StrokeVerdict::kTooShort;
  EXPECT_EQ(sentence(stroke, {}), "Too short: 12 mm, at least 30 mm wanted.");
  stroke.end_mm = 32.999;  // 29.999 mm must not read as 30 mm
  EXPECT_EQ(sentence(stroke, {}), "Too short: 29 mm, at least 30 mm wanted.");
  stroke.verdict = StrokeVerdict::kBackwards;
  stroke.end_mm = -42;
  EXPECT_EQ(sentence(stroke, {}), "Backwards: 45 mm back; please push forward, away from you.");
}

TEST(Stroke, NoSentenceTellsASpeed) {
  Stroke stroke{0, 500, 0, 0.5, 0, 20, StrokeVerdict::kAccepted};
  for (const StrokeVerdict verdict : kAll) {
    stroke.verdict = verdict;
    EXPECT_FALSE(sentence(stroke, {}).empty());
    EXPECT_EQ(sentence(stroke, {}).find("mm/s"), std::string::npos);
    EXPECT_EQ(sentence(stroke, {}).find(" s,"), std::string::npos);
  }
}

TEST(StrokeSettings, TheDefaultsAreValid) { EXPECT_TRUE(validate(StrokeSettings{}).has_value()); }

TEST(StrokeSettings, NonsenseIsRefusedWithOneSentence) {
  const auto refused = [](auto change) {
    StrokeSettings settings;
    change(settings);
    const auto result = validate(settings);
    return result ? std::string("accepted") : result.error().message();
  };
  EXPECT_EQ(refused([](auto& s) { s.stop_speed_mm_s = 12; }),
            "stop_speed_mm_s: found 12, wanted less than start_speed_mm_s (12)");
  EXPECT_EQ(refused([](auto& s) { s.shortest_mm = 0; }), "shortest_mm: found 0, wanted a number above 0");
  EXPECT_EQ(refused([](auto& s) { s.edge_speed_mm_s = std::numeric_limits<double>::quiet_NaN(); }),
            "edge_speed_mm_s: found nan, wanted a number above 0");
  EXPECT_EQ(refused([](auto& s) { s.speed_window_s = 1; }), "speed_window_s: found 1, wanted 0.05 to 0.5 s");
  EXPECT_EQ(refused([](auto& s) { s.longest_reversal_mm = 30; }),
            "longest_reversal_mm: found 30, wanted less than shortest_mm (30)");
  EXPECT_EQ(refused([](auto& s) { s.least_mm = 31; }), "least_mm: found 31, wanted at most shortest_mm (30)");
  EXPECT_EQ(refused([](auto& s) { s.highest_mm = s.lowest_mm; }),
            "highest_mm: found -1000, wanted at least lowest_mm + shortest_mm");
}

}  // namespace
}  // namespace tactus::experiments
