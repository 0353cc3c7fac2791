// Quantiles of Student's t distribution.
#pragma once

namespace tactus::elicitation {

/// The value that a t-distributed number with `degrees` > 0 degrees of freedom (any real number) does not exceed with
/// the probability `share`, in [0, 1]; infinite at its ends. Relative error below 1e-10.
double studentQuantile(double share, double degrees);

}  // namespace tactus::elicitation
