// Forces on their way to a device. Each has its own arrival time; the newest arrived force counts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tactus::haptics {

struct ForceOnTheWay {
  double force_n = 0;
  std::int64_t arrives_ns = 0;
};

/// First in, first out, in order of arrival. If the queue is full, a new force replaces the last one. Real-time safe:
/// yes.
class ForceQueue {
 public:
  /// `arrives_ns`: not less than that of the previous force.
  void push(ForceOnTheWay force) noexcept {
    if (count_ == kRoom) --count_;
    waiting_[(first_ + count_++) % kRoom] = force;
  }

  /// The newest force that has arrived by `now_ns`. Removes it and all earlier ones from the queue.
  std::optional<ForceOnTheWay> take(std::int64_t now_ns) noexcept {
    std::optional<ForceOnTheWay> newest;
    while (count_ > 0 && waiting_[first_].arrives_ns <= now_ns) {
      newest = waiting_[first_];
      first_ = (first_ + 1) % kRoom;
      --count_;
    }
    return newest;
  }

 private:
  static constexpr std::size_t kRoom = 512;  ///< 0.1 s of delay at 5 kHz
  std::array<ForceOnTheWay, kRoom> waiting_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace tactus::haptics
