// The lowest minimum of J among those that several starts lead to (part of fcm.h).
#pragma once

#include <vector>

#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_descent.h"

namespace tactus::elicitation {

struct FcmSearch {
  FcmDescent kept;
  std::vector<FcmDescent> others;  ///< other minima, ascending J; only of the condensed data unless J is close
  int passes = 0;                  ///< over all samples
  bool cancelled = false;
};

/// From coarse to fine: the starts on a few hundred entries, their distinct minima on the condensed data, and those
/// that can be the lowest on all samples. `data` has more distinct values than clusters.
FcmSearch searchMinima(const FcmData& data, const FcmSettings& settings);

}  // namespace tactus::elicitation
