// Upper tail of the chi-square distribution.
#pragma once

namespace tactus::elicitation {

/// The probability of a value of at least `chi_square` (>= 0) with `degrees` (>= 1) degrees of freedom. For integer
/// degrees it is a finite sum of positive terms, so no digits cancel (Abramowitz and Stegun 1964, 26.4.4 and 26.4.5).
double chiSquareUpperTail(double chi_square, int degrees);

}  // namespace tactus::elicitation
