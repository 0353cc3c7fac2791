// How consistent one participant's force judgements are. For researchers to see; nothing is ever left out because of
// it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/study/session_records.h"
#include "experiments/ordered_probit.h"

namespace tactus::experiments {

/// Pairs of forces of one series whose term falls though the force rises.
struct MonotonicityCheck {
  std::string series;
  std::size_t pairs = 0;       ///< pairs of judgements of different forces
  std::size_t violations = 0;  ///< of these, the larger force has the lower term
};

/// How the ascending and the descending series differ at the same force.
struct HysteresisCheck {
  std::size_t forces = 0;  ///< judged with a term in both series
  /// Mean of (place of the ascending term - place of the descending term), in terms: positive where forces seem larger
  /// on the way up. Absent where no force is in both.
  std::optional<double> index;
};

/// How alike the answers to the same force in the random block are: each pair of judgements, the earlier one first.
struct RepeatCheck {
  std::size_t pairs = 0;
  std::optional<double> kappa;        ///< quadratic weights (weighted_kappa.h)
  std::optional<double> within_one;   ///< share of pairs that differ by one term at most
  std::size_t hidden_pairs = 0;       ///< pairs whose later judgement is a hidden repeat
  std::optional<double> hidden_same;  ///< share of these with the same term
};

struct BlankCheck {
  std::size_t blanks = 0;        ///< judged at 0 N
  std::size_t false_alarms = 0;  ///< of these, said to be felt
};

struct ResponseTimeCheck {
  std::size_t judgements = 0;
  std::optional<double> median_s;
  /// Indices into the records of times outside the quartiles by more than 1.5 times their distance (Tukey 1977), on a
  /// logarithmic scale, because response times are skewed. None for fewer than 8 judgements.
  std::vector<std::size_t> outliers;
};

struct MotionCheck {
  std::size_t judgements = 0;         ///< scored ones
  std::optional<double> median_mm_s;  ///< forward speed while judging
  std::optional<double> slowest_mm_s;
  std::optional<double> fastest_mm_s;
  std::size_t repeated = 0;  ///< attempts without forward motion or without the whole force, which were repeated
};

/// One thing worth saying of the judgements.
struct JudgementFinding {
  std::string check;     ///< `monotonicity`, `hysteresis`, `repeats`, `blanks`, `response_time`, `motion`, `thresholds`
  bool notable = false;  ///< worth a second look
  std::string sentence;
};

struct JudgementChecks {
  std::vector<MonotonicityCheck> monotonicity;  ///< per series, in the order of the records
  HysteresisCheck hysteresis;
  RepeatCheck repeats;
  BlankCheck blanks;
  ResponseTimeCheck response_time;
  MotionCheck motion;
  TermThresholds thresholds;  ///< from the scored judgements with a term, of all series, without blanks
  std::vector<JudgementFinding> findings;
};

/// Checks the judgements of one session. `terms`: ids, least first, at least two. Records that another one corrects are
/// left out, as they are everywhere. Only scored judgements with one of the five terms enter, except where a check says
/// otherwise: `not_felt` and `beyond_practice` are no terms. A term that is not in `terms` counts as none.
JudgementChecks checkJudgements(std::span<const study::JudgementRecord> records, std::span<const std::string> terms);

}  // namespace tactus::experiments
