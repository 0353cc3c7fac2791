// A study from whatever it is kept in: a study file, or a folder with its tables.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/csv_tables.h"

namespace tactus::session {

/// Reads the tables of a folder (csv_tables.h, with `input_ids` as there), words as people write them (table_words.h).
base::Result<study::StudyTables> readTables(const std::string& folder, const std::vector<std::string>& input_ids);

/// Reads the study at `path`: the tables of a folder as readTables does, or what elicitation
/// needs of a study file (study_view.h), whatever its name ends in. The file is not changed. Errors name the file.
base::Result<study::StudyTables> readStudy(const std::string& path, const std::vector<std::string>& input_ids);

}  // namespace tactus::session
