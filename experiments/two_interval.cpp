#include "experiments/two_interval.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::experiments {
namespace {

using base::incompleteBeta;
using base::normalShare;

// Φ⁻¹(0.75).
constexpr double kZAtOneJnd = 0.67448975019608174;
constexpr double kDPrimeAtOneJnd = std::numbers::sqrt2 * kZAtOneJnd;

/// The `x` in [low, high] at which the rising `f` reaches `value`.
template <class Function>
double reachedAt(Function f, double value, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (f(middle) < value ? low : high) = middle;
  }
  return high;
}

/// The chance of at least `right` of `trials`.
double upperTail(double right, int trials, double share) {
  if (right <= 0) return 1;
  if (right > trials) return 0;
  return incompleteBeta(right, trials - right + 1, share, 1 - share);
}

int criticalCount(int trials, double alpha) {
  int low = trials / 2;  // its chance is above any alpha below one half
  int high = trials + 1;
  while (low + 1 < high) {
    const int middle = low + (high - low) / 2;
    (upperTail(middle, trials, 0.5) <= alpha ? high : low) = middle;
  }
  return high;
}

}  // namespace

double shareRight(double difference_jnd) { return normalShare(kZAtOneJnd * difference_jnd); }

double differenceJnd(double share_right) {
  TACTUS_CHECK(share_right > 0.5 && share_right < 1);
  return reachedAt(shareRight, share_right, 0, 60);
}

double abxShareRight(double difference_jnd) {
  const double d = kDPrimeAtOneJnd * difference_jnd;
  const double whole = normalShare(d / std::numbers::sqrt2);
  const double half = normalShare(d / 2);
  return whole * half + (1 - whole) * (1 - half);
}

BinomialTest testOf(int trials, double share_right, double alpha) {
  TACTUS_CHECK(trials >= 1 && alpha > 0 && alpha < 0.5);
  const int critical = criticalCount(trials, alpha);
  return {trials, critical, upperTail(critical, trials, 0.5), upperTail(critical, trials, share_right)};
}

base::Result<BinomialTest> smallestTest(double share_right, double power, double alpha) {
  for (int trials = 1; trials <= kMostTrials; ++trials) {
    const BinomialTest test = testOf(trials, share_right, alpha);
    if (test.power >= power) return test;
  }
  return base::fail(base::ErrorCode::kValue, "share of right answers", base::formatNumber(share_right),
                    "one for which " + std::to_string(kMostTrials) + " trials are enough");
}

double detectableJnd(const BinomialTest& test, double power) {
  const auto power_at = [&](double share) { return upperTail(test.critical, test.trials, share); };
  const double share = reachedAt(power_at, power, 0.5, 1);
  return share < 1 ? differenceJnd(share) : std::numeric_limits<double>::infinity();
}

double chanceWithoutDifference(double right, int trials) { return upperTail(right, trials, 0.5); }

ShareInterval clopperPearson(double right, int trials, double confidence) {
  TACTUS_CHECK(trials >= 1 && right >= 0 && right <= trials && confidence > 0 && confidence < 1);
  const double side = (1 - confidence) / 2;
  ShareInterval out;
  if (right > 0) out.low = reachedAt([&](double share) { return upperTail(right, trials, share); }, side, 0, 1);
  if (right < trials) {
    out.high = reachedAt([&](double share) { return incompleteBeta(right + 1, trials - right, share, 1 - share); },
                         1 - side, 0, 1);
  }
  return out;
}

double SequentialTest::rightStep() const { return std::log(share_right / 0.5); }
double SequentialTest::wrongStep() const { return std::log((1 - share_right) / 0.5); }
double SequentialTest::differAt() const { return std::log((1 - beta) / alpha); }
double SequentialTest::stopAt() const { return std::log(beta / (1 - alpha)); }

