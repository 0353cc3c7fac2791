#include "tests/vm/servo_run.h"

#include <array>
#include <utility>

#include "core/haptics/hid/hidapi_transport.h"
#include "core/haptics/servo/servo_clock.h"

namespace tactus::vm {

using haptics::Sample;

base::Result<std::unique_ptr<haptics::HidPidDevice>> openDevice(
    const haptics::HidDevice& listed, const std::optional<haptics::DeviceCalibration>& calibration) {
  auto transport = haptics::HidapiTransport::open(listed.path);
  if (!transport) return tl::unexpected(transport.error());
  return haptics::HidPidDevice::open(*std::move(transport), listed.identity, calibration);
}

ServoRun::ServoRun(std::unique_ptr<haptics::HidPidDevice> device, const haptics::DeviceCalibration& calibration)
    : device_(std::move(device)),
      calibration_(calibration),
      servo_(std::make_unique<haptics::Servo>(*device_)),
      thread_(std::make_unique<haptics::ServoThread>(*servo_)) {}

base::Result<std::unique_ptr<ServoRun>> ServoRun::begin(const haptics::HidDevice& listed,
                                                        const haptics::DeviceCalibration& calibration) {
  auto device = openDevice(listed, calibration);
  if (!device) return tl::unexpected(device.error());
  std::unique_ptr<ServoRun> run(new ServoRun(*std::move(device), calibration));
  if (auto started = run->device_->start(); !started) return tl::unexpected(started.error());
  if (auto started = run->thread_->start(); !started) return tl::unexpected(started.error());
  return run;
}

ServoRun::~ServoRun() {
  thread_->stop();
  device_->stop();
}

void ServoRun::pull(double resistance_n) {
  haptics::ServoOrders orders;
  orders.source = haptics::ForceSource::kStimulus;
  orders.armed = true;
  orders.stimulus.number = 1;
  orders.stimulus.force_n = resistance_n;
  orders.axis = haptics::axisOf(calibration_);
  orders.limits = haptics::LimitSettings::forDevice(device_->info());
  orders.limits.fade_in_s = 0.1;  // no person is there to be startled
  servo_->post(std::move(orders));
}

std::vector<Sample> ServoRun::pass(double seconds) {
  std::vector<Sample> samples;
  std::array<Sample, 256> room;
  const std::int64_t end_ns = haptics::monotonicNs() + static_cast<std::int64_t>(seconds * 1e9);
  do {
    haptics::sleepUntil(std::min(end_ns, haptics::monotonicNs() + 50'000'000));
    for (auto got = servo_->drain(room); !got.empty(); got = servo_->drain(room))
      samples.insert(samples.end(), got.begin(), got.end());
  } while (haptics::monotonicNs() < end_ns);
  return samples;
}

}  // namespace tactus::vm
