// Services that are not what they should be.
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <cmath>

#include "tests/core/haptics/haply/haply_run.h"

namespace tactus::haptics {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using Tcp = asio::ip::tcp;

/// Accepts connections one after the other and does with each what the test says, on the socket itself.
class RawServer {
 public:
  using Act = std::function<void(Tcp::socket&)>;
  explicit RawServer(Act act) : thread_([this, act = std::move(act)] { serve(act); }) {}
  ~RawServer() {
    ends_ = true;
    // The last connection is ours: it ends the waiting.
    asio::io_context io;
    Tcp::socket last(io);
    beast::error_code ignored;
    last.connect({asio::ip::address_v4::loopback(), port()}, ignored);
    thread_.join();
  }

  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  bool ends() const { return ends_; }

 private:
  void serve(const Act& act) {
    while (!ends_) {
      beast::error_code code;
      Tcp::socket socket(io_);
      acceptor_.accept(socket, code);
      if (!code && !ends_) act(socket);
    }
  }

  std::atomic<bool> ends_{false};
  asio::io_context io_;
  Tcp::acceptor acceptor_{io_, Tcp::endpoint(asio::ip::address_v4::loopback(), 0)};
  std::thread thread_;
};

std::string refusalOf(std::uint16_t port) {
  const auto device = HaplyDevice::open(port, {});
  if (device) return "opened";
  EXPECT_EQ(device.error().message().find('\n'), std::string::npos);
  return device.error().message();
}

std::unique_ptr<HaplyDevice> startedOn(std::uint16_t port) {
  auto device = HaplyDevice::open(port, {});
  if (!device) ADD_FAILURE() << device.error().message();
  if (!device) return nullptr;
  EXPECT_TRUE((*device)->start());
  return *std::move(device);
}

bool has(const DeviceState& state, DeviceFault fault) { return state.fault == fault; }

TEST(HaplyHostile, NothingListens) {
  std::uint16_t port = 0;
  {
    const ScriptedService gone(inventory());
    port = gone.port();
  }
  EXPECT_EQ(refusalOf(port), "localhost:" + std::to_string(port) +
                                 ": found no program that listens there, wanted the Haply Inverse Service, started");
}

TEST(HaplyHostile, AProgramThatSpeaksSomethingElse) {
  const RawServer other([](Tcp::socket& socket) {
    beast::error_code ignored;
    asio::write(socket, asio::buffer(std::string("SSH-2.0-other\r\n\r\n")), ignored);
  });
  EXPECT_NE(refusalOf(other.port()).find("does not answer as a WebSocket service does"), std::string::npos);
}

TEST(HaplyHostile, AProgramThatSaysNothing) {
  std::vector<Tcp::socket> kept;
  const RawServer silent([&kept](Tcp::socket& socket) { kept.push_back(std::move(socket)); });
  EXPECT_NE(refusalOf(silent.port()).find("does not answer as a WebSocket service does"), std::string::npos);
}

TEST(HaplyHostile, AFirstMessageThatIsNoList) {
  for (const char* const text : {"", "[]", "{\"inverse3\":", "{\"inverse3\":7}"}) {
    const ScriptedService service(text);
    EXPECT_NE(refusalOf(service.port()).find("wanted a Haply Inverse Service, format 3.1 or later"), std::string::npos)
        << text;
  }
  const ScriptedService busy(R"({"error":"license expired"})");
  EXPECT_NE(refusalOf(busy.port()).find("found the error 'license expired'"), std::string::npos);
  const ScriptedService empty(R"({"inverse3":[]})");
  EXPECT_NE(refusalOf(empty.port()).find("found no device, wanted an Inverse3, connected and switched on"),
            std::string::npos);
}

TEST(HaplyHostile, OtherAxesWouldBeOtherForces) {
  const ScriptedService turned(inventory("XZY"));
  EXPECT_NE(refusalOf(turned.port()).find("its axes are in the order 'XZY'"), std::string::npos);
  const ScriptedService scaled(inventory("XYZ", 2));
  EXPECT_NE(refusalOf(scaled.port()).find("turned or scaled"), std::string::npos);
}

// A message that cannot be used: a fault, no force, and the next good one is used again.
TEST(HaplyHostile, BadMessagesInTheMiddle) {
  ScriptedService service(inventory());
  const auto device = startedOn(service.port());
  const auto sends = [&](const Vector3& force_n) { return service.lastRequest() == haplyForceText("049D", force_n); };
  for (const std::string& bad :
       {std::string("{"), std::string("[]"), stateOf049D("{}"),
        stateOf049D(R"({"cursor_position":{"x":1e999,"y":0,"z":0}})"),
        stateOf049D(R"({"cursor_position":{"x":NaN,"y":0,"z":0}})"),
        stateOf049D(R"({"cursor_position":{"x":0,"y":0}})"),
        std::string(R"({"error":"overheated","inverse3":[{"device_id":"049D","state":{}}]})")}) {
    service.say(inventory());
    ASSERT_TRUE(comesTrue(*device, {0, 0, 1}, [&](const DeviceState& s) {
      return has(s, DeviceFault::kNone) && s.buttons == 2 && sends({0, 0, 1});
    })) << bad;
    service.say(bad);
    EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [&](const DeviceState& s) {
      return has(s, DeviceFault::kFailed) && sends({});
    })) << bad;
  }
  EXPECT_GT(device->counters().refused, 6u);
}

