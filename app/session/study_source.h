// A study from whatever it is kept in: a study file, or a folder with its tables.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/csv_tables.h"

namespace tactus::session {

/// Reads the study at `path`: the tables of a folder (csv_tables.h, with `input_ids` as there), or what elicitation
/// needs of a study file (study_view.h), whatever its name ends in. The file is not changed. Errors name the file.
base::Result<study::StudyTables> readStudy(const std::string& path, const std::vector<std::string>& input_ids);

}  // namespace tactus::session
