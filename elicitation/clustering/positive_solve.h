// Linear equations with a symmetric positive definite matrix.
#pragma once

#include <vector>

namespace tactus::elicitation {

/// Solves matrix * x = right by Cholesky's method; x replaces `right`, the matrix (row by row) is used up. False where
/// the matrix is not positive definite; then `right` is of no use.
bool solvePositive(std::vector<double>& matrix, std::vector<double>& right);

}  // namespace tactus::elicitation
