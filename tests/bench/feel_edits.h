// From an edit of the model to the first tick of the servo that uses it.
#pragma once

#include "tests/bench/feel_results.h"

namespace tactus::bench {

/// In virtual time, and live on a servo thread: `live_edits` of them, some milliseconds apart; 0: only virtual.
FeelPart measureEdits(int live_edits);

}  // namespace tactus::bench
