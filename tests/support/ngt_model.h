// The NGT model of facts known from the paper and the default membership functions, built by hand for tests.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::support {

/// Inputs lubrication, neck_flexion, depth, speed with the default terms, output force, no experts.
fuzzy::ForceModel ngtVariables();

/// S4's 45 rules as printed in Table A2 (regions nasal cavity, nasopharynx, laryngopharynx, esophagus, stomach).
fuzzy::ForceModel s4AsPrinted();

/// The same rules with the labels read as nasal cavity, nasopharynx, oropharynx, laryngopharynx, esophagus.
fuzzy::ForceModel s4Shifted();

/// The same rules with five depth terms, of which the laryngopharynx covers the oropharynx.
fuzzy::ForceModel s4FiveRegions();

}  // namespace tactus::support
