// Linear equations with a symmetric positive definite matrix.
#pragma once

#include <vector>

namespace tactus::elicitation {

/// Solves matrix * x = right by Cholesky's method. x replaces `right`; the matrix (row by row) is overwritten. Returns
/// false if the matrix is not positive definite; `right` is then invalid.
bool solvePositive(std::vector<double>& matrix, std::vector<double>& right);

}  // namespace tactus::elicitation
