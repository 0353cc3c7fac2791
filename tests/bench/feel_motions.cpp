#include "tests/bench/feel_motions.h"

#include <algorithm>
#include <cmath>

#include "tests/bench/feel_loop.h"
#include "tests/support/loop_measures.h"

namespace tactus::bench {
namespace {

using haptics::HandPlan;

constexpr double kPressS = 0.1;
constexpr double kBeginS = 1.5;  ///< of the motion: the fade-in is over

Motion simulated(Group group, const haptics::SimulatedHand& hand, HandPlan plan, double duration_s,
                 haptics::ServoOrders orders, double start_depth_mm) {
  haptics::VirtualDeviceSettings settings;
  settings.hand = hand;
  settings.count_mm = kCountMm;
  settings.plan = haptics::pressing(haptics::after(kBeginS, std::move(plan)), kPressS);
  orders.placement = 1;
  orders.start_depth_mm = start_depth_mm;
  const FeelRun run =
      runFeelLoop(std::move(settings), orders, static_cast<int>(std::lround(1e3 * (kBeginS + duration_s))));
  Motion motion{group, {}};
  std::vector<support::LoopTick> felt;
  render::Phase before = render::Phase::kReleased;
  for (const FeelTick& tick : run.ticks) {
    const render::Phase phase = tick.sample.phase;
    if (phase != before && before != render::Phase::kReleased) ++motion.transitions;
    before = phase;
    felt.push_back({tick.true_position_mm, tick.sample.force_n});
    SeenTick seen;
    seen.tube_mm = tick.sample.depth_mm;
    seen.sliding = phase == render::Phase::kSlidingIn;
    seen.true_depth_mm = tick.sample.depth_mm + tick.true_position_mm - tick.sample.position_mm;
    seen.true_speed_mm_s = seen.sliding ? std::max(0.0, tick.true_speed_mm_s) : 0;
    seen.rendered_n = tick.sample.model_force_n;
    motion.ticks.push_back(seen);
  }
  motion.ripple_n = support::rippleN(felt);
  return motion;
}

}  // namespace

std::vector<Motion> motions(const haptics::ServoOrders& orders) {
  std::vector<Motion> out;
  for (const haptics::SimulatedHand& hand : {haptics::kPinch, haptics::kArm, haptics::kFiveParameters}) {
    const auto tremor = haptics::swing(0.3, 10);
    out.push_back(simulated(Group::kSlowPush, hand, haptics::push(5), 4, orders, 70));
    for (const double depth_mm : {60.0, 150.0}) {
      out.push_back(simulated(Group::kPush, hand, haptics::push(80), 1.2, orders, depth_mm));
    }
    double depth_mm = 40;
    for (const double duration_s : {0.45, 0.8, 1.2, 2.0}) {
      const auto stroke = haptics::stroke(60, duration_s);
      out.push_back(simulated(Group::kStroke, hand, stroke, duration_s + 0.3, orders, depth_mm));
      out.push_back(
          simulated(Group::kTremorStroke, hand, haptics::both(stroke, tremor), duration_s + 0.3, orders, depth_mm));
      depth_mm += 60;
    }
  }
  return out;
}

}  // namespace tactus::bench
