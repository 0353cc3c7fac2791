// All samples from the servo to whoever records and draws them, without a lock.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/haptics/servo/sample.h"

namespace tactus::haptics {

/// One writer, one reader, oldest first. Where the reader falls behind by the whole ring, new samples are dropped and
/// counted; those in the ring are never overwritten.
class SampleRing {
 public:
  /// 16 s at 1 kHz: longer than a program that stores on a slow disk keeps its reader waiting.
  static constexpr std::size_t kDefaultCapacity = 16384;

  /// `capacity` > 0: how many samples fit. All memory is taken, and touched, here.
  explicit SampleRing(std::size_t capacity = kDefaultCapacity);

  /// Thread: writer. Real-time safe: yes.
  void push(const Sample& sample) noexcept;

  /// Moves the oldest samples into `room`, as many as fit; returns those filled.
  /// Thread: reader. Real-time safe: yes.
  std::span<Sample> drain(std::span<Sample> room) noexcept;

  /// Samples that found no room so far. Thread: any. Real-time safe: yes.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }
  std::size_t capacity() const noexcept { return places_.size(); }

 private:
  /// Written by the writer with release after the sample, read by the reader with acquire. Counts for ever.
  alignas(64) std::atomic<std::uint64_t> written_{0};
  std::atomic<std::uint64_t> dropped_{0};  ///< Written by the writer alone.
  std::uint64_t seen_read_ = 0;            ///< Touched by the writer alone: `read_` as it last looked.
  /// Places between `read_` and `written_` (modulo the size) belong to the reader, all others to the writer.
  std::vector<Sample> places_;

  /// Written by the reader with release after it has copied, read by the writer with acquire. Counts for ever.
  alignas(64) std::atomic<std::uint64_t> read_{0};
};

}  // namespace tactus::haptics
