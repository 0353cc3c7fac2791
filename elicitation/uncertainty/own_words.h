// Whose words, whose rules: the force under each participant's own words of the force, and how far the participants
// disagree through their words, through their rules and through both.
//
//   words \ rules    shared                         own
//   shared           the averaged force             an expert's force, as everywhere else
//   own              the averaged rules, with the   what the participant alone would have given: own words
//                    force words of one person      and own rules
//
// The other words (of depth, speed, lubrication, flexion) stay as they are in the model.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// The words of the force of one participant.
struct OwnWords {
  std::string participant;
  std::vector<fuzzy::Term> terms;    ///< on the universe of the model's force; empty if the participant used no word
  std::vector<std::string> missing;  ///< ids of the model's terms that are not among `terms`, lowest first
};

/// One entry for each participant of the study, in its order; none if no force was judged. The terms come from the
/// participant's judgements alone, by the way of the model (`settings.force_terms`), with the words that this
/// participant used: a word that was never used does not exist, and its neighbors meet. The universe is the model's.
/// `built`: from `study` with `settings` by buildModel.
std::vector<OwnWords> ownWords(const study::Study& study, const BuiltModel& built, const BuildSettings& settings);

/// `model` with `words` in place of its force terms. A rule with a missing word is left out, so it gives no force.
/// Nothing if there are no words, or no rule is left.
std::optional<fuzzy::ForceModel> underWords(const fuzzy::ForceModel& model, const OwnWords& words);

/// One sentence for each participant with missing words, and for each without any word: what follows for the force.
/// `output`: of the model, with its labels.
std::vector<std::string> missingWordNotes(std::span<const OwnWords> words, const fuzzy::Variable& output);

/// How far the forces of the participants lie apart.
struct Disagreement {
  double sd_n = 0;       ///< standard deviation (n - 1) at a point: root mean square over the points
  double largest_n = 0;  ///< largest distance between two participants at a point
};

/// The disagreement of the participants who have words and rules of their own.
struct WordsAndRules {
  std::vector<std::string> participants;  ///< those compared; fewer than two: nothing is
  Disagreement words;                     ///< own words, shared rules
  Disagreement rules;                     ///< shared words, own rules
  Disagreement both;                      ///< own words, own rules
  std::size_t points = 0;                 ///< where at least two participants have all three forces
  std::size_t tried = 0;
  std::vector<std::string> notes;  ///< one sentence each: missing words, participants who are not compared
};

struct WordsAndRulesSettings {
  /// Where forces are compared, one value per input; empty: analysis::boxPoints, fewer for many participants.
  std::vector<std::vector<double>> points;
  std::stop_token stop;
  std::function<void(double share_done)> progress;  ///< called in the thread of the call
};

/// Compares, at each point, the participants who have all three forces there. Experts of weight 0 are left out.
/// Returns the error of fuzzy::compile, or kCancelled after a stop request. Thread: any.
base::Result<WordsAndRules> wordsAndRules(const study::Study& study, const BuiltModel& built,
                                          const BuildSettings& settings, const WordsAndRulesSettings& how = {});

/// One sentence with the three numbers, or why there are none.
std::string wordsAndRulesSentence(const WordsAndRules& found);

}  // namespace tactus::elicitation
