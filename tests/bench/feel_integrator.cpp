#include "tests/bench/feel_integrator.h"

#include <algorithm>
#include <cmath>

#include "core/haptics/simulated/virtual_device.h"

#include "tests/bench/interleaved.h"

namespace tactus::bench {
namespace {

using haptics::DeviceMechanics;
using haptics::HandPlan;
using haptics::SimulatedBody;
using haptics::SimulatedHand;

constexpr int kMilliseconds = 1000;
constexpr int kFinest = 100'000;  ///< steps per ms of the reference: a hundredth of the smallest step that is compared
constexpr int kStepsPerMs[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

/// A simulated second of a hand. The device resists with a spring that gives way, held for a tick as a servo holds it.
struct Subject {
  std::string name;
  SimulatedHand hand;
  DeviceMechanics device;
  HandPlan plan;
  double start_mm = 0;
  double spring_n_mm = 0;
  double largest_n = 0;
};

/// The position after each millisecond.
std::vector<double> simulated(const Subject& subject, int steps_per_ms) {
  SimulatedBody body(subject.hand, subject.device, subject.start_mm);
  std::vector<double> positions_mm;
  positions_mm.reserve(kMilliseconds);
  for (int ms = 0; ms < kMilliseconds; ++ms) {
    const haptics::HandTarget wish = subject.plan(1e-3 * ms);
    const double resistance_n =
        std::clamp(subject.spring_n_mm * body.positionMm(), -subject.largest_n, subject.largest_n);
    for (int step = 0; step < steps_per_ms; ++step) body.step(wish, resistance_n, 1e-3 / steps_per_ms);
    positions_mm.push_back(body.positionMm());
  }
  return positions_mm;
}

constexpr double kStartMm = 10;

/// A pinch grip that holds 0 and is let go at 10 mm, without dry friction.
Subject ringing() {
  return {"pinch, ringing (closed form)",
          haptics::kPinch,
          {0.045, 0.2, 0},
          [](double) { return haptics::HandTarget{}; },
          kStartMm,
          0,
          0};
}

/// The same as a damped oscillator.
std::vector<double> ringingExactly() {
  constexpr double kMass = 0.145, kDamping = 1.7, kSpring = 100;
  constexpr double kDecay = kDamping / (2 * kMass);
  const double omega = std::sqrt(kSpring / kMass - kDecay * kDecay);
  std::vector<double> positions_mm;
  for (int ms = 1; ms <= kMilliseconds; ++ms) {
    const double t = 1e-3 * ms;
    positions_mm.push_back(kStartMm * std::exp(-kDecay * t) *
                           (std::cos(omega * t) + kDecay / omega * std::sin(omega * t)));
  }
  return positions_mm;
}

Subject strokeOf(const SimulatedHand& hand) {
  return {std::string(hand.name) + ", stroke against a spring", hand, {}, haptics::stroke(60, 0.8), 0, 0.25, 0.4};
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

FeelPart measureIntegrator(int rounds) {
  FeelPart part{"integrator",
                "Steps per millisecond of the simulated hand: largest error of the position within a second",
                {},
                {"A stroke of 60 mm in 0.8 s, spring of 0.25 N/mm that gives way at 0.4 N, dry friction of the device; "
                 "errors against 100,000 steps per ms. Ringing: against the closed form, without dry friction",
                 "One count of the device is 0.055 mm"}};
  std::vector<Job> jobs;
  const Subject timed_subject = strokeOf(haptics::kPinch);
  for (const int steps : kStepsPerMs) {
    jobs.push_back({"", 1, [&timed_subject, steps](std::size_t /*first*/, std::span<double> out) {
                      out.front() = simulated(timed_subject, steps).back();
                    }});
  }
  const auto timed = timeInterleaved(jobs, {.rounds = std::max(3, rounds / 4)});

  const auto row = [](int steps) { return std::to_string(steps) + (steps == 1 ? " step per ms" : " steps per ms"); };
  const auto compare = [&](const Subject& subject, const std::vector<double>& reference_mm) {
    for (const int steps : kStepsPerMs) {
      part.add(row(steps), subject.name, "mm", largestDifference(simulated(subject, steps), reference_mm));
    }
  };
  compare(ringing(), ringingExactly());
  for (const SimulatedHand& hand : {haptics::kPinch, haptics::kArm, haptics::kFiveParameters}) {
    compare(strokeOf(hand), simulated(strokeOf(hand), kFinest));
  }
  for (std::size_t i = 0; i < std::size(kStepsPerMs); ++i) {
    part.add(row(kStepsPerMs[i]), "time of a simulated ms", "ns", timed.timings[i].median_ns / kMilliseconds);
  }
  return part;
}

}  // namespace tactus::bench
