// The smallest difference of forces that a hand feels.
#pragma once

namespace tactus::elicitation {

/// The just-noticeable difference around `force_n` >= 0: sqrt(0.04^2 + (0.12 F)^2) N. Absolute threshold and Weber
/// fraction: King 2010, Feyzabadi 2013.
double justNoticeableDifference(double force_n);

}  // namespace tactus::elicitation
