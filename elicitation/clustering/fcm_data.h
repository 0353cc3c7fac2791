// The data of a clustering, scaled when read, without a copy (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::elicitation {

/// Samples in place, with the numbers that map them to [-1, 1]: scales that are powers of two and, for data far from 0,
/// a shift by about the median. So no square of a difference overflows, and a large offset costs no digits.
struct FcmData {
  std::span<const double> values;
  std::span<const double> weights;  ///< one per value; empty: all 1
  double scale = 1;                 ///< x = (value * scale - shift) * stretch
  double shift = 0;
  double stretch = 1;
  double weight_scale = 1;  ///< a power of two that scales the weights to at most 1
  double low = -1;          ///< smallest scaled value with a weight above 0
  double high = 1;
  double lowest = -1;  ///< the same in original units
  double highest = 1;
  /// Some scaled values with a weight above 0, from evenly spread places in the data, ascending: a sketch of their
  /// shape.
  std::vector<double> some;

  double range() const { return high - low; }
  double scaled(double value) const { return (value * scale - shift) * stretch; }
  double weight(std::size_t i) const { return weights.empty() ? 1 : weights[i] * weight_scale; }
  /// A scaled value in the unit of the samples, clamped to their range.
  double toOriginal(double x) const;
  /// J in original units is the scaled J times 2^objectiveExponent().
  int objectiveExponent() const;
};

/// Reads `samples` and `weights` (none, or one each) once and computes their scale. Returns an error for: no samples, a
/// number that is not finite, a negative weight, another number of weights than samples, no weight above 0.
base::Result<FcmData> prepareFcmData(std::span<const double> samples, std::span<const double> weights);

/// Data that are already scaled, ascending, with one weight each. The caller keeps both alive and in place.
FcmData scaledFcmData(std::span<const double> values, std::span<const double> weights);

/// The distinct values with a weight above 0 in original units, ascending; at most `most`, the first ones in the data.
std::vector<double> distinctValues(const FcmData& data, std::size_t most);

// A short weighted substitute for many samples (part of fcm.h).

/// Scaled values, ascending and distinct, each with the total weight of its samples.
struct FcmEntries {
  std::vector<double> values;
  std::vector<double> weights;
  bool exact = false;  ///< no samples of different value were joined

  std::size_t size() const { return values.size(); }
  /// The entries as data for the passes. The entries must stay in place.
  FcmData view() const;
};

/// Makes entries. Short data, and data with few distinct values (quantized speeds), give exact entries: equal values
/// are joined. Other data give a histogram; its entries are the means of narrow bins. The bins have equal width around
/// the median and equal proportion further out, so that an outlier does not widen the others. Reads the data once or
/// twice. At most 65,536 bins, about 2 MB.
FcmEntries condense(const FcmData& data);

/// About `most` entries or fewer: means of narrow, light runs, so that an outlier keeps its own entry.
FcmEntries coarser(const FcmEntries& entries, std::size_t most);

}  // namespace tactus::elicitation
