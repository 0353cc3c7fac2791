// The long run of lost_nothing_test.cpp: store_soak KILLS CRASHES [SEED]. Exit status 1 where anything was lost.
#include <iostream>
#include <random>
#include <string>

#include "core/base/text.h"

#include "tests/core/store/disk_rounds.h"

namespace {

int report(const char* what, const tactus::store::RoundsOutcome& outcome) {
  std::cout << what << ": " << outcome.rounds << " rounds, " << outcome.acknowledged << " records acknowledged, "
            << (outcome.complaint.empty() ? "none lost" : outcome.complaint) << ", " << outcome.unacknowledged_kept
            << " kept beyond that, slowest opening " << tactus::base::formatFixed(outcome.slowest_opening_s, 3)
            << " s\n";
  return outcome.complaint.empty() ? 0 : 1;
}

int count(const char* text) { return static_cast<int>(tactus::base::parseInteger(text).value_or(0)); }

}  // namespace

int main(int argc, char** argv) {
  using namespace tactus::store;
  if (argc < 3) return 2;
  const std::uint64_t seed = argc > 3 ? std::stoull(argv[3]) : std::random_device()();
  std::cout << "seed " << seed << std::endl;
  int failed = report("killed", killRounds(TACTUS_KILL_CHILD, count(argv[1]), seed));
  failed += report("crashed", crashRounds(count(argv[2]), 40, 40, seed));
  failed += report("crashed around checkpoints", crashRounds(count(argv[2]) / 20, 8, 330'000, seed));
  return failed == 0 ? 0 : 1;
}
