#include "core/haptics/simulated/virtual_device.h"

#include <utility>

namespace tactus::haptics {
namespace {

DeviceInfo describe(const VirtualDeviceSettings& settings) {
  DeviceInfo info;
  info.id = "virtual";
  info.name = "Virtual device (simulated)";
  info.backend = "virtual";
  info.simulated = true;
  info.max_force_n = settings.max_force_n;
  info.continuous_force_n = settings.continuous_force_n;
  if (settings.count_mm > 0) info.count_mm = settings.count_mm;
  info.damping_n_s_mm = 1e-3 * settings.mechanics.damping_n_s_m;
  info.delay_s = settings.delay_s;
  info.friction_in_n = settings.mechanics.dry_friction_n;
  info.friction_out_n = settings.mechanics.dry_friction_n;
  info.hold_s = settings.quiet_after_s;
  info.quiet_after_s = settings.quiet_after_s;
  return info;
}

}  // namespace

base::Result<std::unique_ptr<VirtualDevice>> VirtualDevice::make(VirtualDeviceSettings settings) {
  if (auto checked = check(settings); !checked) return tl::unexpected(std::move(checked.error()));
  return std::unique_ptr<VirtualDevice>(new VirtualDevice(std::move(settings)));
}

VirtualDevice::VirtualDevice(VirtualDeviceSettings settings)
    : settings_(std::move(settings)),
      info_(describe(settings_)),
      live_(settings_.live_time_constant_s, settings_.live_speed_mm_s) {
  if (!settings_.plan) settings_.plan = [this](double) { return live_.next(); };
}

base::Result<void> VirtualDevice::start() {
  live_.place(settings_.start_mm);
  simulation_.emplace(settings_);
  clock_ = {};
  last_ = {};
  written_ns_ = {};
  true_position_mm_.store(settings_.start_mm, std::memory_order_relaxed);
  true_speed_mm_s_.store(0, std::memory_order_relaxed);
  true_force_n_.store(0, std::memory_order_relaxed);
  running_ = true;
  return {};
}

void VirtualDevice::stop() noexcept {
  running_ = false;
  true_force_n_.store(0, std::memory_order_relaxed);
}

DeviceState VirtualDevice::read(std::int64_t now_ns) noexcept {
  if (!running_) return last_;
  simulation_->advance(clock_.at(now_ns));

  // What is not fresh keeps its times: a pause that was left out would make it younger.
  DeviceState state = simulation_->sample();
  state.time_ns = state.number != last_.number ? state.time_ns + clock_.aheadNs() : last_.time_ns;
  state.written_ns = last_.written_ns;
  if (simulation_->writtenNs() != written_ns_) {
    written_ns_ = simulation_->writtenNs();
    state.written_ns = *written_ns_ + clock_.aheadNs();
  }
  last_ = state;
  true_position_mm_.store(simulation_->body().positionMm(), std::memory_order_relaxed);
  true_speed_mm_s_.store(simulation_->body().speedMmS(), std::memory_order_relaxed);
  true_force_n_.store(simulation_->forceInEffectN(), std::memory_order_relaxed);
  return state;
}

void VirtualDevice::write(const Vector3& force_n, std::int64_t now_ns) noexcept {
  if (!running_) return;
  simulation_->push(-dot(force_n, settings_.inwards), clock_.at(now_ns));
}

}  // namespace tactus::haptics
