// The long run of nothing_lost_test.cpp: session_soak KILLS [SEED]. Exit status 1 where anything was lost.
#include <iostream>
#include <random>
#include <string>

#include "core/base/text.h"

#include "tests/app/session/kill_rounds.h"

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::uint64_t seed = argc > 2 ? std::stoull(argv[2]) : std::random_device()();
  std::cout << "seed " << seed << std::endl;
  const int kills = static_cast<int>(tactus::base::parseInteger(argv[1]).value_or(0));
  const auto outcome = tactus::session::sessionKillRounds(kills, seed);
  std::cout << outcome.rounds << " kills, " << outcome.sessions << " sessions finished all the same, "
            << outcome.acknowledged << " records acknowledged, "
            << (outcome.complaint.empty() ? "none lost" : outcome.complaint) << ", " << outcome.unacknowledged_kept
            << " kept beyond that\n";
  return outcome.complaint.empty() ? 0 : 1;
}
