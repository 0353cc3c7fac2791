#include "core/haptics/servo/servo.h"

#include <utility>

#include "core/base/check.h"

namespace tactus::haptics {

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

  const Letter<Posted>* const letter = mailbox_.newest();
  const Posted& posted = letter == nullptr ? no_orders_ : letter->value;
  if (letter != nullptr && letter->number != orders_) {
    orders_ = letter->number;
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

  device_.write(core_.axis().forceOnHand(sample.force_n), now_ns);
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
