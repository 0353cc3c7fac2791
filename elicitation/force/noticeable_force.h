// How different two forces must be before a hand feels it.
#pragma once

namespace tactus::elicitation {

/// The smallest difference of forces around `force_n` >= 0 that a hand feels: sqrt(0.04^2 + (0.12 F)^2) N. Absolute
/// threshold and Weber fraction: King 2010, Feyzabadi 2013.
double justNoticeableDifference(double force_n);

}  // namespace tactus::elicitation
