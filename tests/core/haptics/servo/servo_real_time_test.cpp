// Nothing reachable from a tick allocates, locks, waits, reads or writes files, or throws.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "core/haptics/servo/servo.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/scripted_device.h"
#include "tests/support/ngt_model.h"
#include "tests/support/real_time_trap.h"
#include "tests/support/system_call_trap.h"

namespace tactus::haptics {
namespace {

/// Four experts, of which three have weights and rules of their own.
fuzzy::ForceModel fourExperts() {
  fuzzy::ForceModel model = support::s4FiveRegions();
  const fuzzy::Expert one = model.experts[0];
  for (int i = 1; i < 4; ++i) {
    model.experts.push_back(one);
    model.experts.back().id = "E" + std::to_string(i);
    model.experts.back().weight = 1 + i;
    model.experts.back().rules[static_cast<std::size_t>(i)].weight = 0.5;
  }
  return model;
}

std::shared_ptr<const ServoScene> scene(const fuzzy::ForceModel& model, double lubrication) {
  auto made = ServoScene::make(model, {{"lubrication", lubrication}, {"neck_flexion", 45}});
  EXPECT_TRUE(made.has_value()) << (made ? "" : made.error().message());
  return made ? *made : nullptr;
}

/// A servo in virtual time whose every tick happens with the trap armed. What the ticks showed is kept outside of it.
class TrappedServo : public testing::Test {
 protected:
  void tick() {
    now_ns_ += kTickNs;
    support::RealTimeTrap trap;
    servo_.tick(now_ns_);
    trap.disarm();
    if (trap.hits() > 0 && hits_ == 0) first_ = trap.first();
    hits_ += trap.hits();
    Sample sample;
    for (const Sample& drained : servo_.drain({&sample, 1})) {
      sources_.insert(drained.source);
      phases_.insert(drained.phase);
      trips_.insert(drained.trip);
      limited_ |= drained.limited;
      largest_n_ = std::max(largest_n_, drained.force_n);
    }
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }

  /// Trips end with the hand letting go, disarmed, and armed again.
  void rearm() {
    device_.pressed = false;
    device_.fault = DeviceFault::kNone;
    device_.silent = false;
    device_.stuck = false;
    device_.position_mm = 0;
    orders_.armed = false;
    servo_.post(orders_);
    run(300);
    orders_.armed = true;
    servo_.post(orders_);
    run(50);
    device_.pressed = true;
    run(1200);
  }

  /// In and out between 0 and `reach_mm` at `speed_mm_s`; `each` is called before every tick.
  template <typename Each>
  void stroke(double reach_mm, double speed_mm_s, Each each) {
    const double step_mm = speed_mm_s * 1e-3;
    const int steps = static_cast<int>(reach_mm / step_mm);
    for (int i = 0; i < 2 * steps; ++i) {
      each();
      device_.position_mm = device_.position_mm + (i < steps ? step_mm : -step_mm);
      tick();
    }
  }

  void TearDown() override { EXPECT_EQ(hits_, 0) << "the first was " << first_; }

