// The paper's study with simulated data wherever the paper prints none.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

/// The seed where nobody asks for another; any other is as good.
inline constexpr std::uint64_t kDefaultSeed = 2;

/// Four participants S1 to S4, with
///   published: S4's 45 rules (Table A2, in the reading `reading`, see s4Readings);
///   simulated: strokes that have Table 1's means and deviations, judgements that give Table 2's votes, and the answers
///   of S1, S2 and S3 to the form `ngt-force-v1`, which follow the paper's text.
/// All four are marked as simulated, S4 too: S4's rules are real, but S4's strokes and judgements are not.
/// Years of experience are empty: the paper says "more than 10" of all four. An unknown reading is an error.
base::Result<study::Study> simulatedNgtStudy(std::uint64_t seed = kDefaultSeed,
                                             std::string_view reading = questionnaires::kDefaultReading);

}  // namespace tactus::session
