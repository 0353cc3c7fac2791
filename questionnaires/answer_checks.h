// Checks the answers of a table: known items and terms, and answers that depend on the question.
#pragma once

#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::questionnaires {

/// Findings about the answers to those of `forms` that have items, by participant. Skips other answers.
/// kRefused: a term or an item that the form lacks. Other findings, for 20 answers or more:
/// - nine tenths of the answers are one term;
/// - a pattern of two, four or five answers repeats;
/// - the answers are opposite to the mean of at least two other participants (correlation below -0.5);
/// - a form was asked in two wordings, or in one beside answers of which it is not known (any number of answers);
/// - in 19 of 20 items the answers equal those of another participant, or differ by one term in the same direction.
std::vector<study::DataFinding> answerFindings(std::span<const study::Answer> answers,
                                               std::span<const study::Form> forms);

}  // namespace tactus::questionnaires
