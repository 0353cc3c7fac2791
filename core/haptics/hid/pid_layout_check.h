// Whether what a report descriptor says of a force-feedback device can be.
#pragma once

#include "core/base/error.h"
#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {

/// A descriptor that is wrong about a value makes the device do something else than it is told: 5000 in 8 bits is -120,
/// a duration of 0 is for ever. Looks at everything that is written or read. Refused, in one sentence with the place: a
/// range that its bits do not hold, or that is none; an option that its bits do not hold; two reports with one id; a
/// duration that cannot be PidSession::kDurationS to 5 ms.
base::Result<void> checkLayout(const PidLayout& layout);

}  // namespace tactus::haptics
