// With the scheduler of the stand-in in a thread of its own, as the driver has it.
#include <atomic>
#include <chrono>
#include <thread>

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"
#include "tests/support/comes_true.h"

namespace tactus::haptics {
namespace {

using support::comesTrue;

class Counting : public Ticked {
 public:
  explicit Counting(HapticDevice& device) : device_(&device) {}
  void tick(std::int64_t now_ns) noexcept override {
    const DeviceState state = device_->read(now_ns);
    if (state.time_ns != now_ns || state.number <= last_) ++wrong;
    last_ = state.number;
    device_->write({0, 0, 0.25}, now_ns);
    ticks.fetch_add(1, std::memory_order_release);
  }
  std::atomic<int> ticks{0};
  int wrong = 0;

 private:
  HapticDevice* device_;
  std::uint64_t last_ = 0;
};

TEST_F(WithStandIn, TheDriversThreadTicksTheProgramUntilItIsEnded) {
  standIn().threaded = true;
  const auto device = open(OpenHapticsSettings{});
  ASSERT_TRUE(device);
  ASSERT_TRUE(device->start());
  Counting program(*device);
  ASSERT_TRUE(device->ownLoop()->run(program));
  EXPECT_TRUE(comesTrue([&] { return program.ticks.load(std::memory_order_acquire) >= 20; }));
  device->ownLoop()->end();
  const int at_end = program.ticks;
  const int frames = standIn().frames;
  EXPECT_TRUE(comesTrue([&] { return standIn().frames.load(std::memory_order_acquire) >= frames + 5; }));
  EXPECT_EQ(program.ticks, at_end);
  device->stop();
  EXPECT_EQ(program.wrong, 0);
  EXPECT_EQ(standIn().largest_force_n, 0.25);
  EXPECT_EQ(standIn().force_n[2], 0);
}

TEST_F(WithStandIn, ProgramsTakeTurnsWhileTheThreadRuns) {
  standIn().threaded = true;
  const auto device = open(OpenHapticsSettings{});
  ASSERT_TRUE(device);
  ASSERT_TRUE(device->start());
  for (int turn = 0; turn < 10; ++turn) {
    auto program = std::make_unique<Counting>(*device);
    ASSERT_TRUE(device->ownLoop()->run(*program));
    EXPECT_TRUE(comesTrue([&] { return program->ticks.load(std::memory_order_acquire) >= 2; }));
    device->ownLoop()->end();
    EXPECT_EQ(program->wrong, 0);
  }
}

}  // namespace
}  // namespace tactus::haptics
