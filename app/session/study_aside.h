// What a study file holds beside the data of its experts: the depths measured on an image, and what participants think
// of the simulator.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "elicitation/depth/depth_measurement.h"
#include "questionnaires/scale_summary.h"

namespace tactus::session {

struct StudyAside {
  std::optional<elicitation::DepthMeasurement> measured_depths;  ///< the latest; nothing: none was made
  std::vector<questionnaires::ScaleSummary> usability;           ///< one row per statement; empty without any answer
};

base::Result<StudyAside> asideOf(const store::StudyFile& file);

/// The same of the study at `path`; a folder of tables has neither. The file is not changed. Errors name the file.
base::Result<StudyAside> readAside(const std::string& path);

}  // namespace tactus::session
