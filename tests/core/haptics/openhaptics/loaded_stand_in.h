// The stand-in for libHD as a test uses it: loaded the way the program loads the real one.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <memory>

#include "core/haptics/openhaptics/openhaptics_device.h"

#include "tests/core/haptics/openhaptics/stand_in.h"

namespace tactus::haptics {

/// Fresh for each test, with a clock that a step moves by 1 ms.
class WithStandIn : public testing::Test {
 protected:
  void SetUp() override {
    auto loaded = HdLibrary::load(TACTUS_STAND_IN);
    ASSERT_TRUE(loaded) << loaded.error().message();
    library_ = *loaded;
    void* const handle = dlopen(TACTUS_STAND_IN, RTLD_NOW);
    ASSERT_NE(handle, nullptr);
    step_ = reinterpret_cast<stand_in::Step>(dlsym(handle, "standInStep"));
    get_state_ = reinterpret_cast<stand_in::GetState>(dlsym(handle, "standInState"));
    reinterpret_cast<stand_in::Reset>(dlsym(handle, "standInReset"))();
  }

  stand_in::State& standIn() { return *get_state_(); }

  bool step() {
    now_ns_ += 1'000'000;
    return step_();
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(step()) << "the loop ended at step " << i;
  }

  OpenHapticsSettings settings() {
    OpenHapticsSettings settings;
    settings.clock_ns = [this] { return now_ns_; };
    settings.pause = [this] {
      ++pauses_;
      step();
    };
    return settings;
  }

  std::unique_ptr<OpenHapticsDevice> open(OpenHapticsSettings settings) {
    auto device = OpenHapticsDevice::open(library_, std::move(settings));
    EXPECT_TRUE(device) << device.error().message();
    return device ? std::move(*device) : nullptr;
  }
  std::unique_ptr<OpenHapticsDevice> open() { return open(settings()); }

  std::shared_ptr<const HdLibrary> library_;
  std::int64_t now_ns_ = 1'000'000'000;
  int pauses_ = 0;

 private:
  stand_in::Step step_ = nullptr;
  stand_in::GetState get_state_ = nullptr;
};

/// A program that asks for one force and keeps what it saw.
class Asking : public Ticked {
 public:
  explicit Asking(HapticDevice& device, Vector3 asked_n = {}) : force_n(asked_n), device_(&device) {}

  void tick(std::int64_t now_ns) noexcept override {
    ++ticks;
    time_ns = now_ns;
    seen = device_->read(now_ns);
    device_->write(force_n, now_ns);
  }

  Vector3 force_n;
  int ticks = 0;
  std::int64_t time_ns = 0;
  DeviceState seen;

 private:
  HapticDevice* device_;
};

}  // namespace tactus::haptics