SequentialChances chancesOf(const SequentialTest& test, double true_share) {
  SequentialChances out;
  std::vector<double> going = {1};  // the chance of each number of right answers without a decision so far
  for (int trial = 1; trial <= test.most_trials; ++trial) {
    std::vector<double> next(static_cast<std::size_t>(trial) + 1, 0.0);
    for (std::size_t right = 0; right < going.size(); ++right) {
      out.mean_trials += going[right];
      next[right] += going[right] * (1 - true_share);
      next[right + 1] += going[right] * true_share;
    }
    for (std::size_t right = 0; right < next.size(); ++right) {
      const double sum = static_cast<double>(right) * test.rightStep() +
                         static_cast<double>(static_cast<std::size_t>(trial) - right) * test.wrongStep();
      if (sum >= test.differAt()) out.differ += next[right];
      if (sum >= test.differAt() || sum <= test.stopAt()) next[right] = 0;
    }
    going = std::move(next);
  }
  return out;
}

OrderEffect orderEffectOf(OrderedWins wins) {
  TACTUS_CHECK(wins.trials_first > 0 && wins.trials_second > 0);
  const auto at_an_end = [](double won, int trials) { return won <= 0 || won >= trials; };
  OrderEffect out;
  out.half_added = at_an_end(wins.wins_first, wins.trials_first) || at_an_end(wins.wins_second, wins.trials_second);
  const double added = out.half_added ? 0.5 : 0;
  const auto logit = [added](double won, int trials) { return std::log((won + added) / (trials - won + added)); };
  const double first = logit(wins.wins_first, wins.trials_first);     // preference + order
  const double second = logit(wins.wins_second, wins.trials_second);  // preference - order
  out.preference = (first + second) / 2;
  out.order = (first - second) / 2;
  return out;
}

namespace {

constexpr std::size_t kFactors = 41;
constexpr double kLeastFactor = 0.25;
constexpr double kMostFactor = 4;
constexpr double kPriorSd = 0.6;  // of the logarithm
constexpr double kLapse = 0.02;
constexpr std::size_t kDifferences = 30;
constexpr double kLeastDifference = 0.1;
constexpr double kMostDifference = 8;

double onLogGrid(double low, double high, std::size_t i, std::size_t count) {
  return low * std::pow(high / low, static_cast<double>(i) / static_cast<double>(count - 1));
}

double factorAt(std::size_t i) { return onLogGrid(kLeastFactor, kMostFactor, i, kFactors); }

/// Of a yes or no, in nats.
double entropyOf(double share) { return -share * std::log(share) - (1 - share) * std::log(1 - share); }

void normalize(std::vector<double>& weights) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
}

}  // namespace

JndSearch::JndSearch() : posterior_(kFactors) {
  for (std::size_t i = 0; i < kFactors; ++i) {
    const double z = std::log(factorAt(i)) / kPriorSd;
    posterior_[i] = std::exp(-z * z / 2);
  }
  normalize(posterior_);
}

double JndSearch::shareRightOf(double difference, double factor) {
  return kLapse / 2 + (1 - kLapse) * shareRight(difference / factor);
}

// The least expected entropy of the threshold is the largest mutual information of threshold and answer.
double JndSearch::next() const {
  double best = 0;
  double most = -1;
  for (std::size_t d = 0; d < kDifferences; ++d) {
    const double difference = onLogGrid(kLeastDifference, kMostDifference, d, kDifferences);
    double mean = 0;
    double known = 0;
    for (std::size_t i = 0; i < kFactors; ++i) {
      const double share = shareRightOf(difference, factorAt(i));
      mean += posterior_[i] * share;
      known += posterior_[i] * entropyOf(share);
    }
    const double information = entropyOf(mean) - known;
    if (information > most) {
      most = information;
      best = difference;
    }
  }
  return best;
}

void JndSearch::add(const JndTrial& trial) {
  for (std::size_t i = 0; i < kFactors; ++i) {
    const double share = shareRightOf(trial.difference, factorAt(i));
    posterior_[i] *= trial.right ? share : 1 - share;
  }
  normalize(posterior_);
}

OwnJnd JndSearch::estimate() const {
  // Between two points of the grid the distribution rises evenly with the logarithm.
  const auto quantile = [&](double share) {
    double below = 0;
    for (std::size_t i = 0; i < kFactors; ++i) {
      if (below + posterior_[i] >= share) {
        const double within = (share - below) / posterior_[i] - 0.5;
        return factorAt(i) * std::pow(kMostFactor / kLeastFactor, within / static_cast<double>(kFactors - 1));
      }
      below += posterior_[i];
    }
    return kMostFactor;
  };
  return {quantile(0.5), quantile(0.025), quantile(0.975)};
}

}  // namespace tactus::experiments
