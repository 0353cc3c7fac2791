// Passes all samples from the servo to a recording or drawing reader, without a lock.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/haptics/servo/sample.h"

namespace tactus::haptics {

/// One writer, one reader, oldest sample first. If the ring is full, new samples are dropped and counted. Samples in
/// the ring are never overwritten.
class SampleRing {
 public:
  /// 16 s at 1 kHz: longer than the reader waits for a slow disk.
  static constexpr std::size_t kDefaultCapacity = 16384;

  /// `capacity`: > 0, number of samples. The constructor allocates and touches all memory.
  explicit SampleRing(std::size_t capacity = kDefaultCapacity);

  /// Thread: writer. Real-time safe: yes.
  void push(const Sample& sample) noexcept;

  /// Moves the oldest samples into `room`, as many as fit. Returns the filled part.
  /// Thread: reader. Real-time safe: yes.
  std::span<Sample> drain(std::span<Sample> room) noexcept;

  /// Number of samples dropped because the ring was full. Thread: any. Real-time safe: yes.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }
  std::size_t capacity() const noexcept { return places_.size(); }

 private:
  /// Written by the writer with release after the sample; read by the reader with acquire. Never wraps in practice.
  alignas(64) std::atomic<std::uint64_t> written_{0};
  std::atomic<std::uint64_t> dropped_{0};  ///< Written by the writer alone.
  std::uint64_t seen_read_ = 0;            ///< Touched by the writer alone: `read_` at the last check.
  /// Places from `read_` to `written_` (modulo the size) belong to the reader, all others to the writer.
  std::vector<Sample> places_;

  /// Written by the reader with release after the copy; read by the writer with acquire. Never wraps in practice.
  alignas(64) std::atomic<std::uint64_t> read_{0};
};

}  // namespace tactus::haptics
