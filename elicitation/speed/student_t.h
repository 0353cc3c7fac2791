// Quantiles of Student's t distribution.
#pragma once

namespace tactus::elicitation {

/// The `share` quantile, `share` in [0, 1], of Student's t distribution with `degrees` > 0 (any real number); infinite
/// at 0 and 1. Relative error below 1e-10.
double studentQuantile(double share, double degrees);

}  // namespace tactus::elicitation
