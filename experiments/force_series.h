// The series of forces of the force-perception experiment: their values and their order.
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

  /// The number of forces, including both ends.
  int count() const;
  /// Force number `i` from 0, rounded to a micronewton, so that 0.1 N + 2 · 0.1 N is 0.3 N.
  double at(int i) const;
};

/// The settings of the experiment. The defaults are the paper's experiment (Section 3.1.5): the ascending series alone.
struct ForceSettings {
  std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large"};  ///< ids, least first

  /// Forces before the series for practice, asked like the others and never scored. One in the middle shows what is
  /// asked without showing the range of the forces. Our addition; empty: none.
  std::vector<double> familiarisation_n = {0.5};

  bool ascending = true;  ///< the paper's series; ends at the first answer `beyond_practice`
  ForceSteps ladder;      ///< for the ascending and the descending series

  /// Our addition: a descending series from the force that the ascending series reached, against the errors of
  /// habituation and expectation. It starts up to `descending_offset_most` steps lower, so that the participant cannot
  /// count steps.
  bool descending = false;
  int descending_offset_most = 2;  ///< 0 to 5

  /// Our addition: catch trials in each of the two series, as `withCatchTrials` puts them there. 0 to 4.
  int ladder_catches = 0;

  /// Our addition: the forces of `random_steps` in random order, each `random_repeats` times. No force follows itself,
  /// and two changes of more than `random_widest_jump` steps never follow each other.
  bool random = false;
  ForceSteps random_steps = {0.1, 1.1, 0.1};
  int random_repeats = 3;      ///< 1 to 10
  int random_widest_jump = 6;  ///< steps
  double catch_share = 0.13;   ///< share of blanks (0 N) and hidden repeats in the block: 0.10 to 0.15, or 0 for none

  /// A judgement counts only if the hand moved forward during the force. The device's own friction hides small forces
  /// from a resting hand and adds to the force on a moving hand. Measured by ForwardMotion.
  double forward_least_mm = 10;    ///< forward travel
  double forward_least_mm_s = 10;  ///< slower motion does not count; the slowest mean of Table 1 is 31 mm/s
  std::optional<double>
      device_friction_n;  ///< measured against forward motion; added to the felt force, times the scale; 0 to 1

  double device_scale = 1;  ///< the device gives the forces divided by it (procedure::Procedure); 1 to 20

  double ramp_s = 0.15;        ///< from zero to the full force; 0.05 to 1
  double continuous_n = 0.88;  ///< force that the device can hold permanently (a Touch)
  double hold_limit_s = 3;     ///< longest time for a larger force, which then fades; the question stays
  double pause_s = 2;          ///< without force before each step; at least 2
  int rest_every = 20;         ///< number of steps between offered rests; 0: never
  int attempts_most = 6;       ///< a step that was not scored so often is left out; 2 to 20
  bool delivered = true;       ///< false: the device gives no force; each step comes once, and none is scored
  double start_zone_mm = 10;   ///< a step starts when the stylus is within this distance of its rest position
};

/// Returns an error with one sentence for invalid settings. Forces must be above 0 and at most kHighestForceN times the
/// scale.
base::Result<void> validate(const ForceSettings& settings);

/// Largest stimulus: the highest limit that an expert can unlock.
inline constexpr double kHighestForceN = 3;

inline constexpr const char* kFamiliarisation = "familiarisation";
inline constexpr const char* kAscending = "ascending";
inline constexpr const char* kDescending = "descending";
inline constexpr const char* kRandom = "random";

/// One stimulus of a series. `step` counts catch trials too.
struct SeriesStep {
  std::string series;
  int step = 1;  ///< from 1, place in the series
  double force_n = 0;
  bool catch_trial = false;  ///< a blank (force 0) or a hidden repeat

  bool operator==(const SeriesStep&) const = default;
};

std::vector<SeriesStep> familiarisationSeries(const ForceSettings& settings);
std::vector<SeriesStep> ascendingSeries(const ForceSettings& settings);

/// From `start_n` down to the lowest force of the ladder.
std::vector<SeriesStep> descendingSeries(const ForceSettings& settings, double start_n);
/// `series` with `settings.ladder_catches` catch trials at places derived from the seed: blanks (the larger half) and
/// hidden repeats of a force that came two to four steps earlier. None comes before the third step or after the last
/// one, and a step of the series stands between two of them. An ascending series, which may end early, has them in its
/// first 60 %. A series too short for all of them has fewer. The steps are numbered anew.
std::vector<SeriesStep> withCatchTrials(std::vector<SeriesStep> series, const ForceSettings& settings,
                                        std::uint64_t seed);
/// The start of the descending series after an ascending one that reached `reached_n`. It is lower by a number of steps
/// derived from the seed, but never below the lowest force.
double descendingStart(const ForceSettings& settings, double reached_n, std::uint64_t seed);

/// The random block. Half of the catch trials (rounded up) are blanks; a blank is never first and never follows a
/// blank. The other catch trials are forces with one extra occurrence, marked at their last one. The order is drawn
/// step by step from the remaining allowed forces, and drawn again if none is allowed. Returns an error if the settings
/// allow no order.
base::Result<std::vector<SeriesStep>> randomBlock(const ForceSettings& settings, std::uint64_t seed);

}  // namespace tactus::experiments
