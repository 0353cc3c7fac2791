#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include "core/base/random.h"
#include "core/base/text.h"
#include "core/haptics/haply/haply_device.h"
#include "core/haptics/haply/haply_messages.h"
#include "core/haptics/haply/web_socket.h"
#include "core/haptics/servo/servo_clock.h"
#include "core/haptics/simulated/pausing_clock.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::haptics {
namespace {

constexpr int kMostDevices = 8;
constexpr std::size_t kMostTraced = 600'000;  // ten minutes at 1 kHz
constexpr double kMmPerM = 1000;
// The service returns a device to idle when commands stop; after what time it does not say.
constexpr double kQuietAfterS = 0.05;

VirtualDeviceSettings handOf(const HaplyEmulatorSettings& settings) {
  VirtualDeviceSettings hand;
  hand.plan = settings.plan ? settings.plan : [](double) { return HandTarget{}; };
  hand.count_mm = 0;
  hand.delay_s = 0;
  hand.max_force_n = kHaplyMaxForceN;
  hand.quiet_after_s = kQuietAfterS;
  return hand;
}

base::Result<void> check(const HaplyEmulatorSettings& s) {
  struct Bound {
    const char* place;
    double value, low, high;
  };
  const std::array bounds = {Bound{"devices", static_cast<double>(s.devices), 1, kMostDevices},
                             Bound{"rate", s.rate_hz, 1, 1e6},
                             Bound{"late", s.late_s, 0, 10},
                             Bound{"late share", s.late_share, 0, 1},
                             Bound{"dead after", s.dead_after_s.value_or(0), 0, 1e6},
                             Bound{"silent after", s.silent_after_s.value_or(0), 0, 1e6}};
  for (const Bound& bound : bounds) {
    if (bound.value >= bound.low && bound.value <= bound.high) continue;
    return base::fail(base::ErrorCode::kValue, bound.place, base::formatNumber(bound.value),
                      "a number from " + base::formatNumber(bound.low) + " to " + base::formatNumber(bound.high));
  }
  return {};
}

}  // namespace

class HaplyEmulator::Service final : public WebSocketHandler {
 public:
  explicit Service(HaplyEmulatorSettings settings) : settings_(std::move(settings)) {
    for (int i = 1; i <= settings_.devices; ++i) {
      devices_.emplace_back(handOf(settings_));
      devices_.back().commanded.id = "SIM-" + std::to_string(i);
    }
  }

  base::Result<void> listen() {
    TACTUS_TRY(server_, WebSocketServer::start(settings_.port, *this));
    return {};
  }
  std::uint16_t port() const { return server_->port(); }
  /// Ends the thread that calls this object.
  void stop() { server_.reset(); }
  bool isDead() const noexcept { return dead_.load(std::memory_order_acquire); }

  std::optional<std::string> greet(std::uint64_t) override {
    const std::lock_guard lock(mutex_);
    ++emulation_.clients;
    if (connected_++ == 0) beginAnew();
    advance();
    return stateText(true);
  }

  WebSocketReply reply(std::uint64_t client, std::string_view text) override {
    const std::lock_guard lock(mutex_);
    const std::int64_t now_ns = monotonicNs();
    if (emulation_.messages++ == 0) begin_ns_ = now_ns;
    emulation_.seconds = secondsBetween(begin_ns_, now_ns);
    if (settings_.dead_after_s && emulation_.seconds >= *settings_.dead_after_s) {
      dead_.store(true, std::memory_order_release);
      return {{}, 0, true};
    }
    if (settings_.silent_after_s && emulation_.seconds >= *settings_.silent_after_s) return {};

    const std::int64_t time_ns = advance();
    const auto request = readHaplyRequest(text);
    std::string refusal = request ? std::string() : request.error().message();
    if (request) {
      for (const HaplyCommand& command : request->commands) {
        std::string why = obey(client, command, time_ns);
        if (!why.empty()) refusal = std::move(why);
      }
    }
    if (!refusal.empty()) ++emulation_.refused;
    return {stateText(request && request->wants_everything, refusal), delayS(client, now_ns), false};
  }

  void left(std::uint64_t client) override {
    const std::lock_guard lock(mutex_);
    --connected_;
    last_reply_ns_.erase(client);
    for (Device& device : devices_) {
      if (device.owner == client) device.owner = 0;
    }
  }

  HaplyEmulation summary() const {
    const std::lock_guard lock(mutex_);
    HaplyEmulation emulation = emulation_;
    for (const Device& device : devices_) emulation.devices.push_back(device.commanded);
    return emulation;
  }

  std::string trace() const {
    const std::lock_guard lock(mutex_);
    return "time_s,device,position_mm,speed_mm_s,force_x_n,force_y_n,force_z_n,simulated\n" + trace_;
  }

 private:
  struct Device {
    explicit Device(VirtualDeviceSettings hand) : simulation(std::move(hand)) {}

