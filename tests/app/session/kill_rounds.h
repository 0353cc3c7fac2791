// Rounds in which a program that runs a session is killed, for the quick test and the soak.
#pragma once

#include <cstdint>
#include <string>

namespace tactus::session {

struct KillOutcome {
  int rounds = 0;                     ///< kills
  int sessions = 0;                   ///< that came to their end all the same
  long long acknowledged = 0;         ///< records over all rounds
  long long unacknowledged_kept = 0;  ///< written but not yet acknowledged at a kill, and there afterwards
  std::string complaint;              ///< the first thing that was not as it must be; empty when all was well
};

/// A simulated nurse goes through a session in a process of its own, which says the id of each record once it is
/// stored, and which is killed (SIGKILL) at a random moment. The next process resumes the session, and so on to its
/// end; then another one begins, until there were `rounds` kills. After each kill every id that was said is in the
/// file, once and in order, with at most one record that was not said, and checkStudy finds nothing. A session at its
/// end holds what a session without kills does. The calling process must have no other thread.
KillOutcome sessionKillRounds(int rounds, std::uint64_t seed);

}  // namespace tactus::session
