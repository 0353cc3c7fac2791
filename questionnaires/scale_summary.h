// Mean, deviation and range of the answers on a rating scale, as in Table 3 of the paper.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/study/session_records.h"
#include "questionnaires/form_file.h"

namespace tactus::questionnaires {

/// One row of Table 3.
struct ScaleSummary {
  int item = 0;
  std::size_t n = 0;  ///< number of answers
  double mean = 0;    ///< 0 if n = 0, as the other statistics
  double sd = 0;      ///< n - 1 in the denominator; 0 for fewer than two answers
  int min = 0;
  int max = 0;

  bool operator==(const ScaleSummary&) const = default;
};

/// One row per item of `form`, over the answers without a later correction. Skipped, unknown and cleared answers do not
/// count, nor do answers to other forms or versions.
std::vector<ScaleSummary> summarize(const ScaleForm& form, std::span<const study::AnswerRecord> answers);

/// Table 3 as printed, for nine clinical teachers. Item 3 is impossible as printed: no nine answers from 1 to 7 have
/// mean 4.44, deviation 0.88 and maximum 7.
std::vector<ScaleSummary> publishedUsability();

/// Whether `n` answers from 1 to `points` can have the mean and standard deviation (rounded to two decimals), minimum
/// and maximum of `row`. Tries all counts of answers.
bool isPossible(const ScaleSummary& row, std::size_t n, int points);

}  // namespace tactus::questionnaires