    DeviceSimulation simulation;
    HaplyCommanded commanded;
    std::uint64_t owner = 0;  ///< the client that gives its force; 0: none
    bool button = false;
  };

  void beginAnew() {
    clock_ = {};
    for (Device& device : devices_) device.simulation = DeviceSimulation(handOf(settings_));
  }

  std::int64_t advance() {
    const std::int64_t time_ns = clock_.at(monotonicNs());
    for (Device& device : devices_) {
      device.simulation.advance(time_ns);
      device.button = device.simulation.sample().buttons != 0;
      device.commanded.farthest_mm = std::max(device.commanded.farthest_mm, device.simulation.body().positionMm());
    }
    return time_ns;
  }

  /// The sentence for a client that is refused.
  std::string obey(std::uint64_t client, const HaplyCommand& command, std::int64_t time_ns) {
    const auto device =
        std::find_if(devices_.begin(), devices_.end(), [&](const Device& d) { return d.commanded.id == command.id; });
    if (device == devices_.end()) return "there is no device " + base::quoted(command.id);
    if (!command.force_n) return {};
    if (device->owner != 0 && device->owner != client) return "another client gives the force to " + command.id;
    device->owner = client;
    const Vector3 force_n = *command.force_n;
    HaplyCommanded& commanded = device->commanded;
    ++commanded.forces;
    commanded.last_n = force_n;
    commanded.largest_n = std::max(commanded.largest_n, std::sqrt(dot(force_n, force_n)));
    // Toward the user is against the insertion.
    device->simulation.push(force_n.z, time_ns);
    if (settings_.trace) addToTrace(*device, force_n);
    return {};
  }

  void addToTrace(const Device& device, const Vector3& force_n) {
    if (traced_++ >= kMostTraced) return;
    const SimulatedBody& body = device.simulation.body();
    trace_ += base::formatNumber(emulation_.seconds) + ',' + device.commanded.id;
    for (const double number : {body.positionMm(), body.speedMmS(), force_n.x, force_n.y, force_n.z})
      trace_ += ',' + base::formatNumber(number);
    trace_ += ",1\n";
  }

  std::string stateText(bool with_config, const std::string& error = {}) const {
    std::vector<HaplyState> states;
    for (const Device& device : devices_) {
      const SimulatedBody& body = device.simulation.body();
      HaplyState state;
      state.id = device.commanded.id;
      // The hand moves away from the user.
      state.position_m = kHaplyMiddleM + Vector3{0, body.positionMm() / kMmPerM, 0};
      state.velocity_m_s = {0, body.speedMmS() / kMmPerM, 0};
      state.force_n = {0, -device.simulation.forceInEffectN(), 0};
      if (settings_.grip) state.grip = device.button;
      states.push_back(std::move(state));
    }
    return haplyStateText(states, with_config, error);
  }

  /// How long the reply waits: for the rate, and as a late one.
  double delayS(std::uint64_t client, std::int64_t now_ns) {
    std::int64_t& last_ns = last_reply_ns_[client];
    const auto due_ns = std::max(now_ns, last_ns + static_cast<std::int64_t>(1e9 / settings_.rate_hz));
    last_ns = due_ns;
    const bool is_late = settings_.late_s > 0 && random_.uniform() < settings_.late_share;
    return secondsBetween(now_ns, due_ns) + (is_late ? settings_.late_s : 0);
  }

  const HaplyEmulatorSettings settings_;
  mutable std::mutex mutex_;
  std::vector<Device> devices_;
  HaplyEmulation emulation_;
  PausingClock clock_;
  int connected_ = 0;  ///< clients
  std::int64_t begin_ns_ = 0;
  std::map<std::uint64_t, std::int64_t> last_reply_ns_;
  base::Random random_{1};
  std::string trace_;
  std::size_t traced_ = 0;
  std::atomic<bool> dead_{false};
  std::unique_ptr<WebSocketServer> server_;
};

base::Result<std::unique_ptr<HaplyEmulator>> HaplyEmulator::start(HaplyEmulatorSettings settings) {
  if (auto checked = check(settings); !checked) return tl::unexpected(checked.error());
  auto service = std::make_unique<Service>(std::move(settings));
  if (auto listens = service->listen(); !listens) return tl::unexpected(listens.error());
  return std::unique_ptr<HaplyEmulator>(new HaplyEmulator(std::move(service)));
}

HaplyEmulator::HaplyEmulator(std::unique_ptr<Service> service) : service_(std::move(service)) {}

HaplyEmulator::~HaplyEmulator() { service_->stop(); }

std::uint16_t HaplyEmulator::port() const noexcept { return service_->port(); }
bool HaplyEmulator::isDead() const noexcept { return service_->isDead(); }
HaplyEmulation HaplyEmulator::summary() const { return service_->summary(); }
std::string HaplyEmulator::trace() const { return service_->trace(); }

}  // namespace tactus::haptics
