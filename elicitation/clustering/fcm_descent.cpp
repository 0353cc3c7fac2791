#include "elicitation/clustering/fcm_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/positive_solve.h"

namespace tactus::elicitation {
namespace {

constexpr double kObjectiveNoise = 1e-13;  // J of two neighboring points differs by rounding alone below this share
constexpr double kSmoothM = 3;             // above it J's second derivatives have cusps at the samples
constexpr double kNewtonSafety = 10;       // of the estimate of what a Newton step leaves
constexpr double kOvershoot = 0x1p-50;     // of the end of the data: a few roundings
constexpr double kRoundingOfStep = 1e-16;  // of the smallest gap between centers: no step can do better

double largest(const std::vector<double>& step) {
  double most = 0;
  for (const double s : step) most = std::max(most, std::abs(s));
  return most;
}

double smallestGap(const std::vector<double>& centres) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < centres.size(); ++k) least = std::min(least, centres[k] - centres[k - 1]);
  return least;
}

class Descent {
 public:
  Descent(const FcmData& data, std::vector<double> centres, FcmBeginning beginning, const FcmSettings& settings,
          const FcmBeforePass& before_pass)
      : data_(data),
        settings_(settings),
        before_pass_(before_pass),
        pass_(centres.size(), settings.m),
        centres_(std::move(centres)),
        damping_(beginning == FcmBeginning::kAnywhere ? 1 : 0) {}

  FcmDescent run() {
    bool going = sumsAt(centres_, sums_);
    while (going && out_.iterations < settings_.most_iterations && !out_.converged) {
      ++out_.iterations;
      going = takeStep();
    }
    out_.canceled = !going;
    std::sort(centres_.begin(), centres_.end());
    out_.centres = std::move(centres_);
    out_.objective = std::max(sums_.objective, 0.0);
    return std::move(out_);
  }

 private:
  bool sumsAt(const std::vector<double>& centres, FcmSums& sums) {
    if (before_pass_ && !before_pass_(change_)) return false;
    pass_.run(data_, centres, sums);
    return true;
  }

  /// One step that does not raise J; false when the descent is to stop.
  bool takeStep() {
    while (true) {
      solve();
      const double size = largest(step_);
      if (leavesNothing(size)) {
        // J at the end by its second-order expansion, whose error is far below the rounding of J.
        for (std::size_t k = 0; k < step_.size(); ++k) sums_.objective -= step_[k] * sums_.pull[k];
        moveTo(candidate_, size);
        out_.converged = true;
        return true;
      }
      const bool possible = damping_ == 1 || inOrder();
      if (possible) {
        if (!sumsAt(candidate_, next_)) return false;
        if (damping_ == 1 || next_.objective <= sums_.objective * (1 + kObjectiveNoise)) {
          out_.converged = isSmall(size);
          moveTo(candidate_, size);
          std::swap(sums_, next_);
          if (damping_ == 1) putInOrder();
          damping_ = damping_ > 0.2 ? damping_ / 2 : 0;
          return true;
        }
      }
      damping_ = std::min(1.0, damping_ == 0 ? 0.25 : 2 * damping_);
    }
  }

  /// step_ and candidate_ for the present damping, raised until the matrix is positive definite.
  void solve() {
    const std::size_t c = centres_.size();
    while (true) {
      if (damping_ < 1) {
        matrix_ = sums_.curvature;
        for (double& entry : matrix_) entry *= 1 - damping_;
        for (std::size_t k = 0; k < c; ++k) matrix_[k * c + k] += damping_ * sums_.weight[k];
        step_ = sums_.pull;
        const bool positive = solvePositive(matrix_, step_);
        if (damping_ == 0) out_.minimum = positive;
        if (positive) break;
        damping_ = std::min(1.0, damping_ == 0 ? 0.25 : 2 * damping_);
        continue;
      }
      step_ = sums_.pull;  // Bezdek's step: to the means of the samples weighted by u^m
      for (std::size_t k = 0; k < c; ++k) step_[k] = sums_.weight[k] > 0 ? step_[k] / sums_.weight[k] : 0;
      break;
    }
    candidate_ = centres_;
    for (std::size_t k = 0; k < c; ++k) candidate_[k] = withoutOvershoot(centres_[k] + step_[k]);
  }

