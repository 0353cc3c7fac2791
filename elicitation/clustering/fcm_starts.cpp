#include "elicitation/clustering/fcm_starts.h"

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

namespace {

/// Index of the entry of `data` below which the share `share` of the weight lies.
std::size_t quantileIndex(const FcmEntries& entries, double total, double share) {
  double sum = 0;
  std::size_t i = 0;
  while (i + 1 < entries.values.size() && sum + entries.weights[i] <= share * total) sum += entries.weights[i++];
  return i;
}

/// Sums of squared distances of runs of entries from their means.
class RunCosts {
 public:
  explicit RunCosts(const FcmEntries& entries) : weight_{0}, sum_{0}, squares_{0} {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const double moment = entries.weights[i] * entries.values[i];
      weight_.push_back(weight_.back() + entries.weights[i]);
      sum_.push_back(sum_.back() + moment);
      squares_.push_back(squares_.back() + moment * entries.values[i]);
    }
  }
  double mean(std::size_t begin, std::size_t end) const {
    return (sum_[end] - sum_[begin]) / (weight_[end] - weight_[begin]);
  }
  double of(std::size_t begin, std::size_t end) const {
    return squares_[end] - squares_[begin] - (sum_[end] - sum_[begin]) * mean(begin, end);
  }

 private:
  std::vector<double> weight_, sum_, squares_;  // of the first i entries
};

/// Lengths for which to find the best beginning of the last run, and where that may lie.
struct RunSearch {
  std::size_t first, last;       // lengths
  std::size_t earliest, latest;  // beginnings
};

/// The best cost of one run more. The best beginning grows with the length, so the middle length divides the search.
void addRun(const RunCosts& costs, const std::vector<double>& cost, RunSearch search, std::vector<double>& next,
            std::vector<std::size_t>& from) {
  if (search.first > search.last) return;
  const std::size_t length = search.first + (search.last - search.first) / 2;
  for (std::size_t begin = search.earliest; begin <= std::min(search.latest, length - 1); ++begin) {
    const double sum = cost[begin] + costs.of(begin, length);
    if (sum < next[length]) {
      next[length] = sum;
      from[length] = begin;
    }
  }
  addRun(costs, cost, {search.first, length - 1, search.earliest, from[length]}, next, from);
  addRun(costs, cost, {length + 1, search.last, from[length], search.latest}, next, from);
}

}  // namespace

std::vector<double> quantileStart(const FcmEntries& entries, std::size_t clusters) {
  const double total = std::accumulate(entries.weights.begin(), entries.weights.end(), 0.0);
  std::vector<std::size_t> index(clusters);
  for (std::size_t k = 0; k < clusters; ++k) {
    index[k] = quantileIndex(entries, total, (static_cast<double>(k) + 0.5) / static_cast<double>(clusters));
    if (k > 0) index[k] = std::max(index[k], index[k - 1] + 1);
  }
  // Equal quantiles were pulled apart upwards; push back what went over the end.
  std::size_t limit = entries.values.size();
  for (std::size_t k = clusters; k-- > 0;) limit = index[k] = std::min(index[k], limit - 1);
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) centres[k] = entries.values[index[k]];
  return centres;
}

std::vector<double> equalWidthStart(const FcmEntries& entries, std::size_t clusters) {
  const double low = entries.values.front();
  const double width = (entries.values.back() - low) / static_cast<double>(clusters);
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) centres[k] = low + width * (static_cast<double>(k) + 0.5);
  return centres;
}

std::vector<double> bestRunsStart(const FcmEntries& entries, std::size_t clusters) {
  const RunCosts costs(entries);
  const std::size_t n = entries.size();
  // cost[i]: of the first i entries in the runs so far; from[k][i]: where the last of k + 1 runs begins.
  std::vector<double> cost(n + 1, 0.0);
  for (std::size_t i = 1; i <= n; ++i) cost[i] = costs.of(0, i);
  std::vector<std::vector<std::size_t>> from(clusters, std::vector<std::size_t>(n + 1, 0));
  for (std::size_t k = 1; k < clusters; ++k) {
    std::vector<double> next(n + 1, std::numeric_limits<double>::infinity());
    addRun(costs, cost, {k + 1, n, k, n - 1}, next, from[k]);
    cost = std::move(next);
  }
  std::vector<double> centres(clusters);
  std::size_t end = n;
  for (std::size_t k = clusters; k-- > 0;) {
    centres[k] = costs.mean(from[k][end], end);
    end = from[k][end];
  }
  return centres;
}

std::vector<double> spreadStart(const FcmEntries& entries, std::size_t clusters, base::Random& random) {
  std::vector<double> share(entries.weights.begin(), entries.weights.end());
  std::vector<double> nearest(entries.values.size(), std::numeric_limits<double>::infinity());
  std::vector<double> centres;
  while (centres.size() < clusters) {
    const double total = std::accumulate(share.begin(), share.end(), 0.0);
    double target = random.uniform() * total;
    std::size_t chosen = entries.values.size();
    for (std::size_t i = 0; i < share.size() && (chosen == entries.values.size() || target >= 0); ++i) {
      if (share[i] <= 0) continue;
      chosen = i;
      target -= share[i];
    }
    if (chosen == entries.values.size()) break;
    centres.push_back(entries.values[chosen]);
    for (std::size_t i = 0; i < share.size(); ++i) {
      const double distance = entries.values[i] - centres.back();
      nearest[i] = std::min(nearest[i], distance * distance);
      share[i] = entries.weights[i] * nearest[i];
    }
  }
  std::sort(centres.begin(), centres.end());
  return centres;
}

}  // namespace tactus::elicitation
