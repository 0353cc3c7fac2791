// Keeps the ticks around a trip, so that the user can find its cause.
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

/// Two tapes (rings of samples), allocated in advance. The writer records on one. A fixed number of ticks after a trip
/// it passes that tape to the reader and continues on the other, so no thread waits. If the reader holds both tapes,
/// the writer records nothing.
/// A latched trip makes one record. If it is cleared and a new trip occurs, that makes the next record. A trip within
/// the ticks after another one belongs to the record of the first.
class FlightRecorder {
 public:
  static constexpr std::size_t kTicksBefore = 4000;  ///< 4 s at 1 kHz: a whole stroke with its approach
  static constexpr std::size_t kTicksAfter = 200;    ///< 0.2 s: until the force is zero and the hand has let go

  /// A record holds at most `before` ticks before the trip, the tick of the trip, and `after` ticks.
  explicit FlightRecorder(std::size_t before = kTicksBefore, std::size_t after = kTicksAfter);

  /// Records one tick. `latched`: the trip latched at its end, or none.
  /// Thread: writer. Real-time safe: yes.
  void record(const Sample& sample, const Trip& latched) noexcept;

  /// The oldest record not yet taken, or nothing. Thread: reader. Real-time safe: no.
  std::optional<FlightRecord> take();

 private:
  struct Tape {
    std::vector<Sample> samples;  ///< a ring
    std::uint64_t recorded = 0;   ///< ticks since the start of the tape
    Trip trip;
    /// True: the reader owns the tape and the members above, until it sets false again. Release and acquire both ways.
    std::atomic<bool> full{false};
  };

  std::array<Tape, 2> tapes_;
  std::size_t after_;

  // Touched by the writer alone.
  std::size_t writing_ = 0;  ///< index of the tape
  std::size_t left_ = 0;     ///< ticks until the tape is full, counted after the trip
  Trip seen_;                ///< the latched trip at the last tick

  std::size_t reading_ = 0;  ///< Touched by the reader alone: index of the tape that becomes full next; they alternate.
};

}  // namespace tactus::haptics
