// The rules of each expert of a study, and the depth terms that they are about.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

struct ExpertRules {
  enum class Source { kAnswers, kGiven };

  study::Participant participant;
  Source source = Source::kAnswers;
  std::string depth_terms;  ///< name of the set (ngt_variables.h)
  std::vector<fuzzy::Rule> rules;
};

struct StudyRules {
  std::vector<ExpertRules> experts;  ///< participants with at least one rule, in the participants' order
  std::vector<std::string> notes;    ///< one sentence each
};

/// Given rules take the place of a participant's answers. The form of an expert decides the set of depth terms; given
/// rules that name no form get the set that holds the regions they use. Answers to a form that is not in `forms` are
/// passed over with a note. `output_terms`: ids an answer may have.
/// Refused: what rulesFromAnswers refuses, given rules that name an unknown form, forms of one expert with different
/// sets of depth terms, an unknown set, no rule at all.
base::Result<StudyRules> studyRules(const study::Study& study, std::span<const study::Form> forms,
                                    std::span<const std::string> output_terms);

/// Checks the rules of one expert against the terms that they are to use. Refused, with the number of the rule: an
/// unknown input or term, a weight outside [0, 1], the same rule twice. `absent_output_terms` have an error of their
/// own.
base::Result<void> checkRules(const fuzzy::Expert& expert, std::span<const fuzzy::Variable> inputs,
                              const fuzzy::Variable& output, std::span<const std::string> absent_output_terms);

}  // namespace tactus::elicitation
