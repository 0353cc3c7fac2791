// The Haply device against its double, on the real wire.
#include "core/haptics/haply/haply_device.h"

#include <array>
#include <cmath>

#include "core/haptics/servo/servo.h"

#include "tests/core/haptics/haply/haply_run.h"
#include "tests/support/real_time_trap.h"

namespace tactus::haptics {
namespace {

std::unique_ptr<HaplyEmulator> emulator(HaplyEmulatorSettings settings = {}) {
  settings.port = 0;
  auto started = HaplyEmulator::start(std::move(settings));
  if (!started) ADD_FAILURE() << started.error().message();
  return started ? *std::move(started) : nullptr;
}

std::unique_ptr<HaplyDevice> opened(const HaplyEmulator& service, const std::string& id = {}) {
  auto device = HaplyDevice::open(service.port(), id);
  if (!device) ADD_FAILURE() << device.error().message();
  return device ? *std::move(device) : nullptr;
}

AxisMapping axisOf(const HaplyDevice& device) { return *AxisMapping::make({0, 0, -1}, device.found().middle_mm); }

/// The button is down, and the hand rests.
HandTarget holding(double) {
  HandTarget wish;
  wish.button = true;
  return wish;
}

/// Only the trips that a test asks for, however slow the machine is.
ServoOrders patientOrders(const HaplyDevice& device) {
  ServoOrders orders;
  orders.axis = axisOf(device);
  orders.limits = LimitSettings::forDevice(device.info());
  orders.limits.stale_trip_s = orders.limits.write_trip_s = orders.limits.servo_trip_s = 100;
  orders.limits.guard_velocity = false;
  orders.limits.fade_in_s = 0.05;
  orders.source = ForceSource::kStimulus;
  orders.stimulus = {1, 0.4, 0.15, {}, {}};
  return orders;
}

TEST(HaplyDevice, IsDescribedByWhatTheServiceSays) {
  const auto service = emulator();
  const auto device = opened(*service);
  const DeviceInfo& info = device->info();
  EXPECT_EQ(info.id, "simulated-haply:SIM-1");
  EXPECT_EQ(info.serial, "SIM-1");
  EXPECT_EQ(info.backend, "haply");
  EXPECT_TRUE(info.simulated);
  EXPECT_EQ(info.buttons, 3);
  EXPECT_EQ(info.max_force_n, kHaplyMaxForceN);
  EXPECT_FALSE(info.continuous_force_n) << "not known";
  EXPECT_GT(device->found().round_trip_s, 0);
  EXPECT_GT(info.delay_s, device->found().round_trip_s + 0.001) << "the tick that answers comes on top";
  EXPECT_EQ(service->summary().devices[0].forces, 0u) << "looking asks for no force";
}

TEST(HaplyDevice, AForceInNewtonsMovesTheHandAsItsSpringSays) {
  const auto service = emulator();
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  // 1.5 N toward the user on a pinch of 100 N/m are 15 mm; the dry friction of 0.05 N takes at most 0.5 mm.
  EXPECT_TRUE(comesTrue(*device, {0, 0, 1.5}, [&](const DeviceState& state) {
    return std::abs(axisOf(*device).positionMm(state.position_mm) + 15) < 0.6 && state.velocity_mm_s &&
           std::abs(state.velocity_mm_s->z) < 0.1;
  }));
  EXPECT_EQ(service->summary().devices[0].last_n, (Vector3{0, 0, 1.5}));
  EXPECT_GT(device->read(monotonicNs()).written_ns, 0);
  device->stop();
  EXPECT_EQ(service->summary().devices[0].last_n, Vector3{}) << "the last command is no force";
  EXPECT_EQ(device->counters().refused, 0u);
}

TEST(HaplyDevice, AForceBeyondTheLargestIsShortenedAndNoNumberIsNone) {
  const auto service = emulator();
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  const auto last = [&] { return service->summary().devices[0].last_n; };
  EXPECT_TRUE(comesTrue(*device, {30, 0, 40}, [&](const DeviceState&) { return last().z > 7; }));
  EXPECT_NEAR(service->summary().devices[0].largest_n, kHaplyMaxForceN, 1e-12);
  const double nan = std::nan("");
  EXPECT_TRUE(comesTrue(*device, {0, 0, nan}, [&](const DeviceState&) { return last() == Vector3{}; }));
}

// The thread of the device goes on without the servo, so it has to end its force by itself.
TEST(HaplyDevice, AServoThatStandsStillLeavesNoForce) {
  const auto service = emulator();
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  const auto last = [&] { return service->summary().devices[0].last_n; };
  EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [&](const DeviceState&) { return last().z == 1; }));
  EXPECT_TRUE(comesTrue([&] { return last() == Vector3{}; }, [] {}));
}