  std::int64_t now_ns_ = 5'000'000'000;
  ScriptedDevice device_;
  Servo servo_{device_};
  ServoOrders orders_;
  int hits_ = 0;
  std::string first_;
  std::set<ForceSource> sources_;
  std::set<render::Phase> phases_;
  std::set<TripCause> trips_;
  std::uint32_t limited_ = 0;
  double largest_n_ = 0;
};

TEST_F(TrappedServo, OffAndFree) {
  run(100);
  orders_.source = ForceSource::kFree;
  rearm();
  stroke(60, 300, [] {});
  EXPECT_EQ(sources_, (std::set{ForceSource::kOff, ForceSource::kFree}));
}

TEST_F(TrappedServo, StimuliUpToEveryLimit) {
  orders_.source = ForceSource::kStimulus;
  orders_.stimulus = {1, 0.5, 0.15, 0.4, 5.0};
  rearm();
  run(1000);
  orders_.stimulus = {2, 5, 0.01, {}, {}};  // above the cap and faster than the slew
  servo_.post(orders_);
  run(3000);
  orders_.stimulus = {3, 1.5, 0.15, {}, {}};  // above the continuous rating
  servo_.post(orders_);
  run(70'000);
  EXPECT_NE(limited_ & kLimitedByCap, 0U);
  EXPECT_NE(limited_ & kLimitedBySlew, 0U);
  EXPECT_NE(limited_ & kLimitedByFadeIn, 0U);
  EXPECT_NE(limited_ & kLimitedByRelease, 0U);
  EXPECT_GT(largest_n_, 1);
}

TEST_F(TrappedServo, InsertionWithModelsSwappedWhileTheTubeSlides) {
  const fuzzy::ForceModel team = fourExperts();
  const std::vector<std::shared_ptr<const ServoScene>> scenes = {
      scene(team, 0.9), scene(team, 0.5), scene(support::s4AsPrinted(), 0.1), scene(support::s4Shifted(), 0.9)};
  orders_.source = ForceSource::kInsertion;
  orders_.scene = scenes[0];
  rearm();
  int ticks = 0;
  for (int strokes = 0; strokes < 4; ++strokes) {
    orders_.placement = static_cast<std::uint64_t>(strokes);
    orders_.start_depth_mm = 40 * strokes;
    stroke(60, 80, [&] {
      if (++ticks % 37 != 0) return;
      orders_.scene = scenes[static_cast<std::size_t>(ticks / 37) % scenes.size()];
      servo_.post(orders_);
    });
    device_.pressed = false;
    run(100);
    device_.pressed = true;
    run(100);
  }
  EXPECT_EQ(phases_.size(), 4U) << "released, stuck, sliding in and out";
  EXPECT_GT(largest_n_, 0.1);
  EXPECT_GT(servo_.sceneCounters().asked, 500U);
}

TEST_F(TrappedServo, EveryTrip) {
  orders_.source = ForceSource::kInsertion;
  orders_.scene = scene(support::s4FiveRegions(), 0.9);
  const auto leap = [&](double mm_per_tick) {
    for (int i = 0; i < 40; ++i) {
      device_.position_mm = device_.position_mm + mm_per_tick;
      tick();
    }
  };
  rearm();
  servo_.stop();
  run(10);
  rearm();
  leap(1.5);
  rearm();
  leap(-1.5);
  rearm();
  device_.position_mm = std::numeric_limits<double>::quiet_NaN();
  run(10);
  rearm();
  device_.silent = true;
  run(150);
  rearm();
  device_.stuck = true;
  run(150);
  rearm();
  device_.fault = DeviceFault::kLost;
  run(10);
  rearm();
  device_.fault = DeviceFault::kWarmMotors;
  run(10);
  rearm();
  now_ns_ += 200 * kTickNs;
  run(10);
  rearm();
  servo_.heartbeat(now_ns_);
  run(700);
  for (const TripCause cause : {TripCause::kStopped, TripCause::kTooFastInwards, TripCause::kTooFastOutwards,
                                TripCause::kPositionNotFinite, TripCause::kDeviceSilent, TripCause::kWriteStuck,
                                TripCause::kDeviceLost, TripCause::kDeviceFault, TripCause::kServoLate})
    EXPECT_TRUE(trips_.contains(cause)) << describe(cause);
  EXPECT_NE(limited_ & kLimitedByStaleDevice, 0U);
  EXPECT_NE(limited_ & kLimitedByGui, 0U);
  EXPECT_NE(limited_ & kLimitedByTrip, 0U);
  EXPECT_TRUE(servo_.takeFlightRecord().has_value());
}

TEST_F(TrappedServo, AFullRing) {
  for (std::size_t i = 0; i < SampleRing::kDefaultCapacity + 100; ++i) {
    now_ns_ += kTickNs;
    const support::RealTimeTrap trap;
    servo_.tick(now_ns_);
  }
  std::vector<Sample> room(SampleRing::kDefaultCapacity + 1);
  const std::uint64_t last = servo_.drain(room).back().tick;
  servo_.tick(now_ns_ += kTickNs);
  EXPECT_EQ(servo_.drain(room).front().tick, last + 1 + 100);
}

TEST(ServoUnderTheKernelsEyes, MakesNoSystemCallWhileAnotherThreadPosts) {
  ScriptedDevice device;
  Servo servo(device);
  ServoOrders orders;
  orders.source = ForceSource::kInsertion;
  orders.armed = true;
  const auto one = scene(fourExperts(), 0.9);
  const auto other = scene(support::s4AsPrinted(), 0.1);
  std::atomic<bool> done{false};
  std::thread poster([&] {
    for (int i = 0; !done; ++i) {
      orders.scene = i % 2 == 0 ? one : other;
      servo.post(orders);
      (void)servo.takeFlightRecord();
      std::this_thread::yield();
    }
  });
  const auto calls = support::systemCallsOf([&] {
    std::int64_t now_ns = 5'000'000'000;
    for (int i = 0; i < 20'000; ++i) {
      device.pressed = i % 4000 > 100;
      device.position_mm = 0.08 * (i % 4000);
      if (i == 15'000) servo.stop();
      servo.tick(now_ns += kTickNs);
    }
  });
  done = true;
  poster.join();
  if (!calls) GTEST_SKIP() << "no system call filter here";
  EXPECT_EQ(calls->count, 0) << "the first was number " << calls->first;
  EXPECT_GT(servo.statistics().orders_taken, 1U);
  EXPECT_GT(servo.sceneCounters().asked, 1000U);
}

TEST(ServoUnderTheKernelsEyes, WouldSeeASystemCall) {
  const auto calls = support::systemCallsOf([] {
    (void)getppid();
    std::this_thread::yield();
  });
  if (!calls) GTEST_SKIP() << "no system call filter here";
  EXPECT_EQ(calls->count, 2);
  EXPECT_EQ(calls->first, SYS_getppid);
}

/// What the trap says about `forbidden`.
template <typename Forbidden>
std::string caught(Forbidden forbidden) {
  support::RealTimeTrap trap;
  forbidden();
  trap.disarm();
  return trap.hits() > 0 ? trap.first() : "";
}

/// The compiler may leave out a pair of new and delete that it sees through.
template <typename T>
void keep(T* pointer) {
  asm volatile("" : : "g"(pointer) : "memory");
}

TEST(RealTimeTrap, CatchesAllocation) {
  EXPECT_EQ(caught([] {
              const auto memory = std::make_unique<int>(1);
              keep(memory.get());
            }),
            "malloc");
  EXPECT_EQ(caught([] {
              std::vector<double> many(1000);
              keep(many.data());
            }),
            "malloc");
  auto memory = std::make_unique<int>(1);
  keep(memory.get());
  EXPECT_EQ(caught([&] { memory.reset(); }), "free");
  EXPECT_EQ(caught([] {}), "") << "and nothing where there is nothing";
}

TEST(RealTimeTrap, CatchesLocksFilesAndExceptions) {
  if (!support::RealTimeTrap::catchesEverything()) GTEST_SKIP() << "the sanitizer replaces these functions itself";
  std::mutex mutex;
  EXPECT_EQ(caught([&] { const std::scoped_lock lock(mutex); }), "pthread_mutex_lock");
  EXPECT_EQ(caught([&] {
              if (mutex.try_lock()) mutex.unlock();
            }),
            "pthread_mutex_trylock");
  std::condition_variable condition;
  EXPECT_EQ(caught([&] { condition.notify_one(); }), "pthread_cond_signal");
  EXPECT_EQ(caught([&] { condition.notify_all(); }), "pthread_cond_broadcast");

  EXPECT_EQ(caught([] {
              const int file = open("/dev/null", O_WRONLY);
              EXPECT_GE(file, 0);
              close(file);
            }),
            "open");
  const int file = open("/dev/null", O_RDWR);
  EXPECT_EQ(caught([&] { EXPECT_EQ(write(file, "x", 1), 1); }), "write");
  char byte = 0;
  EXPECT_EQ(caught([&] { EXPECT_EQ(read(file, &byte, 1), 0); }), "read");
  EXPECT_EQ(caught([&] { close(file); }), "close");

  support::RealTimeTrap trap;
  try {
    throw 1;
  } catch (int) {
  }
  trap.disarm();
  EXPECT_EQ(trap.hits(), 3) << "the exception's memory, __cxa_throw, and the memory again";
}

}  // namespace
}  // namespace tactus::haptics
