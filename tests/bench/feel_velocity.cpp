#include "tests/bench/feel_velocity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "core/haptics/device/velocity_estimator.h"

#include "tests/bench/cases.h"
#include "tests/bench/feel_loop.h"
#include "tests/bench/feel_motions.h"
#include "tests/bench/interleaved.h"
#include "tests/bench/text_table.h"
#include "tests/support/loop_measures.h"

namespace tactus::bench {
namespace {

using haptics::AdaptiveWindowVelocity;

constexpr double kCornersHz[] = {10, 15, 20, 25, 30, 40, 60, 100};  ///< of the low-passes; the default is 25
constexpr int kLeastLagTicks = -3;
constexpr int kMostLagTicks = 60;
constexpr std::size_t kSettlingTicks = 50;  ///< after the break-away, left out of the noise

/// Speeds of the tube at all ticks of a motion.
using Speeds = std::vector<double>;

struct Estimator {
  std::string name;
  std::function<Speeds(const std::vector<SeenTick>&)> speeds;
};

template <typename T>
Estimator estimator(std::string name, T fresh) {
  return {std::move(name), [fresh](const std::vector<SeenTick>& ticks) {
            T running = fresh;
            Speeds out;
            out.reserve(ticks.size());
            for (const SeenTick& tick : ticks) out.push_back(running.next(tick.tube_mm, kFeelTickS));
            return out;
          }};
}

std::vector<Estimator> estimators() {
  std::vector<Estimator> out = {estimator("difference", haptics::DifferenceVelocity())};
  for (const double corner_hz : kCornersHz) {
    out.push_back(
        estimator("two low-passes at " + threeDigits(corner_hz) + " Hz", haptics::LowPassVelocity(corner_hz)));
  }
  for (const auto& [line, name] : {std::pair{AdaptiveWindowVelocity::Line::kEndFit, "window, end-fit, "},
                                   std::pair{AdaptiveWindowVelocity::Line::kBestFit, "window, best-fit, "}}) {
    for (const double counts : {1.0, 1.5, 2.0}) {
      out.push_back(estimator(name + threeDigits(counts) + " counts", AdaptiveWindowVelocity(line, counts * kCountMm)));
    }
  }
  return out;
}

/// Correlation of the estimated speed with the true speed `lag` ticks before; [kLeastLagTicks, kMostLagTicks].
double correlation(const std::vector<Speeds>& seen, const std::vector<Motion>& all, int lag) {
  double xx = 0, yy = 0, xy = 0, x_sum = 0, y_sum = 0, count = 0;
  for (std::size_t m = 0; m < all.size(); ++m) {
    const auto end = static_cast<int>(all[m].ticks.size()) + kLeastLagTicks;
    for (int i = kMostLagTicks; i < end; ++i) {
      const double x = seen[m][static_cast<std::size_t>(i)];
      const double y = all[m].ticks[static_cast<std::size_t>(i - lag)].true_speed_mm_s;
      xx += x * x, yy += y * y, xy += x * y, x_sum += x, y_sum += y, ++count;
    }
  }
  return (xy - x_sum * y_sum / count) / std::sqrt((xx - x_sum * x_sum / count) * (yy - y_sum * y_sum / count));
}

/// The lag of the largest correlation, between ticks by a parabola, ms.
double lagMs(const std::vector<Speeds>& seen, const std::vector<Motion>& all) {
  std::vector<double> at;
  for (int lag = kLeastLagTicks; lag <= kMostLagTicks; ++lag) at.push_back(correlation(seen, all, lag));
  const auto best = static_cast<std::size_t>(std::max_element(at.begin(), at.end()) - at.begin());
  TACTUS_CHECK(best > 0 && best + 1 < at.size());
  const double before = at[best - 1], after = at[best + 1];
  return kLeastLagTicks + static_cast<double>(best) + 0.5 * (before - after) / (before - 2 * at[best] + after);
}

struct ForceErrors {
  double squares = 0;
  double largest_n = 0;
  double ticks = 0;
  double noise_squares = 0;
  double noise_ticks = 0;

