#include "tests/support/simulated_hand.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/random.h"

namespace tactus::support {

namespace {

constexpr double kTickS = 0.001;
constexpr int kSubSteps = 100;

/// Device, hand and arm in SI units.
class Body {
 public:
  Body(const Hand& hand, const Device& device) : hand_(hand), device_(device) {}

  double positionMm() const { return 1e3 * x_; }

  void move(const Wish& wish, double force_n) {
    const double dt = kTickS / kSubSteps;
    const double goal = 1e-3 * wish.position_mm;
    const double goal_speed = 1e-3 * wish.speed_mm_s;
    for (int i = 0; i < kSubSteps; ++i) {
      double hand_n = 0;
      if (hand_.arm_mass_kg > 0) {
        const double grip_n =
            wish.holds ? hand_.stiffness_n_m * (arm_x_ - x_) + hand_.damping_n_s_m * (arm_v_ - v_) : 0;
        const double arm_n =
            hand_.arm_stiffness_n_m * (goal - arm_x_) + hand_.arm_damping_n_s_m * (goal_speed - arm_v_);
        arm_v_ += dt * (arm_n - grip_n) / hand_.arm_mass_kg;
        arm_x_ += dt * arm_v_;
        hand_n = grip_n;
      } else if (wish.holds) {
        hand_n = hand_.stiffness_n_m * (goal - x_) + hand_.damping_n_s_m * (goal_speed - v_);
      }
      const double mass = device_.mass_kg + (wish.holds ? hand_.mass_kg : 0);
      v_ += dt * (hand_n - device_.damping_n_s_m * v_ - force_n) / mass;
      const double friction = std::min(std::abs(v_), dt * device_.dry_friction_n / mass);
      v_ -= std::copysign(friction, v_);
      x_ += dt * v_;
    }
  }

 private:
  const Hand& hand_;
  const Device& device_;
  double x_ = 0, v_ = 0, arm_x_ = 0, arm_v_ = 0;
};

}  // namespace

Plan stroke(double length_mm, double duration_s) {
  return [=](double time_s) -> Wish {
    const double u = std::clamp(time_s / duration_s, 0.0, 1.0);
    return {length_mm * u * u * u * (10 - 15 * u + 6 * u * u), length_mm / duration_s * 30 * u * u * (1 - u) * (1 - u)};
  };
}

Plan push(double speed_mm_s) {
  return [=](double time_s) -> Wish { return {speed_mm_s * time_s, speed_mm_s}; };
}

Plan tremor(double amplitude_mm, double frequency_hz) {
  const double omega = 2 * std::numbers::pi * frequency_hz;
  return [=](double time_s) -> Wish {
    return {amplitude_mm * std::sin(omega * time_s), amplitude_mm * omega * std::cos(omega * time_s)};
  };
}

Plan both(Plan one, Plan other) {
  return [one = std::move(one), other = std::move(other)](double time_s) -> Wish {
    const Wish a = one(time_s);
    const Wish b = other(time_s);
    return {a.position_mm + b.position_mm, a.speed_mm_s + b.speed_mm_s, a.holds && b.holds};
  };
}

Plan lettingGo(Plan plan, double at_s) {
  return [plan = std::move(plan), at_s](double time_s) {
    Wish wish = plan(time_s);
    wish.holds = wish.holds && time_s < at_s;
    return wish;
  };
}

std::vector<LoopTick> simulateLoop(const Hand& hand, const Device& device, const Plan& plan, double duration_s,
                                   const Servo& servo, const Disturbance& disturbance) {
  Body body(hand, device);
  base::Random random(disturbance.seed);
  const int count = static_cast<int>(std::lround(duration_s / kTickS));
  std::vector<LoopTick> ticks;
  ticks.reserve(static_cast<std::size_t>(count));
  std::vector<double> on_the_way(static_cast<std::size_t>(device.delay_ticks) + 1, 0.0);
  int last_served = -1;
  int stalled_until = 0;
  for (int i = 0; i < count; ++i) {
    const double time_s = i * kTickS;
    const double measured_mm =
        device.count_mm > 0 ? device.count_mm * std::round(body.positionMm() / device.count_mm) : body.positionMm();
    if (random.uniform() < disturbance.stalls_per_s * kTickS) stalled_until = i + 2 + random.below(4);
    const bool dropped = random.uniform() < disturbance.dropped_share;
    double answer_n = on_the_way.back();
    if (i >= stalled_until && !dropped) {
      answer_n = servo(time_s, measured_mm, (i - last_served) * kTickS);
      last_served = i;
    }
    std::rotate(on_the_way.begin(), on_the_way.begin() + 1, on_the_way.end());
    on_the_way.back() = answer_n;
    ticks.push_back({body.positionMm(), on_the_way.front()});
    body.move(plan(time_s), ticks.back().force_n);
  }
  return ticks;
}

double lowestEnergyMj(const std::vector<LoopTick>& ticks) {
  double energy = 0;
  double lowest = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    energy += ticks[i - 1].force_n * (ticks[i].position_mm - ticks[i - 1].position_mm);
    lowest = std::min(lowest, energy);
  }
  return lowest;
}

double largestStepN(const std::vector<LoopTick>& ticks) {
  double largest = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    largest = std::max(largest, std::abs(ticks[i].force_n - ticks[i - 1].force_n));
  return largest;
}

double rippleN(const std::vector<LoopTick>& ticks) {
  const double w = std::tan(std::numbers::pi * 30 * kTickS);
  const double norm = 1 / (1 + std::numbers::sqrt2 * w + w * w);
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0, sum = 0;
  for (const LoopTick& tick : ticks) {
    const double y =
        norm * (tick.force_n - 2 * x1 + x2 - 2 * (w * w - 1) * y1 - (1 - std::numbers::sqrt2 * w + w * w) * y2);
    x2 = std::exchange(x1, tick.force_n);
    y2 = std::exchange(y1, y);
    sum += y * y;
  }
  return std::sqrt(sum / static_cast<double>(ticks.size()));
}

double lastSpeedMmS(const std::vector<LoopTick>& ticks) {
  const std::size_t window = std::min<std::size_t>(500, ticks.size() - 1);
  double sum = 0;
  for (std::size_t i = ticks.size() - window; i < ticks.size(); ++i) {
    const double speed = (ticks[i].position_mm - ticks[i - 1].position_mm) / kTickS;
    sum += speed * speed;
  }
  return std::sqrt(sum / static_cast<double>(window));
}

}  // namespace tactus::support
