#include "core/haptics/servo/servo.h"

#include <algorithm>
#include <future>
#include <system_error>
#include <utility>

#include "core/base/check.h"

namespace tactus::haptics {

ServoThread::ServoThread(Servo& servo, ServoThreadSettings settings) : servo_(servo), settings_(settings) {}

ServoThread::~ServoThread() { stop(); }

base::Result<void> ServoThread::start() {
  if (state_.running) return {};
  state_ = {};
  if (DeviceLoop* const driver = servo_.device().ownLoop(); driver != nullptr) {
    auto ticks = std::make_unique<TimedTicks>(servo_, settings_.period_ns);
    if (auto started = driver->run(*ticks); !started) return started;
    driver_ticks_ = std::move(ticks);
    state_.own_loop = true;
  } else {
    ending_.store(false, std::memory_order_relaxed);
    std::promise<void> ready;
    std::future<void> is_ready = ready.get_future();
    try {
      thread_ = std::thread([this, ready = std::move(ready)]() mutable {
        state_.real_time = becomeRealTime(settings_.real_time);
        ready.set_value();
        loop();
      });
    } catch (const std::system_error& error) {
      return base::fail(base::ErrorCode::kLimit, "servo thread", error.code().message(), "a thread");
    }
    is_ready.wait();
  }
  state_.running = true;
  return {};
}

void ServoThread::stop() noexcept {
  if (!state_.running) return;
  if (driver_ticks_ != nullptr) {
    servo_.device().ownLoop()->end();
    driver_ticks_.reset();
    servo_.pause();
  } else {
    ending_.store(true, std::memory_order_relaxed);
    thread_.join();
  }
  state_.running = false;
}

void ServoThread::loop() noexcept {
  std::int64_t due_ns = monotonicNs() + settings_.period_ns;
  while (!ending_.load(std::memory_order_relaxed)) {
    sleepUntil(due_ns);
    const std::int64_t began_ns = monotonicNs();
    servo_.tick(began_ns);
    servo_.timed(began_ns - due_ns, monotonicNs() - began_ns, settings_.period_ns);
    due_ns = nextDueNs(due_ns, began_ns, settings_.period_ns);
  }
  servo_.release(monotonicNs());
}

void ServoThread::TimedTicks::tick(std::int64_t now_ns) noexcept {
  const std::int64_t late_ns = any_ ? now_ns - last_ns_ - period_ns_ : 0;
  any_ = true;
  last_ns_ = now_ns;
  const std::int64_t began_ns = monotonicNs();
  servo_.tick(now_ns);
  servo_.timed(late_ns, monotonicNs() - began_ns, period_ns_);
}

FlightRecorder::FlightRecorder(std::size_t before, std::size_t after) : after_(after) {
  for (Tape& tape : tapes_) tape.samples.resize(before + 1 + after);
}

void FlightRecorder::record(const Sample& sample, const Trip& latched) noexcept {
  // Cause and time tell trips apart; a value may be NaN.
  const bool tripped = latched && (latched.cause != seen_.cause || latched.time_ns != seen_.time_ns);
  seen_ = latched;
  Tape& tape = tapes_[writing_];
  if (tape.full.load(std::memory_order_acquire)) return;

  tape.samples[tape.recorded++ % tape.samples.size()] = sample;
  const bool after_trip = static_cast<bool>(tape.trip);
  if (!after_trip && tripped) {
    tape.trip = latched;
    left_ = after_;
  } else if (after_trip) {
    --left_;
  }
  if (!tape.trip || left_ > 0) return;
  tape.full.store(true, std::memory_order_release);
  writing_ = 1 - writing_;
}

std::optional<FlightRecord> FlightRecorder::take() {
  Tape& tape = tapes_[reading_];
  if (!tape.full.load(std::memory_order_acquire)) return std::nullopt;
  FlightRecord record{tape.trip, {}};
  const std::uint64_t size = tape.samples.size();
  const std::uint64_t first = tape.recorded - std::min(tape.recorded, size);
  for (std::uint64_t i = first; i < tape.recorded; ++i) record.samples.push_back(tape.samples[i % size]);
  tape.recorded = 0;
  tape.trip = {};
  tape.full.store(false, std::memory_order_release);
  reading_ = 1 - reading_;
  return record;
}

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

Servo::Servo(HapticDevice& device, ThermalLedger* ledger)
    : device_(device),
      ledger_(ledger),
      core_(device.info(), ledger != nullptr ? ledger->of(device.info().id) : ThermalBudget{}) {}

Servo::~Servo() {
  if (ledger_ != nullptr) ledger_->keep(device_.info().id, core_.thermal());
}

void Servo::tick(std::int64_t now_ns) noexcept {
  meter_.begin(now_ns);
  const DeviceState state = device_.read(now_ns);
  if (state.number > 0) meter_.readAge(now_ns - state.time_ns);
  if (state.written_ns != 0) meter_.writeAge(now_ns - state.written_ns);

  const Numbered<Posted>* const item = mailbox_.newest();
  const Posted& posted = item == nullptr ? no_orders_ : item->value;
  if (item != nullptr && item->number != orders_) {
    orders_ = item->number;
    meter_.ordersTaken(meter_.ticks() - posted.at_tick);
  }

  ServoTick input;
  input.now_ns = now_ns;
  input.device = state;
  input.orders = &posted.orders;
  input.orders_number = orders_;
  input.pedal = pedal_.load(std::memory_order_relaxed);
  input.stop = stop_.load(std::memory_order_relaxed) && stop_.exchange(false, std::memory_order_relaxed);
  input.heartbeat_ns = heartbeat_ns_.load(std::memory_order_relaxed);
  const Sample sample = core_.tick(input);

  device_.write(core_.deviceForce(sample), now_ns);
  ring_.push(sample);
  recorder_.record(sample, core_.tripped());
  meter_.restarts(core_.restarts());
  publish();
}

std::uint64_t Servo::post(ServoOrders orders) {
  TACTUS_CHECK(wellFormed(orders.limits) && wellFormed(orders.enable));
  return mailbox_.post({std::move(orders), meter_.ticks()});
}

void Servo::publish() noexcept {
  const render::SceneCounters& counters = core_.counters();
  thermal_share_.store(core_.thermalShare(), std::memory_order_relaxed);
  scene_ticks_.store(counters.ticks, std::memory_order_relaxed);
  scene_asked_.store(counters.asked, std::memory_order_relaxed);
  scene_released_.store(counters.released, std::memory_order_relaxed);
  scene_unchanged_.store(counters.unchanged, std::memory_order_relaxed);
}

render::SceneCounters Servo::sceneCounters() const noexcept {
  render::SceneCounters counters;
  counters.ticks = scene_ticks_.load(std::memory_order_relaxed);
  counters.asked = scene_asked_.load(std::memory_order_relaxed);
  counters.released = scene_released_.load(std::memory_order_relaxed);
  counters.unchanged = scene_unchanged_.load(std::memory_order_relaxed);
  return counters;
}

}  // namespace tactus::haptics
