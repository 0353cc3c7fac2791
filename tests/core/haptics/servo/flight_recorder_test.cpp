#include <atomic>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <thread>

#include "core/haptics/servo/servo.h"

namespace tactus::haptics {
namespace {

Sample recordedSample(std::uint64_t tick) {
  Sample sample;
  sample.tick = tick;
  sample.position_mm = 2 * static_cast<double>(tick);
  return sample;
}

Trip tripAt(std::uint64_t tick) {
  return {TripCause::kTooFastOutwards, 700, 400, static_cast<std::int64_t>(tick) * 1'000'000};
}

/// Records the ticks from `first` to `last`, all with the same latched trip.
void record(FlightRecorder& recorder, std::uint64_t first, std::uint64_t last, const Trip& latched) {
  for (std::uint64_t tick = first; tick <= last; ++tick) recorder.record(recordedSample(tick), latched);
}

void expectTicks(const std::optional<FlightRecord>& record, std::uint64_t first, std::uint64_t last) {
  ASSERT_TRUE(record.has_value());
  ASSERT_EQ(record->samples.size(), last - first + 1);
  for (std::uint64_t tick = first; tick <= last; ++tick) ASSERT_EQ(record->samples[tick - first].tick, tick);
}

TEST(FlightRecorder, HoldsFourSecondsBeforeATripAndAFifthAfter) {
  FlightRecorder recorder;
  record(recorder, 1, 9999, {});
  record(recorder, 10000, 10199, tripAt(10000));
  EXPECT_FALSE(recorder.take().has_value()) << "the ticks after the trip are not complete";
  record(recorder, 10200, 10200, tripAt(10000));
  record(recorder, 10201, 20000, tripAt(10000));
  const auto taken = recorder.take();
  expectTicks(taken, 6000, 10200);
  EXPECT_EQ(taken->trip, tripAt(10000));
  EXPECT_FALSE(recorder.take().has_value()) << "one trip, one record";
}

TEST(FlightRecorder, HoldsWhatThereIsWhenATripComesEarly) {
  FlightRecorder recorder(100, 10);
  record(recorder, 1, 4, {});
  record(recorder, 5, 30, tripAt(5));
  expectTicks(recorder.take(), 1, 15);
}

TEST(FlightRecorder, RecordsTheNextTripAfterArmingAgain) {
  FlightRecorder recorder(20, 5);
  record(recorder, 1, 99, {});
  record(recorder, 100, 200, tripAt(100));
  record(recorder, 201, 299, {});  // armed again
  record(recorder, 300, 400, tripAt(300));
  const auto first = recorder.take();
  expectTicks(first, 80, 105);
  EXPECT_EQ(first->trip.time_ns, 100'000'000);
  const auto second = recorder.take();
  expectTicks(second, 280, 305);
  EXPECT_EQ(second->trip.time_ns, 300'000'000);
}

TEST(FlightRecorder, ATripThatFollowsAnotherWithoutAPauseIsAnotherTrip) {
  FlightRecorder recorder(20, 5);
  record(recorder, 1, 99, tripAt(1));
  record(recorder, 100, 199, tripAt(100));
  expectTicks(recorder.take(), 1, 6);
  expectTicks(recorder.take(), 80, 105);
}

TEST(FlightRecorder, KeepsTheOldestRecordsUntilTheyAreTaken) {
  FlightRecorder recorder(20, 5);
  for (std::uint64_t start : {0U, 100U, 200U, 300U}) {
    record(recorder, start + 1, start + 49, {});
    record(recorder, start + 50, start + 100, tripAt(start + 50));
  }
  expectTicks(recorder.take(), 30, 55);
  expectTicks(recorder.take(), 130, 155);
  EXPECT_FALSE(recorder.take().has_value()) << "there was no tape for the third and fourth";
  record(recorder, 401, 449, {});
  record(recorder, 450, 500, tripAt(450));
  expectTicks(recorder.take(), 430, 455);
}

TEST(FlightRecorder, RecordsAreWholeWhileAnotherThreadTakesThem) {
  FlightRecorder recorder(50, 10);
  std::atomic<bool> done{false};
  std::uint64_t wrong = 0, taken = 0;
  std::atomic<bool> reading{false};
  std::thread reader([&] {
    reading.store(true);
    for (bool last_look = false; !last_look;) {
      last_look = done.load();
      while (const auto record = recorder.take()) {
        ++taken;
        const auto trip_tick = static_cast<std::uint64_t>(record->trip.time_ns / 1'000'000);
        if (record->samples.empty() || record->samples.back().tick != trip_tick + 10) ++wrong;
        for (std::size_t i = 0; i < record->samples.size(); ++i) {
          const Sample& sample = record->samples[i];
          if (sample.tick != record->samples.front().tick + i) ++wrong;
          if (sample.position_mm != 2 * static_cast<double>(sample.tick)) ++wrong;
        }
      }
    }
  });
  while (!reading.load()) std::this_thread::yield();
  for (std::uint64_t start = 0; start < 100'000; start += 100) {
    std::this_thread::yield();
    record(recorder, start + 1, start + 69, {});
    record(recorder, start + 70, start + 100, tripAt(start + 70));
  }
  done.store(true);
  reader.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_GE(taken, 2U);
}

}  // namespace
}  // namespace tactus::haptics
