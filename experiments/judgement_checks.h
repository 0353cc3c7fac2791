// Consistency checks of one participant's force judgements. For the researcher only; no judgement is ever left out
// because of a check.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/study/ordered_probit.h"
#include "core/study/session_records.h"

namespace tactus::experiments {

// Agreement of two series of ordered answers beyond chance.

/// Cohen's kappa with quadratic weights (Cohen 1968; Fleiss and Cohen 1973): 1 - (sum of squared differences) / (the
/// same sum expected by chance from the shares of both sides). `pairs`: indices of categories from 0. Nothing if there
/// are no pairs, or if all answers are one category.
std::optional<double> quadraticWeightedKappa(std::span<const std::pair<std::size_t, std::size_t>> pairs);

/// Pairs of forces of one series in which the larger force got the lower term.
struct MonotonicityCheck {
  std::string series;
  std::size_t pairs = 0;       ///< pairs of judgements of different forces
  std::size_t violations = 0;  ///< pairs in which the larger force has the lower term
};

/// Difference between the ascending and the descending series at equal forces.
struct HysteresisCheck {
  std::size_t forces = 0;  ///< forces judged with a term in both series
  /// Mean of (index of the ascending term - index of the descending term), in terms. Positive if forces seem larger in
  /// the ascending series. Empty if the series have no common force.
  std::optional<double> index;
};

/// Agreement of the answers to equal forces in one series (the random block, or a ladder with hidden repeats), over all
/// pairs of judgements, the earlier one first.
struct RepeatCheck {
  std::size_t pairs = 0;
  std::optional<double> kappa;        ///< quadratic weights (judgement_checks.h)
  std::optional<double> within_one;   ///< share of pairs that differ by at most one term
  std::size_t hidden_pairs = 0;       ///< pairs with a hidden repeat as the later judgement
  std::optional<double> hidden_same;  ///< share of hidden_pairs with equal terms
};

struct BlankCheck {
  std::size_t blanks = 0;        ///< judgements at 0 N
  std::size_t false_alarms = 0;  ///< blanks judged as felt
};

struct ResponseTimeCheck {
  std::size_t judgements = 0;
  std::optional<double> median_s;
  /// Indices of the records with outlying times: more than 1.5 interquartile distances outside the quartiles (Tukey
  /// 1977). Uses a logarithmic scale, because response times are skewed. None for fewer than 8 judgements.
  std::vector<std::size_t> outliers;
};

struct MotionCheck {
  std::size_t judgements = 0;         ///< scored judgements
  std::optional<double> median_mm_s;  ///< forward speed during the judgement
  std::optional<double> slowest_mm_s;
  std::optional<double> fastest_mm_s;
  std::size_t repeated = 0;  ///< attempts without forward motion or without the whole force, which were repeated
  /// Steps that no attempt scored and after which the experiment went on (ForceSettings::attempts_most).
  std::size_t left_out = 0;
};

/// A statement about the judgements.
struct JudgementFinding {
  std::string check;     ///< `monotonicity`, `hysteresis`, `repeats`, `blanks`, `response_time`, `motion`, `thresholds`
  bool notable = false;  ///< deserves the researcher's attention
  std::string sentence;
};

struct JudgementChecks {
  std::vector<MonotonicityCheck> monotonicity;  ///< per series, in the order of the records
  HysteresisCheck hysteresis;
  RepeatCheck repeats;
  BlankCheck blanks;
  ResponseTimeCheck response_time;
  MotionCheck motion;
  study::TermThresholds thresholds;  ///< from the scored judgements with a term, of all series, without blanks
  std::vector<JudgementFinding> findings;
};

/// Checks the judgements of one session. `terms`: ids, smallest force first, at least two. Corrected records are left
/// out. Unless a check states otherwise, it uses scored judgements with one of `terms` only; `not_felt`,
/// `beyond_practice` and unknown terms do not count.
JudgementChecks checkJudgements(std::span<const study::JudgementRecord> records, std::span<const std::string> terms);

}  // namespace tactus::experiments
