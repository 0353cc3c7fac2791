// What the devices with threads of their own share: the exchange of the newest value with the servo, and their start.
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <pthread.h>
#include <thread>
#include <utility>

namespace tactus::haptics {

// Passes copies of the newest value from one thread to another. Neither thread waits or allocates.

/// A triple buffer: the writer owns one slot, the reader owns one, and both exchange the third. One writer, one reader.
template <typename T>
class NewestValue {
 public:
  /// Thread: writer. Real-time safe: yes.
  void put(const T& value) noexcept {
    slots_[back_] = value;
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }

  /// Whether `take` would return a new value. Thread: reader. Real-time safe: yes.
  bool fresh() const noexcept { return (middle_.load(std::memory_order_relaxed) & kFresh) != 0; }

  /// The newest value; a default value before the first one. Valid until the next call.
  /// Thread: reader. Real-time safe: yes.
  const T& take() noexcept {
    if (fresh()) front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;

  alignas(64) std::uint8_t back_ = 0;                ///< Touched by the writer alone.
  alignas(64) std::atomic<std::uint8_t> middle_{1};  ///< Touched by both; release and acquire carry the slot's content.
  alignas(64) std::uint8_t front_ = 2;               ///< Touched by the reader alone.
  std::array<T, 3> slots_{};
};

// A thread of a device.

/// Signals are for the threads of the program: here they would interrupt a poll.
template <class Work>
std::thread startDeviceThread(Work work) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread thread(std::move(work));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

}  // namespace tactus::haptics
