// The paper's study. Data that the paper does not print are simulated.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

/// The default seed. The value is arbitrary.
inline constexpr std::uint64_t kDefaultSeed = 2;
/// A larger seed would repeat a smaller one: each seed uses a thousand numbers of 64 bits.
inline constexpr std::uint64_t kLargestSeed = 10'000'000'000'000'000;

/// Creates the study file `path`, which must not exist yet. Four simulated nurses S1 to S4 do their sessions
/// (simulated_nurse.h):
///   simulated: strokes with the means and deviations of Table 1, judgements with the votes of Table 2, and the answers
///   of S1, S2 and S3 to the form `ngt-force-v1`, which follow the paper's text; published: S4's 45 rules (Table A2, in
///   the reading `reading`, see s4Readings), stored in S4's session.
/// All four are marked as simulated, also S4: S4's rules are real, but S4's strokes and judgements are not. Times are
/// simulated, too. The same arguments give the same records, including ids and times. Years of experience are empty:
/// the paper says "more than 10" of all four. Refused: an unknown reading, and whatever StudyFile::create refuses.
/// After a failure the file may exist with fewer sessions.
base::Result<store::StudyFile> makeSimulatedNgtStudy(const std::string& path, std::uint64_t seed = kDefaultSeed,
                                                     std::string_view reading = questionnaires::kDefaultReading,
                                                     const std::string& program = {});

}  // namespace tactus::session
