// Simulated judgements of the force experiment that give exactly the votes of Table 2. Not the nurses' real answers.
#pragma once

#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// One ascending series of 0.1 to 1.7 N for each of S1 to S4. Table 2 says how many chose a term at each force, not
/// who. One split into four persons whose terms never fall with the force: at each force the k-th largest of the four
/// votes is S<k>'s, so S1 is the first to call a force large and S4 the last. Who is who is arbitrary, and voting does
/// not depend on it. Above 1.1 N, "the upper bound of insertion force experienced", everybody says `beyond_practice`.
std::vector<study::ForceJudgement> simulatedJudgements();

}  // namespace tactus::session
