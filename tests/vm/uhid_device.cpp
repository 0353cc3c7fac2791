// uhid_device MODEL: one of the made-up force-feedback devices, plugged into this kernel through /dev/uhid, with a
// handle that stays where it is told to. Commands come as lines on standard input; each is answered with lines and
// `done`.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <poll.h>
#include <sched.h>
#include <sstream>
#include <string>
#include <unistd.h>

#include "tests/support/fake_pid_device.h"
#include "tests/vm/uhid_node.h"

namespace tactus::vm {
namespace {

using support::FakePidDevice;
using support::PidModel;

constexpr std::int64_t kPeriodNs = 1'000'000;

std::int64_t nowNs() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * 1'000'000'000LL + time.tv_nsec;
}

class Device {
 public:
  explicit Device(PidModel model) : model_(model), fake_(model) { plug(); }

  /// Until standard input ends.
  void run() {
    next_report_ns_ = nowNs();
    for (;;) {
      std::array<pollfd, 2> waits{{{STDIN_FILENO, POLLIN, 0}, {node_ && hears_ ? node_->descriptor() : -1, POLLIN, 0}}};
      const std::int64_t rest_ns = std::max<std::int64_t>(0, next_report_ns_ - nowNs());
      const timespec rest{0, static_cast<long>(rest_ns)};
      ppoll(waits.data(), waits.size(), speaks_ ? &rest : nullptr, nullptr);
      if ((waits[1].revents & POLLIN) != 0) node_->serve();
      if (speaks_ && nowNs() >= next_report_ns_) report();
      if (waits[0].revents != 0 && !readCommands()) return;
    }
  }

 private:
  void plug() {
    fake_ = FakePidDevice(model_);
    told_ = 0;
    const auto descriptor = support::reportDescriptor(model_);
    const auto product = static_cast<std::uint16_t>(0x0100 + static_cast<int>(model_));
    node_.emplace(UhidIdentity{std::string("Virtual ") + support::name(model_), "vm-1", 0xF055, product}, descriptor,
                  UhidHandlers{[this](auto bytes) {
                                 ++outputs_;
                                 fake_.output(bytes, nowNs());
                               },
                               [this](auto bytes) { return fake_.setFeature(bytes, nowNs()); },
                               [this](std::uint8_t id) { return fake_.getFeature(id); }});
  }

  void report() {
    const std::int64_t now_ns = nowNs();
    next_report_ns_ += kPeriodNs;
    if (now_ns - next_report_ns_ > 5 * kPeriodNs) next_report_ns_ = now_ns;
    fake_.advance(now_ns);
    const auto share = fake_.force(now_ns);
    moveHandle(share);
    if (!node_) return;
    sendHandle();
    const auto state = fake_.stateReport();
    if (!state.empty() && (state != told_state_ || ++since_state_ >= 100)) {
      node_->sendInput(state);
      told_state_ = state;
      since_state_ = 0;
    }
  }

  /// Dry friction, and above it as fast as the rest of the force.
  void moveHandle(const std::array<double, 2>& share) {
    const double force = std::hypot(share[0], share[1]);
    if (force <= friction_) return;
    for (std::size_t axis = 0; axis < 2; ++axis) handle_[axis] += mobility_ * (force - friction_) * share[axis] / force;
  }

  void sendHandle() {
    node_->sendInput(fake_.inputReport(
        {static_cast<int>(std::lround(handle_[0])), static_cast<int>(std::lround(handle_[1]))}, buttons_));
  }

  bool readCommands() {
    std::array<char, 512> room{};
    const ssize_t size = read(STDIN_FILENO, room.data(), room.size());
    if (size <= 0) return false;
    unread_.append(room.data(), static_cast<std::size_t>(size));
    for (std::size_t end = 0; (end = unread_.find('\n')) != std::string::npos; unread_.erase(0, end + 1)) {
      obey(unread_.substr(0, end));
      std::puts("done");
      std::fflush(stdout);
    }
    return true;
  }

  void obey(const std::string& line) {
    std::istringstream words(line);
    std::string command;
    words >> command;
    if (command == "at") {  // X Y: where the handle is, in counts
      words >> handle_[0] >> handle_[1];
    } else if (command ==
               "yields") {  // COUNTS FRICTION: motion in a millisecond at full force; share that moves nothing
      words >> mobility_ >> friction_;
    } else if (command == "buttons") {  // MASK
      words >> buttons_;
    } else if (command == "flood") {  // N: reports at once, each a count further along x
      int reports = 0;
      words >> reports;
      for (; reports > 0; --reports) {
        handle_[0] += 1;
        sendHandle();
      }
    } else if (command == "hears" || command == "speaks") {  // 0 or 1: reads the host's reports, sends its own
      words >> (command == "hears" ? hears_ : speaks_);
    } else if (command == "switch") {  // 1: the safety switch forbids forces; 0: it allows them
      bool down = false;
      words >> down;
      fake_.pressSafetySwitch(down, nowNs());
    } else if (command == "unplug") {
      node_.reset();
    } else if (command == "plug") {
      plug();
    } else if (command == "felt") {  // changes of the force since the last time: nanoseconds, x, y
      fake_.advance(nowNs());
      for (; told_ < fake_.forces().size(); ++told_) {
        const auto& change = fake_.forces()[told_];
        std::printf("%lld %.9g %.9g\n", static_cast<long long>(change.time_ns), change.share[0], change.share[1]);
      }
    } else if (command == "forget") {  // those so far
      fake_.advance(nowNs());
      told_ = fake_.forces().size();
    } else if (command == "force") {  // now: x, y
      const auto share = fake_.force(nowNs());
      std::printf("%.9g %.9g\n", share[0], share[1]);
    } else if (command == "outputs") {  // how many reports of the host arrived
      std::printf("%ld\n", outputs_);
    } else if (command == "actuators") {
      std::printf("%d\n", fake_.actuatorsOn() ? 1 : 0);
    } else if (command == "effects") {
      std::printf("%d\n", fake_.effectsInUse());
    } else if (command == "forgive") {  // what was found wrong so far
      fake_.forgive();
    } else if (command == "complaints") {
      for (const std::string& complaint : fake_.complaints()) std::printf("%s\n", complaint.c_str());
    }
  }

  PidModel model_;
  FakePidDevice fake_;
  std::optional<UhidNode> node_;
  std::array<double, 2> handle_{};
  double mobility_ = 0;
  double friction_ = 0;
  std::uint32_t buttons_ = 0;
  bool hears_ = true;
  bool speaks_ = true;
  std::int64_t next_report_ns_ = 0;
  std::vector<std::uint8_t> told_state_;
  int since_state_ = 0;
  std::size_t told_ = 0;
  long outputs_ = 0;
  std::string unread_;
};

}  // namespace
}  // namespace tactus::vm

int main(int argc, char** argv) {
  using namespace tactus;
  // Hardware does not wait for the host's processor.
  const sched_param priority{.sched_priority = 90};
  sched_setscheduler(0, SCHED_FIFO, &priority);
  for (const support::PidModel model : support::kPidModels) {
    if (argc == 2 && std::string(argv[1]) == support::name(model)) {
      vm::Device(model).run();
      return 0;
    }
  }
  std::puts("no such model");
  return 2;
}
