// Consistency check of a force-feedback device's report descriptor.
#pragma once

#include "core/base/error.h"
#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {

/// Checks everything that is written or read, because a wrong descriptor makes the device act differently from its
/// command: 5000 in 8 bits is -120, and a duration of 0 means forever. Returns an error with one sentence and the place
/// for: an invalid range, or one that its bits cannot hold; an option that its bits cannot hold; two reports with one
/// id; a duration field that cannot express PidSession::kDurationS to 5 ms.
base::Result<void> checkLayout(const PidLayout& layout);

}  // namespace tactus::haptics
