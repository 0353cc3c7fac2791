// Reads a study from a study file or from a folder of tables.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/csv_tables.h"

namespace tactus::session {

/// Reads the tables of a folder (csv_tables.h, with `input_ids` as there); accepts everyday spellings (table_words.h).
base::Result<study::StudyTables> readTables(const std::string& folder, const std::vector<std::string>& input_ids);

/// Reads the study at `path`: a folder like readTables, or the data for elicitation from a study file (study_view.h)
/// with any extension. The file is not changed. Errors name the file.
base::Result<study::StudyTables> readStudy(const std::string& path, const std::vector<std::string>& input_ids);

}  // namespace tactus::session
