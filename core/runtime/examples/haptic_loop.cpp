// The haptics thread of a host in the manner of CHAI3D: positions in m come in and forces in N go out, a thousand times
// a second: haptic_loop MODEL [SECONDS]. The device is simulated; how the same four steps stand in CHAI3D, SOFA or
// OpenHaptics: docs/guide/simulator.md.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <tactus/tactus.hpp>
#include <thread>
#include <vector>

namespace {

struct Vector {
  double x = 0, y = 0, z = 0;
};

Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vector a) { return std::sqrt(dot(a, a)); }

// Where the tool is along the path of insertion. Depth is a length along this path, not a coordinate.
struct OnPath {
  double along_m = 0;
  Vector inwards;
};

// The straight pieces between the corners of the path, in m of the host, from the entry on.
OnPath project(const std::vector<Vector>& path, Vector tool) {
  OnPath best;
  double best_m = HUGE_VAL;
  double before_m = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vector piece = path[i + 1] - path[i];
    const double piece_m = length(piece);
    const Vector inwards = (1 / piece_m) * piece;
    const double along_m = std::clamp(dot(tool - path[i], inwards), 0.0, piece_m);
    const double off_m = length(tool - (path[i] + along_m * inwards));
    if (off_m < best_m) {
      best_m = off_m;
      best = {before_m + along_m, inwards};
    }
    before_m += piece_m;
  }
  return best;
}

// Stands for the device's driver: a hand that pushes 60 mm in each second, straight in, and holds the button.
struct SimulatedDevice {
  double time_s = 0;
  double largest_n = 0;

  Vector position() const { return {0, 0, -0.06 * time_s}; }
  bool button() const { return true; }
  void setForce(Vector force_n) { largest_n = std::max(largest_n, length(force_n)); }
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    std::fprintf(stderr, "usage: haptic_loop MODEL [SECONDS]\n");
    return 2;
  }
  const int ticks = static_cast<int>(1000 * (argc > 2 ? std::atof(argv[2]) : 1.0));
  const tactus::Model model = tactus::Model::open(argv[1]);
  std::map<std::string, double> conditions;
  for (std::size_t i = 0; i < model.inputs(); ++i) {
    const std::string id = model.inputId(i);
    if (std::string_view(model.inputRole(i)) == "condition")
      conditions[id] = (model.inputMin(i) + model.inputMax(i)) / 2;
  }
  tactus::Tube tube(model.scene(conditions));
  // The path of this host: 94 mm straight in, then down the throat.
  const std::vector<Vector> path = {{0, 0, 0}, {0, 0, -0.094}, {0, -0.5, -0.094}};

  using Clock = std::chrono::steady_clock;
  SimulatedDevice device;
  double slowest_us = 0;
  auto next = Clock::now();
  for (int tick = 0; tick < ticks; ++tick) {
    const auto start = Clock::now();
    const OnPath tool = project(path, device.position());                              // 1. position, m
    const tactus::Feel feel = tube.step(1000 * tool.along_m, device.button(), 0.001);  // 2. mm in, N out
    device.setForce(-feel.force_n * tool.inwards);                                     // 3. out of the nose
    const std::chrono::duration<double, std::micro> spent = Clock::now() - start;
    slowest_us = std::max(slowest_us, spent.count());
    device.time_s += 0.001;
    std::this_thread::sleep_until(next += std::chrono::milliseconds(1));  // 4. the next millisecond
  }
  std::printf("%d ticks, largest force %.3f N, slowest tick %.1f us\n", ticks, device.largest_n, slowest_us);
  return 0;
} catch (const tactus::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
