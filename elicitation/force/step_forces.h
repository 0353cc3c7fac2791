// Whether the participants of a force experiment judged the same forces.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/records.h"

namespace tactus::elicitation {

/// One sentence for each participant with a step of `series` whose force is not the one that most judgements of that
/// step have (the lowest of them on a tie). The vote counts by force, so such a judgement may stand alone.
std::vector<std::string> stepForceNotes(std::span<const study::ForceJudgement> judgements, std::string_view series);

}  // namespace tactus::elicitation
