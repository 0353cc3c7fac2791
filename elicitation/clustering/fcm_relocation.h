// Starts that may lead from a minimum of J to a lower one: one center is removed and placed elsewhere (part of fcm.h).
#pragma once

#include <cstddef>
#include <vector>

#include "elicitation/clustering/fcm_entries.h"

namespace tactus::elicitation {

/// Up to `most` starts, those with the lowest J. Each differs from `centres` (ascending) by one center, moved to one of
/// at most 48 entries spread over the data. Each is ascending and distinct.
std::vector<std::vector<double>> relocations(const FcmEntries& entries, const std::vector<double>& centres, double m,
                                             std::size_t most);

}  // namespace tactus::elicitation
