// Hands the newest value from one thread to another without a lock: orders to the servo.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tactus::haptics {

/// A value with its number. Immutable once posted.
template <typename T>
struct Letter {
  std::uint64_t number = 0;  ///< from 1, as `post` returned it
  T value;
};

/// One poster, one reader. The reader gets the newest value and never frees anything; a value is freed by the poster
/// once the reader has taken a newer one, or at once if it was never taken. So no more than a few values exist, even
/// when nobody reads. The idea of a slot that is exchanged is that of a triple buffer (e.g. Ableton Link's), with
/// pointers in the place of copies.
template <typename T>
class Mailbox {
 public:
  Mailbox() = default;
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  /// The reader's next `newest` returns this value. Returns its number.
  /// Thread: poster. Real-time safe: no.
  std::uint64_t post(T value) {
    freeWhatIsNotRead();
    held_.emplace_back(new Letter<T>{++posted_, std::move(value)});
    const Letter<T>* const untaken = slot_.exchange(held_.back().get(), std::memory_order_release);
    if (untaken != nullptr) drop([untaken](const auto& letter) { return letter.get() == untaken; });
    return posted_;
  }

  /// Frees what the reader has acknowledged; `post` does so too. Thread: poster. Real-time safe: no.
  void freeWhatIsNotRead() {
    const std::uint64_t taken = taken_.load(std::memory_order_acquire);
    drop([taken](const auto& letter) { return letter->number < taken; });
  }

  /// How many values exist now. Thread: poster. Real-time safe: yes.
  std::size_t held() const noexcept { return held_.size(); }

  /// The newest value, or null before the first. It stays valid until the next call.
  /// Thread: reader. Real-time safe: yes.
  const Letter<T>* newest() noexcept {
    // The plain look keeps the bus free while nothing is posted.
    if (slot_.load(std::memory_order_relaxed) == nullptr) return current_;
    current_ = slot_.exchange(nullptr, std::memory_order_acquire);
    taken_.store(current_->number, std::memory_order_release);
    return current_;
  }

 private:
  template <typename Unwanted>
  void drop(Unwanted unwanted) {
    held_.erase(std::remove_if(held_.begin(), held_.end(), unwanted), held_.end());
  }

  std::vector<std::unique_ptr<const Letter<T>>> held_;  ///< Touched by the poster alone. Owns all that may be read.
  std::uint64_t posted_ = 0;                            ///< Touched by the poster alone. Number of the last value.

  /// Touched by both: the poster puts a value in, the reader takes it out and leaves null. Only the poster makes it
  /// other than null, so what the reader saw there it also gets. Release and acquire carry the value's content.
  std::atomic<const Letter<T>*> slot_{nullptr};
  /// Written by the reader, read by the poster: the number of the value in use. All older ones are not read any more;
  /// release and acquire order the last read of them before their end.
  std::atomic<std::uint64_t> taken_{0};

  const Letter<T>* current_ = nullptr;  ///< Touched by the reader alone.
};

}  // namespace tactus::haptics