  /// A center that belongs to an outlier alone lies on it, at the end of the data; the rounding of a step must not
  /// carry it past, which would forbid the step to all others.
  double withoutOvershoot(double centre) const {
    if (centre > data_.high && centre - data_.high <= kOvershoot * std::abs(data_.high)) return data_.high;
    if (centre < data_.low && data_.low - centre <= kOvershoot * std::abs(data_.low)) return data_.low;
    return centre;
  }

  /// A step may not carry centers out of the data or past each other: it would leave its own valley.
  bool inOrder() const {
    return candidate_.front() >= data_.low && candidate_.back() <= data_.high && smallestGap(candidate_) > 0;
  }

  /// Whether Newton's step, whose error is quadratic, ends below rounding. The error grows where J is flat, which
  /// shows in a Newton step much longer than Bezdek's.
  bool leavesNothing(double size) const {
    if (damping_ != 0 || !inOrder()) return false;
    if (size == 0) return true;
    if (settings_.m > kSmoothM) return false;
    double plain = 0;
    for (std::size_t k = 0; k < step_.size(); ++k) plain = std::max(plain, std::abs(sums_.pull[k] / sums_.weight[k]));
    const double gap = std::min(smallestGap(centres_), data_.range()) * std::min(1.0, settings_.m - 1);
    const double rest = kNewtonSafety * (size / gap) * (size / gap) * std::max(1.0, size / plain);
    return rest <= std::max(kRoundingOfStep, 1e-3 * settings_.tolerance);
  }

  /// Whether the step of `size` just taken may be the last: what remains is small beside the gaps, or J falls no more.
  bool isSmall(double size) const {
    double rest = size;  // Newton's steps shrink ever faster
    if (damping_ > 0) {  // linear: what remains is a geometric series
      const double rate = change_ > 0 ? size / change_ : 0;
      rest = rate < 1 ? size * std::max(1.0, rate / (1 - rate)) : std::numeric_limits<double>::infinity();
    }
    if (size == 0 || rest <= settings_.tolerance * std::min(smallestGap(candidate_), data_.range())) return true;
    return size <= settings_.tolerance * data_.range() && next_.objective >= sums_.objective;
  }

  /// Bezdek's step may carry centers past each other, as an outlier takes one of them out of the middle. Their numbers
  /// follow the order again, or Newton's step would never be in order.
  void putInOrder() {
    const std::size_t c = centres_.size();
    if (std::is_sorted(centres_.begin(), centres_.end())) return;
    std::vector<std::size_t> order(c);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t k, std::size_t l) { return centres_[k] < centres_[l]; });
    const std::vector<double> centres = centres_;
    const FcmSums sums = sums_;
    for (std::size_t k = 0; k < c; ++k) {
      centres_[k] = centres[order[k]];
      sums_.weight[k] = sums.weight[order[k]];
      sums_.pull[k] = sums.pull[order[k]];
      for (std::size_t l = 0; l < c; ++l) sums_.curvature[k * c + l] = sums.curvature[order[k] * c + order[l]];
    }
  }

  void moveTo(const std::vector<double>& centres, double size) {
    centres_ = centres;
    change_ = size;
  }

  const FcmData& data_;
  const FcmSettings& settings_;
  const FcmBeforePass& before_pass_;
  FcmPass pass_;
  std::vector<double> centres_;
  double damping_;                                           // 0: Newton's step, 1: Bezdek's
  double change_ = std::numeric_limits<double>::infinity();  // of the last step
  FcmSums sums_, next_;
  std::vector<double> matrix_, step_, candidate_;
  FcmDescent out_;
};

}  // namespace

FcmDescent descend(const FcmData& data, std::vector<double> centres, FcmBeginning beginning,
                   const FcmSettings& settings, const FcmBeforePass& before_pass) {
  return Descent(data, std::move(centres), beginning, settings, before_pass).run();
}

}  // namespace tactus::elicitation
