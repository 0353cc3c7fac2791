// Families of simulated nurses for planning a study: what they would feel and say, and how they differ. They are not
// models of real persons.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/session/study_procedure.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::planning {

/// What a study asks: its questions, each about one condition in one region, and the variables that they name.
struct Questions {
  session::ProcedurePtr about;
  std::vector<fuzzy::Variable> inputs;               ///< with the terms of the way of the form
  std::vector<std::vector<fuzzy::Condition>> items;  ///< in the order of the form
  std::vector<double> forces_n;                      ///< that are judged, ascending

  /// The ids of the words of the force, from the smallest.
  std::vector<std::string> words() const;
  /// The number of speeds at which strokes are done.
  std::size_t speeds() const;
};

/// The questions of the first form of a procedure that lead to rules, and the forces of its first protocol. Of the
/// default procedure: the form `ngt-force-v1` with 45 questions, and 0.1 to 1.7 N in steps of 0.1.
Questions questionsOf(const session::ProcedurePtr& about);

/// The region of each question as a number from 0, in the order of first appearance.
std::vector<std::size_t> regionsOf(const Questions& questions);

/// One nurse as she is, without the chance of a day.
struct TrueNurse {
  std::vector<double> threshold_n;  ///< ascending, one between two words of the force
  double beyond_from_n = 1.15;      ///< larger forces are beyond what she has felt
  std::vector<double> level;        ///< one per question: her word, from 0, before it is rounded
  std::vector<double> speed_mm_s;   ///< mean speed at each word of the rate, ascending; empty without a rate
};

/// Draws one nurse of a family.
using NurseSource = std::function<TrueNurse(base::Random& random)>;

/// How often the same nurse says something else.
struct RepeatNoise {
  double judgement_jnd = 1;   ///< standard deviation of a felt force, in just-noticeable differences
  double lapse = 0.02;        ///< share of judgements with a random word
  double answer_words = 0.4;  ///< standard deviation of an answer before it is rounded, in words
  double stroke_log = 0.1;    ///< standard deviation of the logarithm of a stroke's speed
};

/// Typical values, and standard deviations between nurses around them; normal distributions.
struct NurseFamily {
  std::vector<double> threshold_n;
  double threshold_log = 0;      ///< of the logarithm of all thresholds of a nurse together
  double threshold_own_log = 0;  ///< of each threshold by itself
  double beyond_from_n = 1.15;
  std::vector<double> level;
  std::vector<std::size_t> region;  ///< of each question; numbers from 0
  double level_words = 0;           ///< of all answers of a nurse together, in words
  double level_region_words = 0;    ///< of her answers in one region
  double level_own_words = 0;       ///< of each answer by itself
  std::vector<double> speed_mm_s;
  double speed_log = 0;      ///< of the logarithm of all speeds of a nurse together
  double speed_own_log = 0;  ///< of each speed by itself

  TrueNurse draw(base::Random& random) const;
};

/// Draws the nurses of `family`.
NurseSource sourceOf(NurseFamily family);

/// The family around the nurses of the paper. Thresholds: the four voters into whom the votes of Table 2 are split.
/// Speeds: Table 1. Words: the mean of the simulated answers of the demo study; that nurses differ by .8 words in all
/// (.5 together, .4 in a region, .45 by question) is a choice of this project.
/// Of another procedure: the simulated experts of its pack (session::simulatedExpert), who differ as the nurses of the
/// paper do, in words as .8 of 5. Nothing of it is known of real experts.
NurseFamily defaultFamily(const Questions& questions);

/// Standard deviations of the parts of a table: a row per nurse, columns in groups.
struct SpreadParts {
  std::vector<double> column_mean;
  double row = 0;    ///< between the rows
  double group = 0;  ///< between the groups within a row; 0 if each column is a group
  double cell = 0;   ///< the rest
};
/// By the method of moments (nested analysis of variance), negative variances set to 0. `rows`: at least two. `group`:
/// of each column, numbers from 0; empty: each column by itself.
SpreadParts spreadParts(const std::vector<std::vector<double>>& rows, std::vector<std::size_t> group = {});

/// What a study says about its nurses.
struct StudyFamily {
  Questions questions;
  NurseFamily family;
  RepeatNoise noise;
  std::size_t nurses = 0;          ///< with rules
  std::size_t strokes = 0;         ///< largest number of strokes at one speed
  std::vector<std::string> notes;  ///< one sentence each: what is assumed, because the study does not tell
};

/// Estimates the family of the nurses of `study`, of which `built` is the model by `settings`. What alike nurses with
/// the repeat noise would show is subtracted from the spread. The noise of the judgements is estimated from
/// participants who judged more than one series, else assumed; that of the answers is assumed. Refused: fewer than two
/// nurses with rules.
base::Result<StudyFamily> familyOf(const study::Study& study, const elicitation::BuiltModel& built,
                                   const elicitation::BuildSettings& settings);

}  // namespace tactus::planning
