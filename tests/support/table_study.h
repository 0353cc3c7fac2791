// A study of simulated nurses as well-made tables hold it, for tests that then spoil it. Not a model of a person.
#pragma once

#include <cstdint>

#include "core/study/records.h"

namespace tactus::support {

struct TableStudyTraits {
  int nurses = 6;
  int strokes = 4;  ///< at each level
  double rows_per_s = 100;
  double noise = 0.02;  ///< of the speed, as a share of the plateau's
};

/// Nurses `N1`, `N2`, … with different speeds (Table 1: means of 30 to 300 mm/s, slow to fast rising), strokes of about
/// 60 mm with a plateau between two ramps whose depths are the integral of their speeds; one ascending series each,
/// judged with thresholds of their own and the noise of simulated_responder.h until "beyond practice"; answers to all
/// items of `ngt-force-v1`. Numbers are rounded as a spreadsheet has them (1 ms, 0.01 mm, 0.1 mm/s). Lines are those of
/// tables with one header line. The same seed gives the same study.
study::Study tableStudy(std::uint64_t seed, const TableStudyTraits& traits = {});

}  // namespace tactus::support
