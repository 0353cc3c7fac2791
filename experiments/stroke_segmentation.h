// Finds insertion strokes in a stream of positions.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "experiments/speed_from_positions.h"
#include "experiments/stroke.h"

namespace tactus::experiments {

// The likelihood of a smooth movement with tremor for given positions: the inner part of stroke_segmentation.h.

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

// Detects forward and backward movements in resampled positions with tremor and noise. Its edges are coarse.

/// A movement, in steps of EvenPositions.
struct Movement {
  std::size_t begin = 0;
  std::size_t fast_from = 0;  ///< first and last step at the starting speed or above
  std::size_t fast_to = 0;
  std::size_t end = 0;
  bool forward = true;
  bool interrupted = false;  ///< the positions ended during the movement
};

/// The two-threshold rule of stroke_segmentation.h, applied to one stretch without gaps.
class MovementDetector {
 public:
  /// `lowest_been_mm`: the furthest-back position of the hand in earlier stretches.
  MovementDetector(const StrokeSettings& settings, double lowest_been_mm);

  /// Processes all steps with enough positions after them; all steps if the stretch has `ended`.
  void advance(const EvenPositions& positions, bool ended);
  /// The next completed movement, or nothing.
  std::optional<Movement> take();

  bool movingForward() const noexcept { return phase_ == Phase::kMoving; }
  double lowestBeenMm() const noexcept { return lowest_been_mm_; }
  /// Positions before this step are no longer needed, except to measure movements already taken.
  std::size_t earliestNeeded() const noexcept;
  void forgetBefore(std::size_t step);

 private:
  enum class Phase { kIdle, kMoving, kPausing };

  double slopeAt(const EvenPositions& positions, std::size_t step) const;
  double speedAt(std::size_t step) const { return speeds_mm_s_[step - first_]; }
  std::size_t quietBefore(std::size_t step, double direction) const;
  void lookForward(std::size_t step, double position_mm, double speed_mm_s);
  void lookBack(std::size_t step, double position_mm, double speed_mm_s);
  void close(std::size_t end, double length_mm, bool interrupted);

  StrokeSettings settings_;
  std::size_t half_window_;
  std::size_t pause_steps_;
  std::deque<double> speeds_mm_s_;
  std::size_t first_ = 0;
  std::size_t decided_ = 0;

  Phase phase_ = Phase::kIdle;
  Movement forward_;
  double begin_mm_ = 0;
  double furthest_mm_ = 0;
  std::size_t paused_at_ = 0;

  std::optional<Movement> back_;
  double lowest_been_mm_;
  std::deque<Movement> found_;
};

// A hand movement without its tremor: a smooth curve fitted to positions, and its derivative.

/// Positions = smooth movement + one sinusoid of 7 to 13 Hz + white noise.
///
/// The movement is a cubic spline with a penalty on its third differences (Eilers and Marx 1996). The penalty is
/// smaller where the movement is rough, as at the ends of a quick stroke; roughness and fit are computed alternately.
/// The sinusoid has an amplitude of about 0.2 mm; its amplitude and phase may drift linearly. So it absorbs the tremor
/// (8 to 12 Hz). Penalty, frequency and the best of six starts are chosen by the largest restricted likelihood (REML;
/// Patterson and Thompson 1971). The fit uses both sides of each point equally, so it has no delay. It takes about
/// 2 ms.
class SmoothMotion {
 public:
  /// Fits `positions_mm`, at equal steps of `step_s` (1 to 12 ms): from kFewestPositions to a few hundred positions,
  /// each within 1e6 mm.
  SmoothMotion(std::span<const double> positions_mm, double step_s);

  static constexpr std::size_t kFewestPositions = 20;

  /// Speed of the movement without tremor, `time_s` after the first position. Times outside the stretch are clamped.
  double speedMmS(double time_s) const;
  /// Position of the movement without tremor at the same time.
  double positionMm(double time_s) const;

 private:
  std::vector<double> coefficients_;
  double knot_s_;
  double length_s_;
  double offset_mm_;
};

/// Finds strokes while samples arrive.
///
/// A stroke starts when the hand's speed reaches `start_speed_mm_s`. It ends when the speed stays below
/// `stop_speed_mm_s` for longer than `longest_pause_s`, or when the hand moves back by more than `longest_reversal_mm`.
/// This decision uses the slope over `speed_window_s`. Then both ends are measured again without delay, on the movement
/// without tremor (stroke_segmentation.h), at its speed `edge_speed_mm_s`. A movement back to earlier positions is a
/// return, not a stroke. Neither is a forward movement of less than `least_mm`.
///
/// Samples may arrive at any rate above about 60 Hz, evenly or not. A sample is ignored if its time does not rise, it
/// is not finite, or it is further away than a kilometer; it still counts for `first` and `last`. The strokes depend on
/// the samples only, not on the times of the calls.
class StrokeFinder {
 public:
  /// The settings must be valid (checked as our own bug; see `validate`).
  explicit StrokeFinder(const StrokeSettings& settings = {});

  /// Adds the next sample. Thread: any, one at a time. Real-time safe: no.
  void add(const PositionSample& sample);
  /// Ends the stream. A movement in progress becomes `interrupted`.
  void finish();
  /// The next stroke in time order; nothing if there is none yet. A stroke is available about 0.7 s after its end.
  std::optional<Stroke> take();

  /// Whether the hand is currently moving forward, as far as known. For display.
  bool moving() const noexcept { return stretch_ && stretch_->detector.movingForward(); }

 private:
  struct Taken {
    PositionSample sample;
    std::size_t index;
  };
  struct Edge {
    double time_s;
    double position_mm;
  };
  /// The data since the last gap.
  struct Stretch {
    Stretch(const StrokeSettings& settings, const PositionSample& first, double lowest_been_mm)
        : positions(first), detector(settings, lowest_been_mm) {}
    EvenPositions positions;
    MovementDetector detector;
    std::deque<Taken> samples;
    std::deque<Movement> to_measure;
  };

  void endStretch();
  void advance(bool ended);
  void measure(const Movement& movement);
  Edge edgeOf(const Movement& movement, bool at_start) const;
  StrokeVerdict verdictOf(const Stroke& stroke, const Movement& movement) const;
  void forget();

  StrokeSettings settings_;
  std::optional<Stretch> stretch_;
  std::optional<double> lowest_been_mm_;
  std::size_t sample_count_ = 0;
  std::deque<Stroke> strokes_;
};

/// The strokes of a whole recording, equal to those of a StrokeFinder. Returns the error of `validate` for invalid
/// settings.
base::Result<std::vector<Stroke>> findStrokes(std::span<const PositionSample> samples,
                                              const StrokeSettings& settings = {});

}  // namespace tactus::experiments
