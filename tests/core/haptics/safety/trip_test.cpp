// What is said of a trip.
#include <gtest/gtest.h>
#include <string>

#include "core/haptics/safety/safety.h"

namespace tactus::haptics {
namespace {

TEST(Trip, IsDescribedForAPerson) {
  EXPECT_EQ(sentence({TripCause::kTooFastOutwards, 431.2, 400, 0}),
            "the hand moved outwards too fast: 431 mm/s, allowed 400 mm/s");
  EXPECT_EQ(sentence({TripCause::kDeviceSilent, 0.1012, 0.1, 0}),
            "the device sent no sample for too long: 0.101 s, allowed 0.100 s");
  EXPECT_EQ(sentence({TripCause::kStopped, 0, 0, 0}), "Stop was pressed");
  EXPECT_EQ(sentence({TripCause::kDeviceFault, 3, 0, 0}),
            "a switch, the device itself or another program holds the forces back");
  EXPECT_EQ(sentence({TripCause::kDeviceFault, 4, 0, 0}), "the motors are too warm");
  EXPECT_EQ(sentence({TripCause::kRenderer, 2, 0, 0}), "the renderer let go: the model's force was not a number");
  for (int i = 0; i <= static_cast<int>(TripCause::kStopped); ++i)
    EXPECT_NE(describe(static_cast<TripCause>(i)), "unknown trip") << i;
}

/// Whatever a trip is about, a number in its sentence has a unit.
TEST(Trip, NoSentenceHasABareNumber) {
  for (int cause = 0; cause <= static_cast<int>(TripCause::kStopped); ++cause) {
    for (int value = 0; value < 9; ++value) {
      const Trip trip{static_cast<TripCause>(cause), static_cast<double>(value), 1, 0};
      const std::string text = sentence(trip);
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(text.find('('), std::string::npos) << text;
      if (unitOf(trip.cause).empty() && text.find("1 km") == std::string::npos) {
        EXPECT_EQ(text.find_first_of("0123456789"), std::string::npos) << text;
      }
    }
  }
}

}  // namespace
}  // namespace tactus::haptics
