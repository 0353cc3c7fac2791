// A study as it can be given to others: nothing that points at a person or a place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/study/records.h"

namespace tactus::session {

/// The band of `years` of experience, from 0: `<5`, `5-10` (below 10), `10-15` (15 too), `>15`; empty where not given.
std::string experienceBand(std::optional<double> years);

struct ShareableStudy {
  study::Study study;              ///< with codes P1, P2, … in an order drawn with the seed, and without a name
  std::vector<std::string> bands;  ///< of each participant's experience
};

/// Leaves out exact years of experience, the weights of participants (which may follow from the years), categories and
/// hands other than the usual words, and times before the first sample of a stroke. Rows of nobody are left out.
ShareableStudy shareable(const study::Study& study, std::uint64_t seed);

}  // namespace tactus::session
