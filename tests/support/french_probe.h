// A procedure that the program does not carry, in French: a probe in a joint.
#pragma once

#include <memory>

#include "core/procedure/procedure.h"
#include "core/study/records.h"

namespace tactus::support {

struct ProbeTraits {
  int conditions = 1;  ///< at most 26
  int rate_words = 0;  ///< 0: no rate
};

/// Three regions of the way, two words of each condition, four words of the force.
std::shared_ptr<const procedure::Procedure> frenchProbe(const ProbeTraits& traits = {});

/// Recorded answers to every item, judgements of ten forces, and with a rate three strokes for each of its words.
study::Study probeStudy(const ProbeTraits& traits = {}, int participants = 3);

}  // namespace tactus::support
