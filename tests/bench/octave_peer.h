// Octave's fuzzy logic toolkit as a peer, in a process of its own.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/error.h"

#include "tests/bench/cases.h"

namespace tactus::bench {

struct OctaveRun {
  double evaluation_ns = 0;      ///< by Octave's own clock, without its start; the best of three calls
  std::vector<double> forces_n;  ///< at the first points of the case
};

/// `evalfis` with `samples` points of the output on the first `points` points, all in one call. An error where Octave
/// or its toolkit is not installed. One expert, trapezoids only; vertical edges only at the ends of the universes,
/// where they are moved outward because the toolkit refuses them.
base::Result<OctaveRun> runOctave(const Case& about, std::size_t points, int samples);

}  // namespace tactus::bench