TEST(HaplyHostile, ADeviceThatIsUnpluggedOrNotReady) {
  ScriptedService service(inventory());
  const auto device = startedOn(service.port());
  const std::string at = R"("state":{"cursor_position":{"x":0,"y":0,"z":0}})";
  const auto status = [&](const std::string& what) {
    return R"({"inverse3":[{"device_id":"049D",)" + at + R"(,"status":{)" + what + "}}]}";
  };
  const std::pair<std::string, DeviceFault> all[] = {
      {R"({"inverse3":[{"device_id":"0000",)" + at + "}]}", DeviceFault::kLost},
      {status(R"("calibrated":false)"), DeviceFault::kNotCalibrated},
      {status(R"("power_supply":false)"), DeviceFault::kSwitchedOff},
      {R"({"inverse3":[]})", DeviceFault::kLost},
      {inventory("ZYX"), DeviceFault::kLost}};
  for (const auto& [text, fault] : all) {
    service.say(text);
    EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [&](const DeviceState& s) { return has(s, fault); })) << text;
    service.say(inventory());
    EXPECT_TRUE(comesTrue(*device, {}, [&](const DeviceState& s) { return has(s, DeviceFault::kNone); })) << text;
  }
}

TEST(HaplyHostile, ANumberThatOverflowsReachesTheSafetyLayer) {
  ScriptedService service(inventory());
  const auto device = startedOn(service.port());
  service.say(stateOf049D(R"({"cursor_position":{"x":0,"y":1e308,"z":0}})"));
  EXPECT_TRUE(comesTrue(*device, {}, [](const DeviceState& s) { return !std::isfinite(s.position_mm.z); }));
}

TEST(HaplyHostile, AHugeMessageEndsTheConnectionAndTheNextOneIsTaken) {
  ScriptedService service(inventory());
  const auto device = startedOn(service.port());
  service.say(std::string(kMostMessageBytes + 1, ' '));
  EXPECT_TRUE(comesTrue(*device, {}, [](const DeviceState& s) { return has(s, DeviceFault::kLost); }));
  service.say(inventory());
  EXPECT_TRUE(comesTrue(*device, {}, [&](const DeviceState& s) {
    return has(s, DeviceFault::kNone) && device->counters().reconnects > 0;
  }));
}

TEST(HaplyHostile, AMessageThatIsCutInTheMiddle) {
  std::atomic<int> connections{0};
  const RawServer cutting([&connections](Tcp::socket& socket) {
    beast::websocket::stream<Tcp::socket> stream(std::move(socket));
    beast::error_code code;
    stream.accept(code);
    stream.write(asio::buffer(inventory()), code);
    // The first connection is the one that looks; the second one is cut.
    const bool cuts = ++connections == 2;
    for (beast::flat_buffer in; !code; in.consume(in.size())) {
      stream.read(in, code);
      if (cuts) break;
      stream.write(asio::buffer(inventory()), code);
    }
    // A text of 100 bytes begins, and ends after 7.
    const std::array<unsigned char, 9> part = {0x81, 100, '{', '"', 'i', 'n', 'v', 'e', 'r'};
    if (cuts) asio::write(stream.next_layer(), asio::buffer(part), code);
    stream.next_layer().close(code);
  });
  const auto device = startedOn(cutting.port());
  EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [](const DeviceState& s) { return has(s, DeviceFault::kLost); }));
  EXPECT_TRUE(comesTrue(*device, {}, [](const DeviceState& s) { return has(s, DeviceFault::kNone); }));
  device->stop();
}

// One message a tick would take a minute: by then the last position is long past.
TEST(HaplyHostile, MoreStatesThanWereAskedForDoNotPileUp) {
  constexpr int kFlood = 60'000;
  std::atomic<int> connections{0};
  const RawServer flooding([&connections](Tcp::socket& socket) {
    beast::websocket::stream<Tcp::socket> stream(std::move(socket));
    beast::error_code code;
    stream.accept(code);
    stream.write(asio::buffer(inventory()), code);
    const bool floods = ++connections == 2;
    for (int i = 1; floods && i <= kFlood; ++i) {
      const double x_m = static_cast<double>(i) / kFlood;
      stream.write(
          asio::buffer(stateOf049D("{\"cursor_position\":{\"x\":" + std::to_string(x_m) + ",\"y\":0,\"z\":0}}")), code);
    }
    for (beast::flat_buffer in; !code; in.consume(in.size())) {
      stream.read(in, code);
      if (!floods) stream.write(asio::buffer(inventory()), code);
    }
  });
  const auto device = startedOn(flooding.port());
  EXPECT_TRUE(comesTrue(*device, {}, [](const DeviceState& s) { return s.position_mm.x == 1000; }));
  device->stop();
}

TEST(HaplyHostile, AClientThatNeverSendsDoesNotStopTheOthers) {
  HaplyEmulatorSettings settings;
  settings.port = 0;
  const auto service = HaplyEmulator::start(settings);
  ASSERT_TRUE(service.has_value());
  asio::io_context io;
  Tcp::socket raw(io);
  raw.connect({asio::ip::address_v4::loopback(), (*service)->port()});
  const auto quiet = WebSocketClient::connect("quiet", (*service)->port(), 5);
  ASSERT_TRUE(quiet.has_value());
  const auto device = startedOn((*service)->port());
  EXPECT_TRUE(comesTrue(*device, {0, 0, 1}, [&](const DeviceState& s) { return s.number > 20; }));
}

}  // namespace
}  // namespace tactus::haptics
