// What the rules of many experts move, one rule of each: the averaged force with and without it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "elicitation/model/record_influence.h"

namespace tactus::elicitation {

/// For each expert of `built` what leaving out its rule `rules[expert]` moves, as `withoutRule` does one by one: at the
/// same points, and the forces agree but for rounding. The forces of the other experts are computed once for all, so
/// that hundreds of experts take seconds. Nothing where an expert has no rule to leave out. Incomplete after a stop
/// request. Thread: any.
std::vector<std::optional<RecordInfluence>> withoutRules(const BuiltModel& built,
                                                         std::span<const std::optional<std::size_t>> rules,
                                                         const std::stop_token& stop = {});

}  // namespace tactus::elicitation
