// Checks the participants of a study: distinct codes, plausible profiles, complete data.
#pragma once

#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::session {

/// Findings about the participants: codes that differ only in capitals, spaces, dashes or leading zeros; codes that
/// look like names; impossible years of experience (above 80 refused, above 60 named); participants without
/// strokes, judgements or answers where others have them; simulated participants beside real ones; codes that look like
/// dates or like a line of means below the table; weights in percent beside shares.
std::vector<study::DataFinding> participantFindings(const study::Study& study);

}  // namespace tactus::session
