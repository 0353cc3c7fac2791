// What an edit costs until the recorded strokes have run through it: 40 strokes of a few seconds on a mean of four
// experts. Beside each time the largest difference of the forces to a run in which every tick is computed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/replay/stroke_replay.h"

#include "tests/app/replay/felt_recording.h"
#include "tests/support/invented_experts.h"

namespace tactus::replay {
namespace {

constexpr int kStrokes = 40;
constexpr int kRounds = 15;

struct Edit {
  const char* name;
  std::function<void(fuzzy::ForceModel&)> change;
};

/// Strokes of 1.5 to 4.5 s, from the nostril to the stomach, in four settings of tube and neck.
std::shared_ptr<const std::vector<RecordedStroke>> strokes(const fuzzy::ForceModel& model) {
  std::vector<RecordedStroke> out;
  for (int placement = 0; placement < 4; ++placement) {
    const std::map<std::string, double> conditions = {{"lubrication", placement % 2 == 0 ? .9 : .2},
                                                      {"neck_flexion", placement < 2 ? 60.0 : 10.0}};
    std::vector<Push> pushes;
    for (int i = 0; i < kStrokes / 4; ++i) pushes.push_back({58, 1.5 + i / 3.0, conditions});
    auto found = recordedStrokes({{felt(model, pushes)}, {}, {}});
    std::move(found.begin(), found.end(), std::back_inserter(out));
  }
  return std::make_shared<const std::vector<RecordedStroke>>(std::move(out));
}

double medianMs(const std::function<void()>& run) {
  std::vector<double> times_ms;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    run();
    times_ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times_ms.begin(), times_ms.begin() + kRounds / 2, times_ms.end());
  return times_ms[kRounds / 2];
}

int run() {
  const fuzzy::ForceModel model = support::inventedExperts();
  const auto before = *editing::ready(model);
  const auto recorded = strokes(model);
  std::size_t ticks = 0;
  std::size_t exact = 0;
  for (const RecordedStroke& stroke : *recorded) {
    ticks += stroke.position_mm.size();
    exact += stroke.use == StrokeUse::kExact ? 1 : 0;
  }
  const StrokeBaseline baseline = baselineOf(recorded, before, {});
  std::printf("%zu strokes, %zu ticks, four experts; %zu strokes give their recorded force again bit for bit\n",
              recorded->size(), ticks, exact);
  std::printf("model before, all strokes: %.1f ms\n",
              medianMs([&] { static_cast<void>(baselineOf(recorded, before, {})); }));
  const Edit edits[] = {
      {"one word of one expert", [](auto& m) { m.experts[0].rules[3].then = "large"; }},
      {"a foot of a region",
       [](auto& m) { m.inputs[2].terms[2].points[3] = m.inputs[2].terms[3].points[1] = 202.1074; }},
      {"a word of the force", [](auto& m) { m.output.terms[2].points[2] = m.output.terms[3].points[0] = .55; }},
      {"the weight of an expert", [](auto& m) { m.experts[1].weight = 2; }},
  };
  std::printf("%-26s %10s %10s %10s %10s\n", "edit", "ms", "every tick", "forces", "error, N");
  for (const Edit& edit : edits) {
    fuzzy::ForceModel changed = model;
    edit.change(changed);
    const auto after = *editing::ready(std::move(changed));
    const StrokeComparison quick = compareStrokes(baseline, *after);
    const StrokeComparison all = compareStrokes(baseline, *after, Skip::kNothing);
    std::size_t forces = 0;
    double error_n = 0;
    for (std::size_t i = 0; i < quick.strokes.size(); ++i) {
      forces += quick.strokes[i].asked;
      for (std::size_t tick = 0; tick < quick.strokes[i].after_n.size(); ++tick) {
        error_n = std::max(error_n, std::abs(quick.strokes[i].after_n[tick] - all.strokes[i].after_n[tick]));
      }
    }
    std::printf("%-26s %10.1f %10.1f %10zu %10.1e\n", edit.name,
                medianMs([&] { static_cast<void>(compareStrokes(baseline, *after)); }),
                medianMs([&] { static_cast<void>(compareStrokes(baseline, *after, Skip::kNothing)); }), forces,
                error_n);
  }
  return 0;
}

}  // namespace
}  // namespace tactus::replay

int main() { return tactus::replay::run(); }
