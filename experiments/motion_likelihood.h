// The likelihood of a smooth movement with tremor for given positions: the inner part of stroke_segmentation.h.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace tactus::experiments {

// Cholesky factorization of a symmetric band matrix, and the solution of equations in two halves.

/// A symmetric positive definite matrix A, stored as its lower triangle: `Band` elements in each row, the diagonal
/// last. The factor L with A = L Lᵀ has the same shape, so factorization costs a few operations for each stored
/// element. A full matrix of at most `Band` rows is a band matrix too.
template <std::size_t Band>
class BandMatrix {
 public:
  explicit BandMatrix(std::size_t size) : rows_(kAbove + size), inverse_(kAbove + size) {}

  std::size_t size() const { return rows_.size() - kAbove; }

  /// A stored element: row - Band < column <= row.
  double& at(std::size_t row, std::size_t column) { return rows_[kAbove + row][kAbove + column - row]; }

  /// Replaces the matrix by its factor. Returns the logarithm of its determinant, or infinity if it is not positive
  /// definite.
  double factorize() {
    double log_determinant = 0;
    for (std::size_t i = kAbove; i < rows_.size(); ++i) {
      auto& row = rows_[i];
      for (std::size_t k = 0; k < kAbove; ++k) {
        const auto& above = rows_[i - kAbove + k];
        for (std::size_t m = 0; m < k; ++m) row[k] -= row[m] * above[kAbove - k + m];
        row[k] *= inverse_[i - kAbove + k];
      }
      double pivot = row[kAbove];
      for (std::size_t k = 0; k < kAbove; ++k) pivot -= row[k] * row[k];
      if (!(pivot > 0)) return std::numeric_limits<double>::infinity();
      log_determinant += std::log(pivot);
      row[kAbove] = std::sqrt(pivot);
      inverse_[i] = 1 / row[kAbove];
    }
    return log_determinant;
  }

  /// Replaces `right`, of `size` elements for each of `Columns` right sides, by L⁻¹ right. Call after `factorize`.
  template <std::size_t Columns>
  void forward(std::span<std::array<double, Columns>> right) const {
    for (std::size_t i = 0; i < right.size(); ++i) {
      const auto& row = rows_[kAbove + i];
      for (std::size_t k = i < kAbove ? kAbove - i : 0; k < kAbove; ++k) {
        for (std::size_t c = 0; c < Columns; ++c) right[i][c] -= row[k] * right[i - kAbove + k][c];
      }
      for (double& value : right[i]) value *= inverse_[kAbove + i];
    }
  }

  /// Replaces `right` by L⁻ᵀ right. `forward`, then `backward`, solve the equations.
  template <std::size_t Columns>
  void backward(std::span<std::array<double, Columns>> right) const {
    for (std::size_t i = right.size(); i-- > 0;) {
      for (double& value : right[i]) value *= inverse_[kAbove + i];
      const auto& row = rows_[kAbove + i];
      for (std::size_t k = i < kAbove ? kAbove - i : 0; k < kAbove; ++k) {
        for (std::size_t c = 0; c < Columns; ++c) right[i - kAbove + k][c] -= row[k] * right[i][c];
      }
    }
  }

 private:
  static constexpr std::size_t kAbove =
      Band - 1;  // rows of zeros above the matrix: each row has a whole band before it

  std::vector<std::array<double, Band>> rows_;
  std::vector<double> inverse_;  ///< of the factor's diagonal; 0 above the matrix
};

inline constexpr double kKnotS = 0.012;  // between knots: resolves ramps of 30 ms; the penalty smooths shorter details
inline constexpr std::size_t kSplineOrder = 4;    // cubic
inline constexpr std::size_t kTremorColumns = 4;  // sine and cosine, and their linear change

/// The four non-zero cubic B-splines at `u` in [0, 1] between two knots.
std::array<double, kSplineOrder> splineValues(double u);

/// A value for each tremor column.
using TremorRow = std::array<double, kTremorColumns>;

/// The part of the normal equations that belongs to a sinusoid of one frequency.
struct TremorEquations {
  std::vector<TremorRow> with_splines;  ///< products with each spline
  BandMatrix<kTremorColumns> among{kTremorColumns};
  TremorRow right{};
};

/// Normal equations of the spline, which all frequencies share, and of a sinusoid of each frequency.
struct MotionEquations {
  /// `noise_mm`: standard deviation of each position. The tremor has its usual amplitude as a prior, so that the
  /// sinusoid cannot replace the movement.
  MotionEquations(std::span<const double> positions_mm, double step_s, double offset_mm, std::span<const double> hz,
                  std::size_t spline_count, double noise_mm);

  BandMatrix<kSplineOrder> splines;
  std::vector<std::array<double, 1>> right;  ///< for each spline
  std::vector<TremorEquations> tremors;      ///< one for each frequency
  double squares_mm2 = 0;
  double positions = 0;
};

/// The fit of maximum likelihood among the tried penalties and frequencies.
struct MotionFit {
  double unlikelihood = std::numeric_limits<double>::infinity();  ///< -2 log of the restricted likelihood
  std::size_t frequency = 0;                                      ///< its index
  int penalty = 0;                                                ///< exponent of 10
  std::vector<double> coefficients;                               ///< of the splines
};

/// The most likely fit over all frequencies and penalties. `rough`: relative roughness of the movement at each third
/// difference of the coefficients. `near`: if given, only neighbors of this fit are tried.
MotionFit likeliestMotion(const MotionEquations& equations, std::span<const double> rough,
                          const MotionFit* near = nullptr);

/// The roughness of a movement at each third difference of its coefficients, relative to the mean, at least 1e-4.
std::vector<double> roughness(std::span<const double> coefficients);

}  // namespace tactus::experiments
