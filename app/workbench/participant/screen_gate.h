// When input counts on a screen that has just opened: a key that is still held, a double click, or a click that was
// meant for the screen before never answers it.
#pragma once

#include <cstdint>

namespace tactus::workbench {

/// A screen takes input once its first frame is painted, every key, button and touch has been up since, and 300 ms have
/// passed. Times: ns of one monotonic clock. Plain state. Thread: any.
class ScreenGate {
 public:
  static constexpr std::int64_t kSettleNs = 300'000'000;

  /// Another screen or another question is about to be shown.
  void close() { painted_ = false; }
  /// Its first frame is on the screen. Later frames change nothing.
  void painted(std::int64_t now_ns);
  /// Whether a key, a button or a touch is down.
  void held(bool held, std::int64_t now_ns);

  bool takesInput(std::int64_t now_ns) const;
  /// The same for the hand on the device, which may hold it all the time.
  bool isSettled(std::int64_t now_ns) const { return painted_ && now_ns - painted_ns_ >= kSettleNs; }
  /// Of the first painted frame; response times count from here.
  std::int64_t paintedNs() const { return painted_ns_; }

 private:
  bool painted_ = false;
  bool held_ = false;
  bool let_go_ = false;  ///< nothing was down at one moment since the first frame
  std::int64_t painted_ns_ = 0;
  std::int64_t free_ns_ = 0;  ///< of that moment
};

}  // namespace tactus::workbench
