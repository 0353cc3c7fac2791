// How many nurses, how many questions: whole simulated studies of each design, their error, hours and the cheapest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/planning/nurse_family.h"
#include "core/base/error.h"
#include "elicitation/force/force_terms_from.h"

namespace tactus::planning {

inline constexpr int kMostNurses = 200;
inline constexpr int kMostStudies = 1'000'000;

struct Design {
  int nurses = 4;
  int questions = 45;
  int strokes = 4;  ///< at each speed

  bool operator==(const Design&) const = default;
};

/// Minutes of one nurse's session. Defaults: those with which the program announces the duration of a session.
struct PartMinutes {
  double other = 5;  ///< consent, setup, breaks
  double stroke = 0.2;
  double force = 0.2;
  double question = 1.0 / 6;
};

/// Working hours of the nurses of `design`: nurses · (other + speeds · (strokes + 2 for practice) · stroke +
/// forces · force + questions · question), with the speeds and forces of `asked`.
double hoursOf(const Questions& asked, const Design& design, const PartMinutes& minutes);

struct PlanSettings {
  int least_nurses = 2;
  int most_nurses = 12;
  std::vector<int> questions;  ///< numbers of them, at least one
  std::vector<int> strokes;    ///< numbers at each speed, at least one
  std::string region;          ///< id of a depth term; empty: all regions
  double precision_n = 0.1;
  std::size_t studies = 200;
  std::size_t population = 1000;  ///< nurses whose true models give the truth
  std::size_t points = 64;        ///< where forces are compared
  std::uint64_t seed = 1;
  unsigned threads = 2;  ///< the result does not depend on it
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  RepeatNoise noise;
  PartMinutes minutes;
};

/// One design. The error of one study is the root mean square, over the points, of its averaged force less the truth:
/// the mean force of the true models of the population.
struct DesignError {
  Design design;
  double hours = 0;
  double error_n = 0;  ///< root mean square over the studies; made not to rise with the nurses
  double low_n = 0;    ///< 95 % interval of error_n for the number of studies
  double high_n = 0;
  double simulated_n = 0;  ///< error_n before that
  double p95_n = 0;        ///< 95 % of the studies have at most this error
  double bias_n = 0;       ///< root mean square over the points of the mean error: what no more nurses would remove
  double silent = 0;       ///< share of the forces where no rule fires; the model's default force counts there
  double refused = 0;      ///< share of the studies of which no model can be built; they count nowhere else
};

struct StudyPlan {
  std::vector<std::vector<double>> points;  ///< where forces were compared
  std::vector<double> truth_n;
  std::vector<DesignError> designs;     ///< by strokes, then questions, then nurses, ascending
  std::optional<std::size_t> cheapest;  ///< for the wanted precision

  const DesignError* find(const Design& design) const;
};

/// The design with the fewest hours of which `high_n` is at most `precision_n`: its index.
std::optional<std::size_t> cheapestOf(const StudyPlan& plan, double precision_n);

/// The points of a plan: Halton points over the inputs where a depth term (of `region`, if set) has a membership of at
/// least one half; rates up to 250 mm/s. Refused: an unknown region.
base::Result<std::vector<std::vector<double>>> planPoints(const Questions& questions, const std::string& region,
                                                          std::size_t count);

/// Simulates `settings.studies` studies. All designs of one study have the same nurses: the first ones of them. The
/// same arguments give the same bits. `go_on`: asked from the calling thread with the share that is done; false ends
/// with an error of kind kCancelled. Refused: settings out of range.
base::Result<StudyPlan> planStudy(const Questions& questions, const NurseSource& source, const PlanSettings& settings,
                                  const std::function<bool(double share)>& go_on = {});

}  // namespace tactus::planning
