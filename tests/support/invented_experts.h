// Three invented experts beside S4 on the same terms: no person's answers, for numbers that another program computed.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::support {

/// E1, E2, E3 and S4 with 45 rules each, in five regions of which the laryngopharynx covers the oropharynx. The words
/// are those of the specification's example; its forces at (1, 60, 200, 50) are .45, .6, .5 and .58944 N.
fuzzy::ForceModel inventedExperts();

/// One expert's 45 rules from nine groups of five digits, 1 very small to 5 very large: lubrication well, medium, poor;
/// neck flexion small, medium, large; speed slow, medium, fast. The digits are the regions from the nose on.
fuzzy::Expert expertOfDigits(const char* id, const char* digits);

}  // namespace tactus::support
