// From the classified forces to the terms of the force (paper, Fig. 3(e)).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force_voting.h"

namespace tactus::elicitation {

struct ForceTerms {
  fuzzy::Variable output;                 ///< the variable with its new terms; the universe ends at the last rated step
  std::vector<std::string> interpolated;  ///< ids of terms that no step won, placed between their neighbours
  std::vector<std::string> absent;        ///< ids of terms that no step won and that have no room
  std::vector<std::string> notes;         ///< one sentence for each of them
};

/// The terms of `output` (ids and labels from there, lowest first; universe from 0) from the outcome of the vote. The
/// core of a term runs from its first to its last step, ramps join neighbouring cores, the ends are shoulders. k terms
/// that no step won, in a gap [e, s], become triangles with peaks e + j(s - e)/(k + 1) and feet on the neighbouring
/// peaks; at an end of the scale the outermost is a shoulder, and in a gap without width there is no such term.
/// Refused: no step was decided, or the last one lies at 0 N. `steps` come from `vote` with as many terms as `output`.
base::Result<ForceTerms> forceTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps);

}  // namespace tactus::elicitation
