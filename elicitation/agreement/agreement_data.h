// From answers, judgements or a table of counts to the ratings that agreement is measured on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "elicitation/agreement/ratings.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// What was rated: a force, or an item of a form.
struct RatedUnit {
  std::string name;               ///< `0.3 N`, `item 12`
  std::optional<double> force_n;  ///< of a force
  std::optional<int> item;        ///< number on the form
  std::string text;               ///< wording of the item, where the form is known
};

/// Units with at least one rating, and who rated them how.
struct AgreementData {
  std::vector<std::string> terms;  ///< the categories, lowest first
  std::vector<RatedUnit> units;
  RatingCounts counts;
  std::vector<std::string> raters;  ///< participants with at least one rating; empty for a table of counts
  std::optional<Ratings> ratings;   ///< absent for a table of counts: it does not say who chose what
  std::string form;                 ///< of answers
  std::vector<std::string> notes;   ///< one sentence each: what was left out
};

/// The answers to one form. A rating is an answer with status `answered`; skipped, cannot tell and cleared are missing.
/// `form_id` empty: the form with the most ratings, the first of them on a tie, and a note names the others. The terms
/// are those of the form where `forms` knows it, else `terms` (ids, lowest first). Refused: no answer to the form, a
/// term that is not among them, an item that a known form does not have, an item answered twice by a participant.
base::Result<AgreementData> agreementData(std::span<const study::Answer> answers, std::string_view form_id,
                                          std::span<const study::Form> forms, std::span<const std::string> terms);

/// The judgements of one `series`, units are the forces. A rating is a term; not felt, beyond practice and no answer
/// are missing. Refused: what `countVotes` refuses.
base::Result<AgreementData> agreementData(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                          std::span<const std::string> terms);

/// A table of counts as printed in Table 2.
AgreementData agreementData(std::span<const VoteCounts> steps, std::span<const std::string> terms);

}  // namespace tactus::elicitation