TEST(HaplyDevice, OfTwoDevicesTheFirstIsTakenOrTheOneThatIsNamed) {
  HaplyEmulatorSettings settings;
  settings.devices = 2;
  const auto service = emulator(settings);
  EXPECT_EQ(opened(*service)->info().id, "simulated-haply:SIM-1");
  const auto second = opened(*service, "simulated-haply:SIM-2");
  ASSERT_TRUE(second->start());
  EXPECT_TRUE(
      comesTrue(*second, {0, 0, 1}, [&](const DeviceState&) { return service->summary().devices[1].last_n.z == 1; }));
  EXPECT_EQ(service->summary().devices[0].forces, 0u);
  const auto third = HaplyDevice::open(service->port(), "simulated-haply:SIM-3");
  ASSERT_FALSE(third.has_value());
  EXPECT_EQ(third.error().message(),
            "simulated-haply:SIM-3: found no such device, wanted one that `tactus devices` lists");
  EXPECT_FALSE(HaplyDevice::open(service->port(), "haply:SIM-1").has_value()) << "it is a simulated one";
}

TEST(HaplyDevice, WithoutAGripThereIsNoButton) {
  HaplyEmulatorSettings settings;
  settings.grip = false;
  EXPECT_EQ(opened(*emulator(settings))->info().buttons, 0);
}

TEST(HaplyDevice, TheButtonOfTheGripIsTheFirst) {
  HaplyEmulatorSettings settings;
  settings.plan = holding;
  const auto service = emulator(settings);
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  EXPECT_TRUE(comesTrue(*device, {}, [](const DeviceState& state) { return state.buttons == 1; }));
}

TEST(HaplyDevice, LateRepliesLowerTheStiffness) {
  HaplyEmulatorSettings settings;
  settings.late_s = 0.01;
  const auto late = lookAtHaply(emulator(settings)->port());
  ASSERT_TRUE(late.has_value()) << late.error().message();
  EXPECT_GE(late->at(0).round_trip_s, 0.01);
  EXPECT_NEAR(late->at(0).info.delay_s, late->at(0).round_trip_s + 0.0011, 1e-12) << "a tick and the nap of the thread";
  // Half of 1.7 N s/m / (T / 2 + delay), and the delay is at least 11.1 ms.
  EXPECT_LE(largestStiffnessNMm(late->at(0).info), 0.5 * 0.0017 / 0.0116 + 1e-12);
  settings.late_s = 0.03;
  const auto service = emulator(settings);
  const auto refused = HaplyDevice::open(service->port(), {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message().find("too late for a force"), std::string::npos) << refused.error().message();
}

TEST(HaplyDevice, TheServoThreadNeverWaits) {
  const auto service = emulator();
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  ASSERT_TRUE(comesTrue(*device, {}, [](const DeviceState& state) { return state.number > 20; }));
  support::RealTimeTrap trap;
  for (int tick = 0; tick < 20'000; ++tick) {
    device->read(tick);
    device->write({0, 0, 0.1}, tick);
  }
  trap.disarm();
  EXPECT_EQ(trap.hits(), 0) << trap.first();
}

// A whole run: a force is felt, the service dies in the middle, comes back, and the user arms again.
TEST(HaplyDevice, ADeadServiceEndsTheForceAndArmingAgainBringsItBack) {
  HaplyEmulatorSettings settings;
  settings.plan = [](double time_s) {
    HandTarget wish;
    wish.button = std::fmod(time_s, 3.5) > 0.5;
    return wish;
  };
  auto service = emulator(settings);
  const std::uint16_t port = service->port();
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  Servo servo(*device);
  ServoOrders orders = patientOrders(*device);
  Sample sample;
  std::array<Sample, 64> room;
  const auto tick = [&] {
    servo.tick(monotonicNs());
    for (const Sample& one : servo.drain(room)) sample = one;
  };
  const auto arm = [&](bool armed) {
    orders.armed = armed;
    servo.post(orders);
  };
  arm(true);
  ASSERT_TRUE(comesTrue([&] { return sample.force_n > 0.3; }, tick)) << "held by the button of the grip";
  EXPECT_GT(service->summary().devices[0].last_n.z, 0.1) << "toward the user";

  service.reset();
  ASSERT_TRUE(comesTrue([&] { return sample.trip != TripCause::kNone; }, tick));
  EXPECT_EQ(sample.force_n, 0);
  const auto record = [&] {
    std::optional<FlightRecord> taken;
    EXPECT_TRUE(comesTrue([&] { return (taken = servo.takeFlightRecord()).has_value(); }, tick));
    return taken;
  }();
  ASSERT_TRUE(record);
  EXPECT_EQ(record->trip.cause, TripCause::kDeviceLost);
  EXPECT_FALSE(sentence(record->trip).empty());

  settings.port = port;
  auto again = HaplyEmulator::start(settings);
  ASSERT_TRUE(again.has_value()) << again.error().message();
  ASSERT_TRUE(comesTrue([&] { return device->counters().reconnects > 0 && sample.buttons == 1; }, tick));
  EXPECT_EQ(sample.force_n, 0) << "no force comes back by itself";
  arm(false);
  ASSERT_TRUE(comesTrue([&] { return sample.buttons == 0; }, tick));
  ++orders.stimulus.number;
  arm(true);
  EXPECT_TRUE(comesTrue([&] { return sample.force_n > 0.3; }, tick));
  EXPECT_GT((*again)->summary().devices[0].largest_n, 0.1);
}

TEST(HaplyDevice, ASilentServiceIsLostAfterAWhile) {
  HaplyEmulatorSettings settings;
  settings.silent_after_s = 0.3;
  const auto service = emulator(settings);
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [](const DeviceState& s) { return s.fault == DeviceFault::kLost; }));
  device->stop();
}

