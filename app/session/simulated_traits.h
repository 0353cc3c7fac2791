// The traits of the paper's four nurses, S1 to S4, as simulated persons.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "app/session/simulated_nurse.h"

namespace tactus::session {

/// The nurses in the order of their codes. They hear and feel without noise: their strokes have the means and
/// deviations of Table 1, and their votes are those of Table 2. S1 to S3 have answers to the form `ngt-force-v1`
/// (simulated_answers.h); S4 has none. The same `seed` gives the same traits. Takes a second or more.
std::vector<NurseTraits> simulatedNurses(std::uint64_t seed);

/// One of them; `code` is `S1` to `S4`, anything else is our own bug.
NurseTraits simulatedNurseCalled(std::string_view code, std::uint64_t seed);

}  // namespace tactus::session
