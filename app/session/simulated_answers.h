// Simulated answers to the force questionnaire, made to follow the paper's text about its nurses. They are not real.
#pragma once

#include <cstdint>
#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// The answers of S1, S2 and S3 to all items of `form` (`ngt-force-v1`: each item asks about one condition in one
/// region). The paper does not print their answers. The model: a level is the sum of
///   the region's level + the condition's effect × the nurse's sensitivity + the nurse's own extra in the oropharynx
/// plus a seeded deviation of each nurse for each region and each condition, rounded to one of the form's terms. For
/// every seed, by construction (paper, Section 3.4 and Fig. 11): more lubrication never increases the force; more neck
/// flexion never increases it; more speed never decreases it; the nasal cavity is never below the nasopharynx; no
/// region is above the oropharynx; no nurse is above S2 there; in the esophagus the three differ by at most one term.
std::vector<study::Answer> simulatedAnswers(const study::Form& form, std::uint64_t seed);

}  // namespace tactus::session
