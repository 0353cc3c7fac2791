#include "app/workbench/device/device_run.h"

#include <utility>

#include "core/haptics/simulated/virtual_device.h"

namespace tactus::workbench {
namespace {

/// More than the ticks between two looks at 60 Hz, with room for a pause of the program.
constexpr std::size_t kMostDrained = 16'384;

}  // namespace

base::Result<std::unique_ptr<DeviceRun>> DeviceRun::begin(devices::OpenedDevice opened, const MakeServoLoop& make_loop,
                                                          haptics::ServoOrders orders,
                                                          std::shared_ptr<haptics::ThermalLedger> thermal) {
  if (auto started = opened.device->start(); !started) return tl::unexpected(started.error());
  // Not make_unique: the constructor is private, so that no run exists whose device has not been started.
  std::unique_ptr<DeviceRun> run(new DeviceRun(std::move(opened), make_loop, std::move(orders), std::move(thermal)));
  run->post();
  run->heartbeat();
  if (auto started = run->loop_->start(); !started) return tl::unexpected(started.error());
  return run;
}

DeviceRun::DeviceRun(devices::OpenedDevice opened, const MakeServoLoop& make_loop, haptics::ServoOrders orders,
                     std::shared_ptr<haptics::ThermalLedger> thermal)
    : thermal_(std::move(thermal)),
      device_(std::move(opened.device)),
      live_hand_(dynamic_cast<haptics::VirtualDevice*>(device_.get())),
      calibration_advice_(std::move(opened.calibration_advice)),
      axis_advice_(std::move(opened.axis_advice)),
      orders_(std::move(orders)),
      servo_(std::make_unique<haptics::Servo>(*device_, thermal_.get())),
      loop_(make_loop(*servo_)),
      drained_(kMostDrained) {
  orders_.axis = opened.axis;
  const bool guard_velocity = orders_.limits.guard_velocity;
  orders_.limits = haptics::LimitSettings::forDevice(device_->info());
  orders_.limits.guard_velocity = guard_velocity;
}

DeviceRun::~DeviceRun() { end(); }

std::uint64_t DeviceRun::post() { return servo_->post(orders_); }

std::span<const haptics::Sample> DeviceRun::drain() { return servo_->drain(drained_); }

void DeviceRun::end() noexcept {
  servo_->stop();
  loop_->stop();
  device_->stop();
}

}  // namespace tactus::workbench
