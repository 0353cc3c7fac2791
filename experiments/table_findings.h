// Checks of the tables of the experiments: levels and values of strokes, strokes that are copies of others, judgements.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

// Checks the force judgements of a table: units, order and terms, plus the checks of judgement_checks.h.

/// Findings about the judgements of all participants, participant after participant. `terms`: ids, least first, at
/// least two. Refused: an unknown term, forces in mN or grams. Named: a series that is none of the experiment's, words
/// that fall with the force, one word for all forces, `beyond_practice` or `not_felt` 2.5 just-noticeable differences
/// on the wrong side of a term, a series whose forces do not go its way, what judgement_checks.h calls notable (terms
/// that fall in a quarter of the pairs instead of a tenth), judgements equal to those of another participant: 10 steps
/// or more with 3 words or more. Chance gives that to one of a thousand pairs of participants.
std::vector<study::DataFinding> judgementFindings(std::span<const study::ForceJudgement> judgements,
                                                  std::span<const std::string> terms);

// Detects strokes in a table that are copies of other strokes.

/// Findings about copied strokes, one for each participant at most, who comes after the original in the table. A stroke
/// counts as copied if it has 8 rows or more with 5 different speeds or more, and
/// - the same speeds as another stroke, row for row, or
/// - the same speeds but for a constant, as all strokes of the same level and number of another participant (two or
///   more), or
/// - the rows of another stroke, some of them left out (20 or more), with a constant in times and in depths or none, or
/// - speeds that differ by a lag of at most 0.3 s and noise of at most 3 % of their spread, again for all strokes of
///   another participant, six or more.
std::vector<study::DataFinding> strokeCopyFindings(std::span<const TableStroke> strokes);

/// Findings about the values of one participant's strokes:
/// - strokes under 30 mm and under half of the usual length;
/// - gaps above 0.05 s and five steps;
/// - single depths 50 mm from their neighbors;
/// - constant speeds, constant depths;
/// - speeds 5 times above the 95 % quantile of their level, and codes for missing values;
/// - backward motion: 5 mm of depth, or speeds that stay below 0, at -10 mm/s on average, for a twentieth of the rows.
std::vector<study::DataFinding> valueFindings(std::span<const TableStroke* const> strokes);

/// Findings about the levels of one participant's strokes. `levels`: the known ids, slowest first. An unknown level is
/// kRefused. Other findings: a known level without strokes, or with fewer than `usual`, and levels whose mean speeds
/// fall by a tenth or more.
std::vector<study::DataFinding> levelFindings(std::span<const TableStroke* const> strokes,
                                              std::span<const std::string> levels, std::size_t usual);

/// The number of strokes per level that is most frequent over participants and levels; on a tie the larger one.
std::size_t usualStrokes(std::span<const TableStroke> strokes);

}  // namespace tactus::experiments
