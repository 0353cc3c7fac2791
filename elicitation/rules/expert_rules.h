// The rules of each expert of a study, and the depth terms that they are about.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/rules/rules_from_answers.h"

namespace tactus::elicitation {

struct ExpertRules {
  enum class Source { kAnswers, kGiven };

  study::Participant participant;
  Source source = Source::kAnswers;
  std::vector<std::string> forms;     ///< ids of the forms or readings that the rules come from, in order of first use
  std::string depth_terms;            ///< name of the set (ngt_variables.h)
  bool depth_terms_inferred = false;  ///< from the regions that the rules use, because they name no form
  std::vector<fuzzy::Rule> rules;
  std::vector<RuleOrigin> origins;   ///< one for each rule
  std::vector<MissingItem> missing;  ///< items of those forms that give no rule; empty where the rules are given
};

struct StudyRules {
  std::vector<ExpertRules> experts;  ///< participants with at least one rule, in the participants' order
  std::vector<std::string> notes;    ///< one sentence each
};

/// Given rules take the place of a participant's answers. The form of an expert decides the set of depth terms; given
/// rules that name no form get the set that holds the regions they use. Answers to a form that is not in `forms` are
/// passed over with a note that names their first line. `output_terms`: ids an answer may have.
/// Refused: what rulesFromAnswers refuses, given rules that name an unknown form, forms of one expert with different
/// sets of depth terms, an unknown set, no rule at all.
base::Result<StudyRules> studyRules(const study::Study& study, std::span<const study::Form> forms,
                                    std::span<const std::string> output_terms);

}  // namespace tactus::elicitation
