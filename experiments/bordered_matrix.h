// Cholesky factorization of a band matrix with a few full rows at its end.
#pragma once

#include <cstddef>
#include <vector>

namespace tactus::experiments {

/// A symmetric positive definite matrix, stored as its lower triangle: a band, then `border` full rows. The factor has
/// the same shape, so factorization costs a few operations per stored element.
class BorderedMatrix {
 public:
  /// `size`: number of rows. `border`: number of full rows at the end. `band`: elements in each other row, including
  /// the diagonal.
  BorderedMatrix(std::size_t size, std::size_t band, std::size_t border)
      : size_(size), band_(band), banded_(size - border), values_(band * banded_ + border * size) {}

  /// A stored element: column <= row, and within the band unless the row is full.
  double& at(std::size_t row, std::size_t column) { return values_[place(row, column)]; }
  double at(std::size_t row, std::size_t column) const { return values_[place(row, column)]; }

  /// Replaces the matrix by its factor. Returns the logarithm of its determinant, or infinity if it is not positive
  /// definite.
  double factorize();
  /// Solves the equations for the right side `right`. Call after `factorize`.
  std::vector<double> solve(std::vector<double> right) const;

 private:
  std::size_t place(std::size_t row, std::size_t column) const {
    return row < banded_ ? band_ * row + (column + band_ - 1 - row)
                         : band_ * banded_ + (row - banded_) * size_ + column;
  }
  std::size_t firstColumn(std::size_t row) const { return row >= banded_ || row < band_ ? 0 : row - band_ + 1; }
  /// The next row after `row` with a non-zero element in `column`.
  std::size_t nextRow(std::size_t row, std::size_t column) const {
    if (row + 1 < column + band_) return row + 1;
    return row + 1 < banded_ ? banded_ : row + 1;
  }

  std::size_t size_;
  std::size_t band_;
  std::size_t banded_;  ///< rows that are not full
  std::vector<double> values_;
};

}  // namespace tactus::experiments
