// The forces that each participant called by a word, and how far these intervals agree.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

/// From the lowest to the highest force that one participant called by one word. Both are equal if it was one force.
struct WordInterval {
  std::string participant;
  std::size_t word = 0;  ///< index in the terms
  double left_n = 0;
  double right_n = 0;
};

/// The intervals in `series`: participant after participant in the order of the judgements, words from the lowest. A
/// word that a participant never used has none. `terms`: of the force, lowest first; other words are skipped.
/// Such intervals are what surveys of words ask for (Liu and Mendel 2008); here they come from felt forces.
std::vector<WordInterval> wordIntervals(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                        std::span<const fuzzy::Term> terms);

/// The share of the intervals that contain every force between `left_n` and `right_n`.
struct IntervalShare {
  double left_n = 0;
  double right_n = 0;
  double share = 0;  ///< above 0, at most 1
};

/// The interval agreement of one word (Wagner, Miller, Garibaldi, Anderson and Havens 2015, one interval from each
/// participant): at every force the share of the intervals that contain it, ends included. In ascending order, with an
/// entry without width for each force at which intervals end; parts that no interval contains are left out.
std::vector<IntervalShare> intervalAgreement(std::span<const WordInterval> intervals, std::size_t word);

}  // namespace tactus::elicitation
