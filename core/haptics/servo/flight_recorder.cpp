#include "core/haptics/servo/flight_recorder.h"

#include <algorithm>

namespace tactus::haptics {

FlightRecorder::FlightRecorder(std::size_t before, std::size_t after) : after_(after) {
  for (Tape& tape : tapes_) tape.samples.resize(before + 1 + after);
}

void FlightRecorder::record(const Sample& sample, const Trip& latched) noexcept {
  // Cause and time tell trips apart; a value may be NaN.
  const bool tripped = latched && (latched.cause != seen_.cause || latched.time_ns != seen_.time_ns);
  seen_ = latched;
  Tape& tape = tapes_[writing_];
  if (tape.full.load(std::memory_order_acquire)) return;

  tape.samples[tape.recorded++ % tape.samples.size()] = sample;
  const bool after_trip = static_cast<bool>(tape.trip);
  if (!after_trip && tripped) {
    tape.trip = latched;
    left_ = after_;
  } else if (after_trip) {
    --left_;
  }
  if (!tape.trip || left_ > 0) return;
  tape.full.store(true, std::memory_order_release);
  writing_ = 1 - writing_;
}

std::optional<FlightRecord> FlightRecorder::take() {
  Tape& tape = tapes_[reading_];
  if (!tape.full.load(std::memory_order_acquire)) return std::nullopt;
  FlightRecord record{tape.trip, {}};
  const std::uint64_t size = tape.samples.size();
  const std::uint64_t first = tape.recorded - std::min(tape.recorded, size);
  for (std::uint64_t i = first; i < tape.recorded; ++i) record.samples.push_back(tape.samples[i % size]);
  tape.recorded = 0;
  tape.trip = {};
  tape.full.store(false, std::memory_order_release);
  reading_ = 1 - reading_;
  return record;
}

}  // namespace tactus::haptics
