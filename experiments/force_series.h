// The series of forces of the force-perception experiment: which forces are felt, in which order.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace tactus::experiments {

/// Equal steps of force.
struct ForceSteps {
  double lowest_n = 0.1;
  double highest_n = 1.7;
  double step_n = 0.1;

  /// How many forces there are, both ends included.
  int count() const;
  /// Force number `i` from 0, rounded to a micronewton, so that 0.1 N + 2 · 0.1 N is 0.3 N.
  double at(int i) const;
};

/// Everything that can be set; the defaults are the paper's experiment (Section 3.1.5): the ascending series alone.
struct ForceSettings {
  std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large"};  ///< ids, least first

  /// Felt before the series, without labels and without answers, so that the first answers know the range. Our
  /// addition; empty = none.
  std::vector<double> familiarisation_n = {0.1, 0.6, 1.1};

  bool ascending = true;  ///< the paper's series; ends at the first answer `beyond_practice`
  ForceSteps ladder;      ///< of the ascending and the descending series

  /// Our addition: back down from the force that the ascending series reached, against the errors of habituation and
  /// expectation. It starts `descending_offset_most` steps lower at most, so that nobody counts steps.
  bool descending = false;
  int descending_offset_most = 2;  ///< 0 to 5

  /// Our addition: the forces of `random_steps` in random order, each `random_repeats` times. No force twice running,
  /// never two changes of more than `random_widest_jump` steps running.
  bool random = false;
  ForceSteps random_steps = {0.1, 1.1, 0.1};
  int random_repeats = 3;      ///< 1 to 10
  int random_widest_jump = 6;  ///< steps
  double catch_share = 0.13;   ///< share of blanks (0 N) and hidden repeats in the block: 0.10 to 0.15, or 0 for none

  /// A judgement counts only if the hand moved forward while it felt the force: the device's own friction hides small
  /// forces from a resting hand and adds to what a moving hand feels. Measured by ForwardMotion.
  double forward_least_mm = 10;             ///< way
  double forward_least_mm_s = 10;           ///< slower stretches are no way; the slowest mean of Table 1 is 31 mm/s
  std::optional<double> device_friction_n;  ///< against forward motion, as measured; added to the felt force; 0 to 1

  double ramp_s = 0.15;        ///< from no force to the full force; 0.05 to 1
  double continuous_n = 0.88;  ///< force that the device can hold for ever (a Touch)
  double hold_limit_s = 3;     ///< a larger force is held this long at most, then it fades; the question stays
  double pause_s = 2;          ///< without force before each step; at least 2
  int rest_every = 20;         ///< after so many steps a rest is offered; 0 = never
  double start_zone_mm = 10;   ///< a step starts when the stylus is held within this way of its place of rest
};

/// Refuses settings that make no sense, with one sentence. Forces are above 0 and at most kHighestForceN.
base::Result<void> validate(const ForceSettings& settings);

/// No stimulus is larger: the highest limit that an expert can unlock.
inline constexpr double kHighestForceN = 3;

inline constexpr const char* kFamiliarisation = "familiarisation";
inline constexpr const char* kAscending = "ascending";
inline constexpr const char* kDescending = "descending";
inline constexpr const char* kRandom = "random";

/// One force to be felt.
struct ForceStep {
  std::string series;
  int step = 1;  ///< from 1, place in the series
  double force_n = 0;
  bool catch_trial = false;  ///< a blank, where the force is 0, or a hidden repeat

  bool operator==(const ForceStep&) const = default;
};

std::vector<ForceStep> familiarisationSeries(const ForceSettings& settings);
std::vector<ForceStep> ascendingSeries(const ForceSettings& settings);

/// From `start_n` down to the lowest force of the ladder.
std::vector<ForceStep> descendingSeries(const ForceSettings& settings, double start_n);
/// Where the descending series starts after an ascending one that reached `reached_n`: lower by a number of steps that
/// follows from the seed, never below the lowest force.
double descendingStart(const ForceSettings& settings, double reached_n, std::uint64_t seed);

/// The random block. Half of the catch trials (rounded up) are blanks, which come neither first nor one after another;
/// the others are forces that come once more than the rest, marked at their last time. The order is drawn step by step
/// among what is left and allowed, and drawn anew where nothing is. Refused: settings that leave no allowed order.
base::Result<std::vector<ForceStep>> randomBlock(const ForceSettings& settings, std::uint64_t seed);

}  // namespace tactus::experiments
