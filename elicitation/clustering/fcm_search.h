// The lowest minimum of J that the starts lead to (part of fcm.h).
#pragma once

#include <vector>

#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_descent.h"

namespace tactus::elicitation {

struct FcmSearch {
  FcmDescent kept;
  std::vector<FcmDescent> others;  ///< other minima by ascending J; those of the entries unless J is close
  int passes = 0;                  ///< over all samples
  bool canceled = false;
};

/// Searches from coarse to fine: descends from all starts on a few hundred entries, from their distinct minima on all
/// entries, and from the candidates for the lowest minimum on all samples. `data`: more distinct values than clusters.
/// Four times settings.starts are made for up to 64 distinct values, and for m above 3 if the first ones disagree.
FcmSearch searchMinima(const FcmData& data, const FcmSettings& settings);

}  // namespace tactus::elicitation
