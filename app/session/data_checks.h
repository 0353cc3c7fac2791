// "Look at the data first": everything about the data of a study that a researcher should see before its results.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::session {

/// The findings about the data of `study`: refused data first, then doubtful data, both in the order of the
/// participants. A participant has at most one finding of each kind. A study without common mistakes has none. Terms
/// and items are those of the procedure of the study. 200
/// participants with 12 strokes of 730 rows each take 0.8 s (tests/app/session/data_counts.cpp). Thread: any.
std::vector<study::DataFinding> dataFindings(const study::Study& study);

}  // namespace tactus::session
