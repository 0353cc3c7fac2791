// The rules of each expert of a study, and their depth terms.
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
  std::vector<std::string> forms;     ///< ids of the forms or readings of the rules, in order of first use
  std::string depth_terms;            ///< name of the set (ngt_variables.h)
  bool depth_terms_inferred = false;  ///< derived from the regions in the rules, because they name no form
  std::vector<fuzzy::Rule> rules;
  std::vector<RuleOrigin> origins;   ///< one per rule
  std::vector<MissingItem> missing;  ///< items of those forms without a rule; empty for given rules
};

struct StudyRules {
  std::vector<ExpertRules> experts;  ///< participants with at least one rule, in the participants' order
  std::vector<std::string> notes;    ///< one sentence each
};

/// The rules of all experts. Given rules replace a participant's answers. The form of an expert decides the set of
/// depth terms. Given rules without a form get the set that contains their regions. Answers to a form that is not in
/// `forms` are skipped with a note that names their first line. `output_terms`: allowed ids of answers.
/// Returns the errors of rulesFromAnswers, and an error for: given rules that name an unknown form, forms of one expert
/// with different sets of depth terms, an unknown set, no rules at all.
base::Result<StudyRules> studyRules(const study::Study& study, std::span<const study::Form> forms,
                                    std::span<const std::string> output_terms);

}  // namespace tactus::elicitation
