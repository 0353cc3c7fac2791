// Words of the study as people write them in tables: `Very small` for `very_small`.
#pragma once

#include <string>
#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// Writes levels, series, terms and conditions of `study` as the ids of the nasogastric tube study where they differ
/// only in capitals, spaces, dashes and underscores, `not felt` and `beyond practice` among them. Returns one sentence
/// for each word that was changed: `speeds.csv: 'Slow' is read as slow in 240 rows.` Other words stay as they are.
std::vector<std::string> readWords(study::Study& study);

}  // namespace tactus::session
