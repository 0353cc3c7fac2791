// Stands in where fuzzylite is not installed.
#include "tests/bench/fuzzylite_peer.h"

namespace tactus::bench {

std::string fuzzyliteVersion() { return "not installed (Debian: libfuzzylite-dev)"; }

PeerEvaluator fuzzylitePeer(const fuzzy::ForceModel& /*model*/, int /*resolution*/) { return {}; }

}  // namespace tactus::bench
