// What a person said is right though the program would refuse it: `--accept KIND`.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/data_finding.h"

namespace tactus::cli {

/// The ids of the kinds that can be accepted.
std::vector<std::string> acceptableWords();

/// The kinds called `words`; an error about the first that is none of them, with the known ones.
base::Result<std::vector<study::DataFinding::Kind>> acceptedKinds(const std::vector<std::string>& words);

/// `Accepted as it is: speed_unit of N1, N4; force_unit of N2.`, and which of `words` nothing was refused for.
std::vector<std::string> acceptedNotes(const std::vector<study::DataFinding>& findings,
                                       const std::vector<study::DataFinding::Kind>& accepted);

/// A JSON object with the participants of each kind that was accepted: `{"speed_unit": ["N1", "N4"]}`. Empty where
/// nothing was.
std::string acceptedJson(const std::vector<study::DataFinding>& findings,
                         const std::vector<study::DataFinding::Kind>& accepted);

}  // namespace tactus::cli
