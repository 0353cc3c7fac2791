// Makes terms a partition: their memberships sum to one everywhere (Ruspini). What one is: core/analysis/term_conversion.h.
#pragma once

#include "app/editing/term_list.h"
#include "core/analysis/term_conversion.h"

namespace tactus::editing {

using analysis::kNarrowestShare;
using analysis::partitionOrder;
using analysis::TermOrder;

/// Makes the terms a partition. Neighbors, in the order of the middles of their cores, share the mean of their two
/// facing edges (sorted if they cross). The first and the last term are stretched to the ends of the universe. Terms
/// become trapezoids; a triangle that keeps its peak stays a triangle. Refused: a Gaussian in the list.
base::Result<Edit> makeSumToOne(const fuzzy::ForceModel& model, const TermListId& list);

}  // namespace tactus::editing
