// The paper's study with simulated data wherever the paper prints none.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

/// The seed where nobody asks for another; any other is as good.
inline constexpr std::uint64_t kDefaultSeed = 2;
/// A larger seed would begin again with what a smaller one gives: each takes a thousand numbers of 64 bits.
inline constexpr std::uint64_t kLargestSeed = 10'000'000'000'000'000;

/// Makes the study file `path`, which must not be there yet, and lets four simulated nurses S1 to S4 go through their
/// sessions (simulated_nurse.h):
///   simulated: strokes that have Table 1's means and deviations, judgements that give Table 2's votes, and the answers
///   of S1, S2 and S3 to the form `ngt-force-v1`, which follow the paper's text;
///   published: S4's 45 rules (Table A2, in the reading `reading`, see s4Readings), put into S4's session.
/// All four are marked as simulated, S4 too: S4's rules are real, but S4's strokes and judgements are not. Times are
/// simulated as well; the same arguments give the same records, ids and times included.
/// Years of experience are empty: the paper says "more than 10" of all four. Refused: an unknown reading, and whatever
/// StudyFile::create refuses. After a failure the file may be there with fewer sessions.
base::Result<store::StudyFile> makeSimulatedNgtStudy(const std::string& path, std::uint64_t seed = kDefaultSeed,
                                                     std::string_view reading = questionnaires::kDefaultReading,
                                                     const std::string& program = {});

}  // namespace tactus::session
