// Checks that the participants of a force experiment judged the same forces.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/records.h"

namespace tactus::elicitation {

/// One sentence for each participant with a step of `series` at another force than most judgements of that step (on a
/// tie the lowest force). The vote counts by force, so such a judgement may be alone.
std::vector<std::string> stepForceNotes(std::span<const study::ForceJudgement> judgements, std::string_view series);

}  // namespace tactus::elicitation
