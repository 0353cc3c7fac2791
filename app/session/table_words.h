// Accepts the words of the study in everyday spelling: `Very small` for `very_small`.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/study/records.h"

namespace tactus::session {

/// Writes levels, series, terms and conditions of `study` as the ids of its procedure where they differ
/// only in capitals, spaces, dashes and underscores; so also `not felt` and `beyond practice`. Reads `up`, `asc` and
/// similar words as series, and `NA`, a dash or a similar word instead of a term as no answer. Returns one sentence for
/// each word that was changed: `speeds.csv: 'Slow' is read as slow in 240 rows.` Other words stay as they are.
std::vector<std::string> readWords(study::Study& study);

/// The judgements, or the answers, of one table, with the same replacements; appends the sentences of readWords to
/// `notes`.
base::Result<std::vector<study::ForceJudgement>> readJudgementTable(const base::CsvTable& table,
                                                                    std::vector<std::string>& notes);
base::Result<std::vector<study::Answer>> readAnswerTable(const base::CsvTable& table, std::vector<std::string>& notes);

}  // namespace tactus::session