TEST(HaplyDevice, ADeviceThatDiesCutsItsConnections) {
  HaplyEmulatorSettings settings;
  settings.dead_after_s = 0.2;
  const auto service = emulator(settings);
  const auto device = opened(*service);
  ASSERT_TRUE(device->start());
  EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [](const DeviceState& s) { return s.fault == DeviceFault::kLost; }));
  EXPECT_TRUE(service->isDead());
}

TEST(HaplyEmulator, AnotherClientSeesStatesButGivesNoForce) {
  const auto service = emulator();
  const auto first = WebSocketClient::connect("first", service->port(), 5);
  const auto second = WebSocketClient::connect("second", service->port(), 5);
  ASSERT_TRUE(first && second);
  const auto ask = [](WebSocketClient& client, const std::string& text) {
    EXPECT_TRUE(client.send(text));
    const auto reply = client.receive(10);
    return reply && *reply ? *readHaplyMessage(**reply) : HaplyMessage();
  };
  ASSERT_TRUE((*first)->receive(10) && (*second)->receive(10)) << "the lists";
  EXPECT_TRUE(ask(**first, haplyForceText("SIM-1", {0, 0, 1})).error.empty());
  const HaplyMessage refused = ask(**second, haplyForceText("SIM-1", {0, 0, 9}));
  EXPECT_EQ(refused.error, "another client gives the force to SIM-1");
  ASSERT_EQ(refused.devices.size(), 1u);
  EXPECT_TRUE(ask(**second, haplyProbeText("SIM-1")).error.empty());
  EXPECT_EQ(ask(**second, haplyProbeText("SIM-9")).error, "there is no device 'SIM-9'");
  EXPECT_NE(ask(**second, "{").error, "");
  EXPECT_EQ(ask(**second, haplyFullStateText()).devices.at(0).is_simulated, true) << "everything";
  const HaplyEmulation summary = service->summary();
  EXPECT_EQ(summary.devices[0].largest_n, 1);
  EXPECT_EQ(summary.refused, 3u);
  EXPECT_EQ(summary.clients, 2u);
}

TEST(HaplyEmulator, TheNinthClientIsTurnedAway) {
  const auto service = emulator();
  std::vector<std::unique_ptr<WebSocketClient>> clients;
  for (std::size_t i = 0; i < WebSocketServer::kMostClients; ++i) {
    auto client = WebSocketClient::connect("client", service->port(), 5);
    ASSERT_TRUE(client && (*client)->receive(10));
    clients.push_back(*std::move(client));
  }
  const auto ninth = WebSocketClient::connect("ninth", service->port(), 5);
  ASSERT_TRUE(ninth.has_value());
  EXPECT_FALSE((*ninth)->receive(10).has_value());
  clients.pop_back();
  EXPECT_TRUE(comesTrue(
      [&] {
        const auto later = WebSocketClient::connect("later", service->port(), 5);
        return later && (*later)->receive(10).has_value();
      },
      [] {}));
}

TEST(HaplyEmulator, TheTraceHasEachForceAndSaysThatItIsSimulated) {
  HaplyEmulatorSettings settings;
  settings.trace = true;
  const auto service = emulator(settings);
  const auto client = WebSocketClient::connect("client", service->port(), 5);
  ASSERT_TRUE(client && (*client)->receive(10));
  ASSERT_TRUE((*client)->send(haplyForceText("SIM-1", {0, 0, 0.5})) && (*client)->receive(10));
  const std::string trace = service->trace();
  EXPECT_TRUE(trace.starts_with("time_s,device,position_mm,speed_mm_s,force_x_n,force_y_n,force_z_n,simulated\n"));
  EXPECT_NE(trace.find(",SIM-1,"), std::string::npos);
  EXPECT_TRUE(trace.ends_with(",0,0,0.5,1\n")) << trace;
}

TEST(HaplyEmulator, SettingsOutOfRangeAndAPortInUseAreRefused) {
  HaplyEmulatorSettings settings;
  settings.port = 0;
  settings.devices = 9;
  EXPECT_EQ(HaplyEmulator::start(settings).error().message(), "devices: found 9, wanted a number from 1 to 8");
  settings.devices = 1;
  const auto service = emulator();
  settings.port = service->port();
  EXPECT_FALSE(HaplyEmulator::start(settings).has_value());
}

}  // namespace
}  // namespace tactus::haptics
