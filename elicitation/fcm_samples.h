// The data of a clustering in a form that is safe to compute with (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tactus::elicitation {

/// Values and how many samples each stands for; no weights means one each.
struct WeightedValues {
  std::span<const double> values;
  std::span<const double> weights;
};

/// A sorted copy of the samples, shifted by their median and scaled by powers of two so that they lie in [-1, 1].
/// Then no square of a difference overflows, and a large offset costs no digits.
class ScaledSamples {
 public:
  /// Finite samples, at least one.
  explicit ScaledSamples(std::span<const double> samples);

  /// Ascending.
  std::span<const double> values() const { return values_; }
  double range() const { return values_.back() - values_.front(); }
  /// A scaled value in the unit of the samples.
  double toOriginal(double scaled) const;
  /// J in original units is the scaled J times 2^objectiveExponent().
  int objectiveExponent() const { return 2 * (size_exponent_ + spread_exponent_); }
  /// The smallest distinct samples in original units, ascending, at most kMostClusters + 1 of them.
  std::span<const double> firstDistinct() const { return first_distinct_; }

 private:
  std::vector<double> values_;
  std::vector<double> first_distinct_;
  int size_exponent_ = 0;    // the largest |sample| lies below 2^size_exponent_
  int spread_exponent_ = 0;  // after that scaling no distance from the median exceeds 2^spread_exponent_
  double median_ = 0;        // after that scaling
};

/// A short weighted stand-in for many sorted values: equal values joined where that makes it short enough, otherwise
/// the means of runs that are narrow and light, so that an outlier keeps a place of its own.
class CoarseSamples {
 public:
  /// At most about `most` entries.
  CoarseSamples(std::span<const double> sorted, std::size_t most);

  WeightedValues view() const { return {values_, weights_}; }

 private:
  std::vector<double> values_;
  std::vector<double> weights_;
};

}  // namespace tactus::elicitation
