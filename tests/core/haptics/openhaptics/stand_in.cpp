// A stand-in for libHD.so, written from the public facts about the library: an error stack, limits, frames, a
// scheduler. It declares its types itself, so that a wrong declaration in Tactus shows.
#include "tests/core/haptics/openhaptics/stand_in.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <thread>

namespace {

using tactus::haptics::stand_in::State;

struct HDErrorInfo {
  std::uint32_t error_code;
  int internal_error_code;
  std::uint32_t device;
};

constexpr std::uint32_t kTheDevice = 7;

std::unique_ptr<State> g_state = std::make_unique<State>();
std::vector<HDErrorInfo> g_errors;
bool g_in_frame = false;
double g_frame_force[3] = {0, 0, 0};
std::uint32_t (*g_callback)(void*) = nullptr;
void* g_user = nullptr;
std::thread g_thread;
std::atomic<bool> g_thread_runs{false};

void push(std::uint32_t code, int internal = 0) {
  if (code != 0) g_errors.push_back({code, internal, kTheDevice});
}

void note(const std::string& call) { g_state->calls.push_back(call); }

bool needsFrame() {
  if (!g_in_frame) push(0x0102);
  return g_in_frame;
}

bool stepOnce() {
  if (!g_state->running || g_callback == nullptr) return false;
  if (g_callback(g_user) == 0) {
    g_callback = nullptr;
    g_state->scheduled = false;
  }
  return true;
}

}  // namespace

extern "C" {

State* standInState() { return g_state.get(); }
bool standInStep() { return stepOnce(); }
void standInReset() {
  g_state = std::make_unique<State>();
  g_errors.clear();
  g_in_frame = false;
  g_callback = nullptr;
}

std::uint32_t hdInitDevice(const char* name) {
  const std::string asked = name == nullptr ? "" : name;
  note("init " + asked);
  bool accepted = false;
  for (const auto& known : g_state->accepted_names) accepted = accepted || known == asked;
  if (g_state->taken_elsewhere || g_state->open_devices > 0)
    push(0x0301, 3);
  else if (!accepted || g_state->gives_handle_with_error)
    push(g_state->init_error, 11);
  if (!g_errors.empty() && !g_state->gives_handle_with_error) return 0xFFFFFFFF;
  ++g_state->open_devices;
  return kTheDevice;
}

void hdDisableDevice(std::uint32_t device) {
  note("disable device");
  if (device != kTheDevice || g_state->open_devices == 0) return push(0x0104);
  --g_state->open_devices;
}

void hdMakeCurrentDevice(std::uint32_t device) {
  if (device != kTheDevice) push(0x0104);
}

void hdBeginFrame(std::uint32_t) {
  if (g_in_frame) push(0x0400);
  g_in_frame = true;
}

void hdEndFrame(std::uint32_t) {
  if (!g_in_frame) push(0x0401);
  g_in_frame = false;
  double length_n = 0;
  for (int axis = 0; axis < 3; ++axis) length_n += g_frame_force[axis] * g_frame_force[axis];
  length_n = std::sqrt(length_n);
  if (length_n > g_state->max_force_n * (1 + 1e-12)) {
    push(0x0201);
    g_state->force_output = false;
  }
  for (const auto error : g_state->errors_of_next_frame) {
    push(error, 42);
    if (error >= 0x0200 && error <= 0x0204) g_state->force_output = false;
  }
  g_state->errors_of_next_frame.clear();
  std::memcpy(g_state->force_n, g_frame_force, sizeof g_frame_force);
  g_state->largest_force_n = std::max(g_state->largest_force_n, length_n);
  g_state->frames.fetch_add(1, std::memory_order_release);
}

HDErrorInfo hdGetError() {
  if (g_state->error_for_ever) return {0x0100, 0, kTheDevice};
  if (g_errors.empty()) return {0, 0, 0xFFFFFFFF};
  const HDErrorInfo newest = g_errors.back();
  g_errors.pop_back();
  return newest;
}

const char* hdGetErrorString(std::uint32_t code) { return code == 0x0200 ? "Warm\nmotors" : "words of the driver"; }

void hdEnable(std::uint32_t capability) {
  note("enable");
  if (capability == g_state->refused_capability) return push(0x0204);
  if (g_state->running && g_state->enable_again_error != 0) return push(g_state->enable_again_error);
  if (capability == 0x4000) g_state->force_output = true;
}

void hdDisable(std::uint32_t capability) {
  note("disable");
  if (capability == 0x4000) g_state->force_output = false;
}

unsigned char hdIsEnabled(std::uint32_t capability) { return capability == 0x4000 && g_state->force_output ? 1 : 0; }

const char* hdGetString(std::uint32_t what) {
  if (what == 0x2501) return "Stand-in (simulated)";
  if (what == 0x2504) return "S-0042 ";
  push(0x0100);
  return nullptr;
}

void hdGetIntegerv(std::uint32_t what, int* value) {
  if (what == 0x2000 && needsFrame()) *value = g_state->buttons;
  if (what == 0x2554) *value = 3;
  if (what == 0x2555) *value = g_state->calibration_styles;
}

void hdGetDoublev(std::uint32_t what, double* values) {
  if (what == 0x2602) *values = g_state->stiffness_n_mm;
  if (what == 0x2603) *values = g_state->max_force_n;
  if (what == 0x2604) *values = g_state->continuous_force_n;
  if (what == 0x2050 && needsFrame()) std::memcpy(values, g_state->position_mm, sizeof g_state->position_mm);
  if (what == 0x2051 && needsFrame()) std::memcpy(values, g_state->velocity_mm_s, sizeof g_state->velocity_mm_s);
}

void hdSetDoublev(std::uint32_t what, const double* values) {
  if (what == 0x2700 && needsFrame()) std::memcpy(g_frame_force, values, sizeof g_frame_force);
}

std::uint32_t hdCheckCalibration() { return g_state->calibration; }

#ifndef STAND_IN_INCOMPLETE
void hdUpdateCalibration(std::uint32_t style) {
  g_state->calibration_updates.push_back(style);
  g_state->calibration = g_state->calibration_after_update;
}

void hdUnschedule(unsigned long) {
  note("unschedule");
  if (!g_state->scheduled) push(0x0102);
  g_callback = nullptr;
  g_state->scheduled = false;
}
#endif

void hdStartScheduler() {
  note("start scheduler");
  if (g_state->start_error != 0) return push(g_state->start_error);
  g_state->running = true;
  if (!g_state->threaded) return;
  g_thread_runs = true;
  g_thread = std::thread([] {
    auto next = std::chrono::steady_clock::now();
    while (g_thread_runs) {
      stepOnce();
      std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    }
  });
}

void hdStopScheduler() {
  note("stop scheduler");
  g_thread_runs = false;
  if (g_thread.joinable()) g_thread.join();
  g_state->running = false;
}

void hdSetSchedulerRate(unsigned long hz) {
  push(g_state->rate_error);
  g_state->rate_hz = hz;
}

unsigned long hdScheduleAsynchronous(std::uint32_t (*callback)(void*), void* user, std::uint16_t priority) {
  note("schedule " + std::to_string(priority));
  if (g_state->schedule_error != 0) {
    push(g_state->schedule_error);
    return 0;
  }
  g_callback = callback;
  g_user = user;
  g_state->scheduled = true;
  // Does not fit into 32 bits: a handle that is declared too short comes back wrong.
  return 0x1'0000'0001UL;
}

}  // extern "C"
