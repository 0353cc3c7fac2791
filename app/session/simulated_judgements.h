// Simulated judgements of the force experiment with exactly the votes of Table 2. They are not the nurses' answers.
#pragma once

#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// One ascending series of 0.1 to 1.7 N for each of S1 to S4. Table 2 gives the number of votes for each term at each
/// force, but not the voters. The votes are therefore split so that a person's terms never fall with the force: at each
/// force the k-th largest of the four votes is S<k>'s. So S1 is the first to call a force large and S4 the last. The
/// assignment is arbitrary, and voting does not depend on it. Above 1.1 N, "the upper bound of insertion force
/// experienced", all four judge `beyond_practice`.
std::vector<study::ForceJudgement> simulatedJudgements();

}  // namespace tactus::session
