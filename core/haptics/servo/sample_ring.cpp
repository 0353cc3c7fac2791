#include "core/haptics/servo/sample_ring.h"

#include <algorithm>

#include "core/base/check.h"

namespace tactus::haptics {

SampleRing::SampleRing(std::size_t capacity) : places_(capacity) { TACTUS_CHECK(capacity > 0); }

void SampleRing::push(const Sample& sample) noexcept {
  const std::uint64_t written = written_.load(std::memory_order_relaxed);
  if (written - seen_read_ == places_.size()) seen_read_ = read_.load(std::memory_order_acquire);
  if (written - seen_read_ == places_.size()) {
    dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    return;
  }
  places_[written % places_.size()] = sample;
  written_.store(written + 1, std::memory_order_release);
}

std::span<Sample> SampleRing::drain(std::span<Sample> room) noexcept {
  const std::uint64_t read = read_.load(std::memory_order_relaxed);
  const std::uint64_t there = written_.load(std::memory_order_acquire) - read;
  const std::size_t count = std::min<std::size_t>(there, room.size());
  for (std::size_t i = 0; i < count; ++i) room[i] = places_[(read + i) % places_.size()];
  read_.store(read + count, std::memory_order_release);
  return room.first(count);
}

}  // namespace tactus::haptics
