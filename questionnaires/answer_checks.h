// Whether the answers of a table can be meant: known items and terms, answers that do not depend on the question.
#pragma once

#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::questionnaires {

/// Findings about the answers to those of `forms` that have items, participant after participant; other answers are
/// passed over. Refused: a term or an item that the form does not have. Named, of 20 answers or more: nine tenths that
/// are one term; a pattern of two, four or five answers over and over; answers opposite to the mean of at least two
/// others (correlation below -0.5); answers that are those of another participant, or one term away all the same, in
/// 19 of 20 items.
std::vector<study::DataFinding> answerFindings(std::span<const study::Answer> answers,
                                               std::span<const study::Form> forms);

}  // namespace tactus::questionnaires
