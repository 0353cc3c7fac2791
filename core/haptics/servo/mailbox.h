// Passes the newest value from one thread to another without a lock. Carries the orders to the servo.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tactus::haptics {

/// A value with its number. Immutable after posting.
template <typename T>
struct Numbered {
  std::uint64_t number = 0;  ///< from 1, as returned by `post`
  T value;
};

/// One poster, one reader. The reader gets the newest value and never frees memory. The poster frees a value when the
/// reader has taken a newer one, or at once if the reader never took it. So only a few values exist, even if the reader
/// stops. The exchanged slot is the idea of a triple buffer (e.g. Ableton Link's), with pointers instead of copies.
template <typename T>
class Mailbox {
 public:
  Mailbox() = default;
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  /// Posts a value for the reader's next `newest`. Returns its number.
  /// Thread: poster. Real-time safe: no.
  std::uint64_t post(T value) {
    freeWhatIsNotRead();
    held_.emplace_back(new Numbered<T>{++posted_, std::move(value)});
    const Numbered<T>* const untaken = slot_.exchange(held_.back().get(), std::memory_order_release);
    if (untaken != nullptr) drop([untaken](const auto& item) { return item.get() == untaken; });
    return posted_;
  }

  /// Frees the values that the reader no longer uses. `post` does so too. Thread: poster. Real-time safe: no.
  void freeWhatIsNotRead() {
    const std::uint64_t taken = taken_.load(std::memory_order_acquire);
    drop([taken](const auto& item) { return item->number < taken; });
  }

  /// Number of values in memory. Thread: poster. Real-time safe: yes.
  std::size_t held() const noexcept { return held_.size(); }

  /// The newest value, or null before the first. It stays valid until the next call.
  /// Thread: reader. Real-time safe: yes.
  const Numbered<T>* newest() noexcept {
    // The plain load keeps the bus free while no value is posted.
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

  std::vector<std::unique_ptr<const Numbered<T>>> held_;  ///< Touched by the poster alone. Owns all values.
  std::uint64_t posted_ = 0;                              ///< Touched by the poster alone. Number of the last value.

  /// Touched by both threads: the poster puts a value in, the reader takes it out and leaves null. Only the poster
  /// makes it non-null, so a reader that saw a value also gets one. Release and acquire carry the value's content.
  std::atomic<const Numbered<T>*> slot_{nullptr};
  /// Written by the reader, read by the poster: the number of the value in use. The reader no longer uses older values.
  /// Release and acquire order its last read of them before they are freed.
  std::atomic<std::uint64_t> taken_{0};

  const Numbered<T>* current_ = nullptr;  ///< Touched by the reader alone.
};

}  // namespace tactus::haptics
