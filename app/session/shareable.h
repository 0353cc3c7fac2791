// A study in a form for publication, without anything that identifies a person or a place.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/study/records.h"

namespace tactus::session {

/// The band of `years` of experience (>= 0), as the screens ask for it: `<5`, `5-9`, `10-14`, `15+`; empty if
/// unknown.
std::string experienceBand(std::optional<double> years);

/// The inputs of the study's rules: those of the tube model, then further ones.
std::vector<std::string> inputsOf(const study::Study& study);

/// One sentence: how many participants a program simulated. Empty if none.
std::string simulatedNote(const study::Study& study);
/// The same of participants with a device that gives no force, with their codes in `study`.
std::string virtualNote(const study::Study& study);

struct ShareableStudy {
  study::Study study;                        ///< codes P1, P2, … in an order drawn with the seed; no name
  std::vector<std::string> bands;            ///< experience band of each participant
  std::map<std::string, std::string> codes;  ///< the new code of each participant by the old one
};

/// Leaves out exact years of experience, the weights of participants (they may follow from the years), unusual words
/// for category and hand, and times before the first sample of a stroke. Rows that belong to no participant are left
/// out.
ShareableStudy shareable(const study::Study& study, std::uint64_t seed);

}  // namespace tactus::session