  /// Errors of one motion while the tube slides in. How late the speed is at the break-away is no noise.
  void add(const std::vector<double>& errors_n) {
    for (const double error_n : errors_n) {
      squares += error_n * error_n;
      largest_n = std::max(largest_n, std::abs(error_n));
    }
    ticks += static_cast<double>(errors_n.size());
    std::vector<support::LoopTick> settled;
    for (std::size_t i = kSettlingTicks; i < errors_n.size(); ++i) {
      settled.push_back({0, errors_n[i] - errors_n[kSettlingTicks]});
    }
    if (settled.empty()) return;
    const auto count = static_cast<double>(settled.size());
    const double noise_n = support::rippleN(settled);
    noise_squares += noise_n * noise_n * count;
    noise_ticks += count;
  }
  double rmsN() const { return std::sqrt(squares / ticks); }
  double noiseN() const { return std::sqrt(noise_squares / noise_ticks); }
};

double exactN(const haptics::ServoScene& scene, const SeenTick& tick) {
  return scene.force({tick.true_depth_mm, tick.true_speed_mm_s}).force_n;
}

void addErrors(FeelPart& part, const std::string& name, const std::vector<Motion>& all,
               const std::function<std::vector<double>(std::size_t)>& errors_n) {
  ForceErrors whole;
  std::vector<ForceErrors> groups(std::size(kGroups));
  for (std::size_t m = 0; m < all.size(); ++m) {
    const auto errors = errors_n(m);
    whole.add(errors);
    groups[static_cast<std::size_t>(all[m].group)].add(errors);
  }
  part.add(name, "force error, rms", "mN", 1e3 * whole.rmsN());
  part.add(name, "largest", "mN", 1e3 * whole.largest_n);
  part.add(name, "noise above 30 Hz, rms", "mN", 1e3 * whole.noiseN());
  for (const auto& [group, text] : kGroups) {
    const ForceErrors& errors = groups[static_cast<std::size_t>(group)];
    part.add(name, "rms in " + std::string(text), "mN", 1e3 * errors.rmsN());
    if (group == Group::kPush) part.add(name, "noise in " + std::string(text), "mN", 1e3 * errors.noiseN());
  }
}

fuzzy::ForceModel modelFilteredAt(double corner_hz) {
  fuzzy::ForceModel model = syntheticExperts(4);
  model.renderer.emplace().velocity_filter_hz = corner_hz;
  return model;
}

/// F_d of the renderer itself, in loops of its own with another filter.
void addRenderer(FeelPart& part, double corner_hz) {
  const haptics::ServoOrders orders = feelOrders(feelScene(modelFilteredAt(corner_hz)));
  const std::vector<Motion> all = motions(orders);
  const std::string name = "renderer in the loop, " + threeDigits(corner_hz) + " Hz";
  addErrors(part, name, all, [&](std::size_t m) {
    std::vector<double> errors_n;
    for (const SeenTick& tick : all[m].ticks) {
      if (tick.sliding) errors_n.push_back(tick.rendered_n - exactN(*orders.scene, tick));
    }
    return errors_n;
  });
  double ripple_n = 0;
  int transitions = 0;
  for (const Motion& motion : all) {
    if (motion.group == Group::kSlowPush) ripple_n = std::max(ripple_n, motion.ripple_n);
    if (motion.group != Group::kTremorStroke) transitions = std::max(transitions, motion.transitions);
  }
  part.add(name, "largest ripple felt in push at 5 mm/s", "mN", 1e3 * ripple_n);
  part.add(name, "most transitions without tremor", "1", transitions);
}

}  // namespace

FeelPart measureVelocityEstimators(int rounds) {
  FeelPart part{"velocity",
                "Force at the counted depth and the estimated speed against the exact model at the true depth and the "
                "true speed, while the tube slides in",
                {},
                {}};
  const haptics::ServoOrders orders =
      feelOrders(feelScene(modelFilteredAt(fuzzy::RendererParameters{}.velocity_filter_hz)));
  const haptics::ServoScene& scene = *orders.scene;
  const std::vector<Motion> all = motions(orders);
  const std::vector<Estimator> every = estimators();

  std::vector<Job> jobs;
  jobs.reserve(every.size());
  for (const Estimator& one : every) {
    jobs.push_back({one.name, 1, [&one, &all](std::size_t /*first*/, std::span<double> out) {
                      out.front() = 0;
                      for (const Motion& motion : all) out.front() += one.speeds(motion.ticks).back();
                    }});
  }
  const auto timed = timeInterleaved(jobs, {.rounds = std::max(3, rounds / 10)});
  double ticks = 0;
  for (const Motion& motion : all) ticks += static_cast<double>(motion.ticks.size());

  for (std::size_t e = 0; e < every.size(); ++e) {
    std::vector<Speeds> seen;
    std::vector<double> speed_errors;
    for (const Motion& motion : all) {
      seen.push_back(every[e].speeds(motion.ticks));
      for (std::size_t i = 0; i < motion.ticks.size(); ++i) {
        const double error_mm_s = seen.back()[i] - motion.ticks[i].true_speed_mm_s;
        if (motion.ticks[i].sliding) speed_errors.push_back(error_mm_s * error_mm_s);
      }
    }
    addErrors(part, every[e].name, all, [&](std::size_t m) {
      std::vector<double> errors_n;
      for (std::size_t i = 0; i < all[m].ticks.size(); ++i) {
        const SeenTick& tick = all[m].ticks[i];
        if (!tick.sliding) continue;
        errors_n.push_back(scene.force({tick.tube_mm, std::max(0.0, seen[m][i])}).force_n - exactN(scene, tick));
      }
      return errors_n;
    });
    part.add(every[e].name, "speed error, rms", "mm/s", std::sqrt(base::mean(speed_errors)));
    part.add(every[e].name, "lag", "ms", lagMs(seen, all));
    part.add(every[e].name, "cost", "ns", timed.timings[e].median_ns / ticks);
  }
  for (const double corner_hz : kCornersHz) addRenderer(part, corner_hz);
  part.notes = {
      "Motions: " + std::to_string(all.size()) +
          " closed loops with the virtual device (simulated, no person made them): " +
          "pinch, arm, five-parameter; strokes of 60 mm in 0.45 to 2 s at depths of 40 to 280 mm, with and "
          "without tremor "
          "of 0.3 mm at 10 Hz, and even pushes; counts of 0.055 mm, four experts",
      "All estimators see what the renderer filters, the way of the tube, in the same loops (renderer at 25 Hz)",
      "Renderer in the loop: its own F_d, with the tick that it is behind and its slew of 50 N/s, in loops of its own",
      "Lag: of the largest correlation with the true speed. Noise: of the error from 50 ms after the "
      "break-away on, second-order high-pass"};
  return part;
}

}  // namespace tactus::bench
