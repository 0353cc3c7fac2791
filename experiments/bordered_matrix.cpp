#include "experiments/bordered_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactus::experiments {

double BorderedMatrix::factorize() {
  double log_determinant = 0;
  for (std::size_t j = 0; j < size_; ++j) {
    for (std::size_t i = j; i < size_; i = nextRow(i, j)) {
      double sum = at(i, j);
      for (std::size_t k = std::max(firstColumn(i), firstColumn(j)); k < j; ++k) sum -= at(i, k) * at(j, k);
      if (i != j) {
        at(i, j) = sum / at(j, j);
        continue;
      }
      if (!(sum > 0)) return std::numeric_limits<double>::infinity();
      log_determinant += std::log(sum);
      at(j, j) = std::sqrt(sum);
    }
  }
  return log_determinant;
}

std::vector<double> BorderedMatrix::solve(std::vector<double> right) const {
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t k = firstColumn(i); k < i; ++k) right[i] -= at(i, k) * right[k];
    right[i] /= at(i, i);
  }
  for (std::size_t i = size_; i-- > 0;) {
    for (std::size_t k = nextRow(i, i); k < size_; k = nextRow(k, i)) right[i] -= at(k, i) * right[k];
    right[i] /= at(i, i);
  }
  return right;
}

}  // namespace tactus::experiments
