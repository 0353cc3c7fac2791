// From a minimum of J to starts that may lead lower: one centre taken away and put elsewhere (part of fcm.h).
#pragma once

#include <cstddef>
#include <vector>

#include "elicitation/clustering/fcm_entries.h"

namespace tactus::elicitation {

/// The up to `most` choices of lowest J among those that differ from `centres` (ascending) by one centre, which moved
/// to one of at most 48 entries spread over the data. Each ascending and distinct.
std::vector<std::vector<double>> relocations(const FcmEntries& entries, const std::vector<double>& centres, double m,
                                             std::size_t most);

}  // namespace tactus::elicitation
