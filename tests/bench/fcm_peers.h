// Other programs' fuzzy c-means, each in a process of its own that times itself, in processor time: so nothing else
// that runs on the machine counts against it.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace tactus::bench {

struct FcmPeerRun {
  double median_ms = 0;
  double min_ms = 0;
  std::vector<double> centres;
};

/// `cmeans` of R's e1071 with iter.max = 1000; `control` is what it gets beside that, e.g. `list(reltol = 1e-15)`, or
/// `list()`. The data are loaded and a small clustering is done before the clock starts. Fails where R or the package
/// is not installed.
base::Result<FcmPeerRun> runE1071(const std::vector<double>& samples, std::size_t clusters, const std::string& control,
                                  int repetitions);

/// `fcm` of Octave's fuzzy logic toolkit with its defaults. Fails where it is not installed.
base::Result<FcmPeerRun> runOctaveFcm(const std::vector<double>& samples, std::size_t clusters, int repetitions);

/// Version of the package in R, or nothing.
std::string e1071Version();

}  // namespace tactus::bench
