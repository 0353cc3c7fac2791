// Mean, deviation and range of the answers on a rating scale, as the paper's Table 3 prints them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/study/session_records.h"
#include "questionnaires/scale_form.h"

namespace tactus::questionnaires {

/// One row of Table 3.
struct ScaleSummary {
  int item = 0;
  std::size_t n = 0;  ///< answers
  double mean = 0;    ///< 0 where n = 0, as are the others
  double sd = 0;      ///< n - 1 in the denominator; 0 for fewer than two answers
  int min = 0;
  int max = 0;

  bool operator==(const ScaleSummary&) const = default;
};

/// One row per item of `form`, over the answers that no later record supersedes. Skipped, unknown and cleared answers
/// do not count; neither do those to other forms or versions.
std::vector<ScaleSummary> summarise(const ScaleForm& form, std::span<const study::AnswerRecord> answers);

/// Table 3 as printed, nine clinical teachers. The printed maximum of item 3 is impossible: no nine answers from 1 to 7
/// have its mean 4.44, deviation 0.88 and a maximum of 7.
std::vector<ScaleSummary> publishedUsability();

/// Whether `n` answers from 1 to `points` can have the printed mean and standard deviation (rounded to two decimals),
/// minimum and maximum of `row`. Exhaustive over the counts of each answer.
bool isPossible(const ScaleSummary& row, std::size_t n, int points);

}  // namespace tactus::questionnaires
