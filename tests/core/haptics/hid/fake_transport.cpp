#include "tests/core/haptics/hid/fake_transport.h"

#include <algorithm>
#include <chrono>

namespace tactus::haptics {
namespace {

tl::unexpected<base::Error> broken(const char* what) {
  return base::fail(base::ErrorCode::kIo, what, "a broken line", "a device");
}

}  // namespace

void FakeLine::stall() {
  const std::lock_guard lock(mutex_);
  stalled_ = true;
}

void FakeLine::resume() {
  {
    const std::lock_guard lock(mutex_);
    stalled_ = false;
  }
  changed_.notify_all();
}

void FakeLine::queue(Bytes report) {
  {
    const std::lock_guard lock(mutex_);
    inputs_.push_back(std::move(report));
  }
  changed_.notify_all();
}

std::size_t FakeLine::unread() const {
  const std::lock_guard lock(mutex_);
  return inputs_.size();
}

std::vector<Sent> FakeLine::sent() const {
  const std::lock_guard lock(mutex_);
  return sent_;
}

void FakeLine::forget() {
  const std::lock_guard lock(mutex_);
  sent_.clear();
}

support::FakePidDevice FakeLine::device() const {
  const std::lock_guard lock(mutex_);
  return device_;
}

base::Result<void> FakeTransport::write(std::span<const std::uint8_t> report) {
  std::unique_lock lock(line_->mutex_);
  line_->waiting_ = line_->stalled_;
  line_->changed_.wait(lock, [&] { return !line_->stalled_; });
  line_->waiting_ = false;
  line_->now_ns += line_->write_takes_ns.load();
  if (line_->writes_fail || line_->unplugged) return broken("output report");
  line_->device_.output(report, line_->now_ns);
  line_->sent_.push_back({line_->now_ns, false, Bytes(report.begin(), report.end())});
  return {};
}

base::Result<void> FakeTransport::sendFeature(std::span<const std::uint8_t> report) {
  const std::lock_guard lock(line_->mutex_);
  if (line_->unplugged || !line_->device_.setFeature(report, line_->now_ns)) return broken("feature report");
  line_->sent_.push_back({line_->now_ns, true, Bytes(report.begin(), report.end())});
  return {};
}

base::Result<std::size_t> FakeTransport::getFeature(std::span<std::uint8_t> report) {
  const std::lock_guard lock(line_->mutex_);
  ++line_->questions;
  line_->now_ns += line_->unanswered_takes_ns.load();
  if (line_->unanswered_takes_ns > 0) return broken("feature report");
  const Bytes answer = line_->device_.getFeature(report[0]);
  if (line_->unplugged || answer.empty()) return broken("feature report");
  const std::size_t length = std::min(answer.size(), report.size());
  std::copy_n(answer.begin(), length, report.begin());
  return length;
}

base::Result<std::size_t> FakeTransport::readTimeout(std::span<std::uint8_t> room, int timeout_ms) {
  std::unique_lock lock(line_->mutex_);
  line_->changed_.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                           [&] { return !line_->inputs_.empty() || line_->unplugged; });
  if (line_->unplugged) return broken("input report");
  if (line_->inputs_.empty()) return std::size_t{0};
  const Bytes report = std::move(line_->inputs_.front());
  line_->inputs_.pop_front();
  const std::size_t length = std::min(report.size(), room.size());
  std::copy_n(report.begin(), length, room.begin());
  return length;
}

}  // namespace tactus::haptics
