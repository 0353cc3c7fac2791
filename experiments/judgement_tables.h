// Checks the force judgements of a table: units, order and terms, plus the checks of judgement_checks.h.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::experiments {

/// Findings about the judgements of all participants, participant after participant. `terms`: ids, least first, at
/// least two. Refused: an unknown term, forces in mN or grams. Named: a series that is none of the experiment's, words
/// that fall with the force, one word for all forces, `beyond_practice` or `not_felt` 2.5 just-noticeable differences
/// on the wrong side of a term, a series whose forces do not go its way, what judgement_checks.h calls notable (terms
/// that fall in a quarter of the pairs instead of a tenth), judgements equal to those of another participant: 10 steps
/// or more with 3 words or more. Chance gives that to one of a thousand pairs of participants.
std::vector<study::DataFinding> judgementFindings(std::span<const study::ForceJudgement> judgements,
                                                  std::span<const std::string> terms);

}  // namespace tactus::experiments
