// What judgements of two strokes, "which was heavier?", can show: how many trials it takes, tests, intervals, and the
// smallest difference that one person feels.
// A difference is counted in just-noticeable differences (JND): one of them is told right in 75 % of the trials.
#pragma once

#include <vector>

#include "core/base/error.h"

namespace tactus::experiments {

/// The share of right answers for a difference of `difference_jnd`: Φ(d'/√2), d' = √2·Φ⁻¹(0.75) for each JND (Macmillan
/// and Creelman 2005). 0.5 for none.
double shareRight(double difference_jnd);
/// The inverse. `share_right`: above 0.5 and below 1.
double differenceJnd(double share_right);
/// The same where the person is given A and B and has to say which of them a third stroke is (ABX).
double abxShareRight(double difference_jnd);

inline constexpr double kAlpha = 0.05;    ///< one-sided; the chance to find a difference where there is none
inline constexpr double kPower = 0.8;     ///< usual chance to find the difference that is looked for
inline constexpr int kMostTrials = 5000;  ///< in which a smallest test is looked for

/// The exact one-sided binomial test of "right as often as wrong".
struct BinomialTest {
  int trials = 0;
  int critical = 0;  ///< fewest right answers that show a difference; more than `trials`: none can
  double size = 0;   ///< chance of that many without a difference, at most `alpha`
  double power = 0;  ///< the same with `share_right`

  bool operator==(const BinomialTest&) const = default;
};
/// The test with `trials` >= 1.
BinomialTest testOf(int trials, double share_right, double alpha = kAlpha);
/// The one with the fewest trials whose power reaches `power`. Power does not rise evenly with the number of trials, so
/// a few more trials may have less. Returns an error if more than kMostTrials are needed.
base::Result<BinomialTest> smallestTest(double share_right, double power = kPower, double alpha = kAlpha);
/// The smallest difference, JND, that `test` finds with `power`.
double detectableJnd(const BinomialTest& test, double power = kPower);
/// The chance of at least `right` of `trials` without a difference. `right` may be half a number ("can't tell").
double chanceWithoutDifference(double right, int trials);

struct ShareInterval {
  double low = 0;
  double high = 1;
};
/// The exact interval of a share (Clopper and Pearson 1934), `right` of `trials` >= 1; half numbers are allowed.
ShareInterval clopperPearson(double right, int trials, double confidence = 0.95);

/// Wald's sequential test of a share of 0.5 against `share_right`, stopped after `most_trials` as "not shown".
struct SequentialTest {
  double share_right = 0.75;
  double alpha = kAlpha;
  double beta = 1 - kPower;
  int most_trials = 40;

  double rightStep() const;  ///< added for a right answer, > 0; half of both steps for "can't tell"
  double wrongStep() const;  ///< added for a wrong one, < 0
  double differAt() const;   ///< a sum from here on: they differ
  double stopAt() const;     ///< a sum up to here: not shown to differ
};
/// What the test does at a true share of right answers, computed exactly.
struct SequentialChances {
  double mean_trials = 0;
  double differ = 0;
};
SequentialChances chancesOf(const SequentialTest& test, double true_share);

/// Wins of one side by the order of the two intervals; "can't tell" is half a win.
struct OrderedWins {
  double wins_first = 0;  ///< where it was felt first
  int trials_first = 0;
  double wins_second = 0;
  int trials_second = 0;
};
/// logit P(i first beats j) = λᵢ - λⱼ + δ.
struct OrderEffect {
  double preference = 0;    ///< λᵢ - λⱼ
  double order = 0;         ///< δ: > 0 where the first of two equal strokes wins
  bool half_added = false;  ///< half a win was added to each count, because one was all or nothing
};
/// The estimate with the largest likelihood. Needs trials in both orders.
OrderEffect orderEffectOf(OrderedWins wins);

// One person's own smallest difference, on one device.

/// A trial: the stroke was `difference` times the nominal JND heavier, and the heavier one was found or not.
struct JndTrial {
  double difference = 0;
  bool right = false;
};
/// What is known of it, as a multiple of the nominal one.
struct OwnJnd {
  double factor = 1;  ///< median of what is believed
  double low = 0;     ///< it lies between these two with 95 %
  double high = 0;
};
/// QUEST+ (Watson 2017) over the threshold: a grid from 0.25 to 4 times the nominal JND, a log-normal prior (sd 0.6), a
/// cumulative normal with lapses of 0.02.
class JndSearch {
 public:
  JndSearch();

  /// The difference whose answer leaves the least expected entropy, as a multiple of the nominal JND.
  double next() const;
  void add(const JndTrial& trial);
  OwnJnd estimate() const;

  /// The share of right answers of a person whose own JND is `factor` times the nominal one.
  static double shareRightOf(double difference, double factor);

 private:
  std::vector<double> posterior_;  ///< of each factor of the grid; sums to 1
};

}  // namespace tactus::experiments
