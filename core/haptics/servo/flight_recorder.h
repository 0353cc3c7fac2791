// Keeps the ticks around a trip, so that its cause can be seen afterwards.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/haptics/safety/trip.h"
#include "core/haptics/servo/sample.h"

namespace tactus::haptics {

/// The first trip since arming, with the ticks before and after it.
struct FlightRecord {
  Trip trip;
  std::vector<Sample> samples;  ///< oldest first
};

/// Two tapes, all memory taken in advance. The writer records on one; some ticks after a trip it leaves that tape to
/// the reader and goes on with the other, so that nobody waits. While the reader has taken neither, nothing is
/// recorded. A trip that is latched makes one record; cleared and tripped again, the next one. A trip within the ticks
/// after another belongs to the record of that one.
class FlightRecorder {
 public:
  static constexpr std::size_t kTicksBefore = 4000;  ///< 4 s at 1 kHz: a whole stroke with its approach
  static constexpr std::size_t kTicksAfter = 200;    ///< 0.2 s: until every force is gone and the hand has let go

  /// A record holds at most `before` ticks before that of the trip, the tick of the trip, and `after` ticks.
  explicit FlightRecorder(std::size_t before = kTicksBefore, std::size_t after = kTicksAfter);

  /// One tick, and the trip that is latched at its end, if any.
  /// Thread: writer. Real-time safe: yes.
  void record(const Sample& sample, const Trip& latched) noexcept;

  /// The oldest record that has not been taken, or nothing. Thread: reader. Real-time safe: no.
  std::optional<FlightRecord> take();

 private:
  struct Tape {
    std::vector<Sample> samples;  ///< a ring
    std::uint64_t recorded = 0;   ///< ticks since the tape was begun
    Trip trip;
    /// True: the tape is the reader's with all above, until it sets false again. Release and acquire both ways.
    std::atomic<bool> full{false};
  };

  std::array<Tape, 2> tapes_;
  std::size_t after_;

  // Touched by the writer alone.
  std::size_t writing_ = 0;  ///< which tape
  std::size_t left_ = 0;     ///< ticks until the tape is full, from the trip on
  Trip seen_;                ///< the latched trip at the last tick

  std::size_t reading_ = 0;  ///< Touched by the reader alone: which tape is full next; they take turns.
};

}  // namespace tactus::haptics
