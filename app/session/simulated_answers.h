// Simulated answers to the force questionnaire that follow what the paper says of its nurses. Nobody gave them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// The answers of S1, S2 and S3 to all items of `form` (the form `ngt-force-v1`: each item asks about one condition in
/// one region). Their answers are not published. The model: a level is the sum of
///   the region's level + the condition's effect × the nurse's sensitivity + the nurse's own extra in the oropharynx
/// plus a seeded deviation of each nurse for each region and each condition, rounded to one of the form's terms.
/// By construction, for every seed (paper, Section 3.4 and Fig. 11): more lubrication never more force; more neck
/// flexion never more force; more speed never less force; the nasal cavity never below the nasopharynx; no region above
/// the oropharynx; nobody above S2 there; in the esophagus at most one term between the three.
std::vector<study::Answer> simulatedAnswers(const study::Form& form, std::uint64_t seed);

}  // namespace tactus::session
