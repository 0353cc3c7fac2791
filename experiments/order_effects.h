// What catch trials and the order of the trials say about the data of a study. For the researcher only; nothing is left
// out because of it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/study/session_records.h"
#include "experiments/stop_force.h"

namespace tactus::experiments {

/// What one participant did, in the order in which it was done.
struct DoneInOrder {
  struct Answer {
    int item = 0;
    int position = 0;      ///< in the order shown, from 1
    std::size_t term = 0;  ///< index of the answer among the terms, least first
  };
  std::string participant;
  bool simulated = false;
  std::vector<std::pair<std::string, double>> speeds;  ///< level and mean speed, mm/s, as the levels came
  std::vector<study::JudgementRecord> judgements;      ///< of the session that counts, without corrected ones
  std::vector<Answer> answers;
  std::vector<StopAnswer> stops{};  ///< of the judgements that count
};

/// A mean over participants, with its standard error where there are two or more.
struct MeanOverPersons {
  std::size_t persons = 0;
  double mean = 0;
  std::optional<double> standard_error;
};

struct OrderEffects {
  struct Person {
    std::string participant;
    bool simulated = false;
    std::size_t blanks = 0;  ///< judgements of 0 N that are scored
    std::size_t felt_blanks = 0;
    std::size_t repeats = 0;  ///< hidden repeats of a force, with a term both times
    std::size_t same_repeats = 0;
    std::size_t both_ways = 0;  ///< forces judged with a term on the way up and on the way down
    /// Mean of (term on the way up - term on the way down), in terms; above 0: forces seem larger on the way up.
    std::optional<double> up_minus_down;
  };
  std::vector<Person> persons;  ///< those with catch trials or with both series
  MeanOverPersons up_minus_down;

  /// Index: the place of a level among the levels, first to last. Each person's speed at a level is divided by the mean
  /// of that level over all persons; 1 = the place has no effect. Empty unless two persons had different orders.
  std::vector<MeanOverPersons> speed_at_place;
  /// Terms: the answers of the last third of the positions minus those of the first, each less the mean of its item
  /// over all persons. No person unless two had different orders.
  MeanOverPersons late_minus_early;
};

/// `terms`: ids of the force's terms, least first, at least two.
OrderEffects orderEffects(std::span<const DoneInOrder> done, std::span<const std::string> terms);

}  // namespace tactus::experiments
