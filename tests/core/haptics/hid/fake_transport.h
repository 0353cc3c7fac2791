// The way to a FakePidDevice inside this process: with a virtual clock, and with everything that can go wrong with USB.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "core/haptics/hid/hidapi_transport.h"

#include "tests/support/fake_pid_device.h"

namespace tactus::haptics {

using Bytes = std::vector<std::uint8_t>;

/// What went over the wire to the device.
struct Sent {
  std::int64_t time_ns = 0;
  bool feature = false;
  Bytes report;
};

/// The device and its cable, shared by the transport and the test. Thread-safe.
class FakeLine {
 public:
  explicit FakeLine(support::PidModel model) : device_(model), descriptor_(support::reportDescriptor(model)) {}

  std::atomic<std::int64_t> now_ns{1'000'000'000};
  std::atomic<std::int64_t> write_takes_ns{0};  ///< the clock advances by this at every write
  std::atomic<bool> writes_fail{false};
  std::atomic<bool> unplugged{false};
  std::atomic<std::int64_t> unanswered_takes_ns{0};  ///< a GET_REPORT gets no answer: the clock advances by this
  std::atomic<int> questions{0};                     ///< GET_REPORTs so far

  /// Writes that begin from now on wait until `resume`, then get through.
  void stall();
  void resume();
  bool writeWaits() const { return waiting_.load(); }

  /// An input report that waits to be read.
  void queue(Bytes report);
  /// Input reports that are not read yet.
  std::size_t unread() const;

  std::vector<Sent> sent() const;
  void forget();
  support::FakePidDevice device() const;
  template <class Work>
  auto with(Work work) {
    const std::lock_guard lock(mutex_);
    return work(device_);
  }

 private:
  friend class FakeTransport;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  support::FakePidDevice device_;
  Bytes descriptor_;
  std::deque<Bytes> inputs_;
  std::vector<Sent> sent_;
  bool stalled_ = false;
  std::atomic<bool> waiting_{false};
};

class FakeTransport final : public HidTransport {
 public:
  explicit FakeTransport(std::shared_ptr<FakeLine> line) : line_(std::move(line)) {}

  base::Result<Bytes> descriptor() override { return line_->descriptor_; }
  base::Result<void> write(std::span<const std::uint8_t> report) override;
  base::Result<void> sendFeature(std::span<const std::uint8_t> report) override;
  base::Result<std::size_t> getFeature(std::span<std::uint8_t> report) override;
  base::Result<std::size_t> readTimeout(std::span<std::uint8_t> room, int timeout_ms) override;

 private:
  std::shared_ptr<FakeLine> line_;
};

}  // namespace tactus::haptics
