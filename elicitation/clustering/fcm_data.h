// The data of a clustering as the passes see it: in place, scaled on the way (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::elicitation {

/// Samples that stay where they are, with the numbers that bring them into [-1, 1]: scaled by powers of two and, where
/// they lie far from 0, shifted by about their median. Then no square of a difference overflows, and a large offset
/// costs no digits.
struct FcmData {
  std::span<const double> values;
  std::span<const double> weights;  ///< one per value, or none: all 1
  double scale = 1;                 ///< x = (value * scale - shift) * stretch
  double shift = 0;
  double stretch = 1;
  double weight_scale = 1;  ///< a power of two that brings the weights to at most 1
  double low = -1;          ///< of the scaled values with weight
  double high = 1;
  double lowest = -1;  ///< the same in original units
  double highest = 1;
  /// A few scaled values with weight from places spread evenly over the data, ascending: their shape in short.
  std::vector<double> some;

  double range() const { return high - low; }
  double scaled(double value) const { return (value * scale - shift) * stretch; }
  double weight(std::size_t i) const { return weights.empty() ? 1 : weights[i] * weight_scale; }
  /// A scaled value in the unit of the samples, not outside them.
  double toOriginal(double x) const;
  /// J in original units is the scaled J times 2^objectiveExponent().
  int objectiveExponent() const;
};

/// Looks over `samples` and their weights (none, or one each) once and gives them their scale. Refused: no samples, a
/// number that is not finite, a negative weight, another number of weights than samples, no weight above 0.
base::Result<FcmData> prepareFcmData(std::span<const double> samples, std::span<const double> weights);

/// Values that are scaled already, ascending, with one weight each; both must stay where they are.
FcmData scaledFcmData(std::span<const double> values, std::span<const double> weights);

/// The distinct values with weight in original units, ascending, but at most `most` of them: the first to be met.
std::vector<double> distinctValues(const FcmData& data, std::size_t most);
}  // namespace tactus::elicitation
