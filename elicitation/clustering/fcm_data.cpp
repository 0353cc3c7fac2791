#include "elicitation/clustering/fcm_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr std::size_t kSome = 255;      // values whose median becomes the shift; any value near the middle does
constexpr int kLargestExponent = 1000;  // of a power of two by which values are multiplied

/// The smallest e with |x| <= 2^e; 0 for x = 0.
int exponentAbove(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(x), &exponent);
  return mantissa == 0.5 ? exponent - 1 : exponent;
}

/// The power of two that brings a number of size `most` near 1.
double powerFor(double most) {
  return std::ldexp(1.0, std::clamp(-exponentAbove(most), -kLargestExponent, kLargestExponent));
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double check = 0;  // not a number if some value is not finite
};

/// Eight extents side by side, so that no comparison waits for the one before.
Extent extentOf(std::span<const double> values) {
  constexpr std::size_t kSide = 8;
  double low[kSide], high[kSide], check[kSide];
  std::fill(low, low + kSide, std::numeric_limits<double>::infinity());
  std::fill(high, high + kSide, -std::numeric_limits<double>::infinity());
  std::fill(check, check + kSide, 0.0);
  std::size_t i = 0;
  for (; i + kSide <= values.size(); i += kSide) {
    for (std::size_t j = 0; j < kSide; ++j) {
      const double x = values[i + j];
      low[j] = x < low[j] ? x : low[j];
      high[j] = x > high[j] ? x : high[j];
      check[j] += x * 0.0;
    }
  }
  Extent out;
  for (std::size_t j = 0; j < kSide; ++j) {
    out.low = std::min(out.low, low[j]);
    out.high = std::max(out.high, high[j]);
    out.check += check[j];
  }
  for (; i < values.size(); ++i) {
    out.low = std::min(out.low, values[i]);
    out.high = std::max(out.high, values[i]);
    out.check += values[i] * 0.0;
  }
  return out;
}

/// The extent of the values that count.
Extent extentOf(std::span<const double> values, std::span<const double> weights) {
  if (weights.empty()) return extentOf(values);
  Extent out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    out.check += values[i] * 0.0;
    if (weights[i] == 0) continue;
    out.low = std::min(out.low, values[i]);
    out.high = std::max(out.high, values[i]);
  }
  return out;
}

/// The largest weight.
Result<double> checkWeights(std::span<const double> samples, std::span<const double> weights) {
  if (weights.empty()) return 1;
  if (weights.size() != samples.size()) {
    return fail(ErrorCode::kData, "weights", std::to_string(weights.size()),
                std::to_string(samples.size()) + ", one for each sample");
  }
  double most = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0 && std::isfinite(weights[i]))) {
      return fail(ErrorCode::kValue, "weight " + std::to_string(i + 1), base::formatNumber(weights[i]),
                  "a finite number of at least 0");
    }
    most = std::max(most, weights[i]);
  }
  if (most == 0) return fail(ErrorCode::kData, "weights", "none above 0", "at least one above 0 for each cluster");
  return most;
}

/// Some values with weight from places spread evenly over the data, times data.scale, ascending.
std::vector<double> someValues(const FcmData& data) {
  const std::size_t n = data.values.size();
  const std::size_t count = std::min(kSome, n);
  std::vector<double> out;
  for (std::size_t k = 0; k < count; ++k) {
    // The middle of the k-th part, and on to the part's end past samples without weight.
    const std::size_t end = n * (k + 1) / count;
    std::size_t i = (n * k / count + end) / 2;
    while (i < end && data.weight(i) == 0) ++i;
    if (i < end) out.push_back(data.values[i] * data.scale);
  }
  for (std::size_t i = 0; out.empty(); ++i) {
    if (data.weight(i) > 0) out.push_back(data.values[i] * data.scale);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// The median where the values lie close together beside it; subtracting it from them is exact then. Elsewhere 0, since
/// subtracting would cost small values their digits.
double shiftFor(const std::vector<double>& some) {
  const double median = some[some.size() / 2];
  const std::size_t tenth = some.size() / 10;
  const double core = std::max(median - some[tenth], some[some.size() - 1 - tenth] - median);
  return std::abs(median) > 2 * core ? median : 0;
}

tl::unexpected<base::Error> refuseNotFinite(std::span<const double> samples) {
  std::size_t i = 0;
  while (std::isfinite(samples[i])) ++i;
  return fail(ErrorCode::kValue, "sample " + std::to_string(i + 1), base::formatNumber(samples[i]), "a finite number");
}

}  // namespace

double FcmData::toOriginal(double x) const { return std::clamp((x / stretch + shift) / scale, lowest, highest); }

int FcmData::objectiveExponent() const {
  return -2 * (std::ilogb(scale) + std::ilogb(stretch)) - std::ilogb(weight_scale);
}

Result<FcmData> prepareFcmData(std::span<const double> samples, std::span<const double> weights) {
  if (samples.empty()) return fail(ErrorCode::kData, "samples", "none", "at least one for each cluster");
  const auto heaviest = checkWeights(samples, weights);
  if (!heaviest) return tl::unexpected(heaviest.error());
  const Extent extent = extentOf(samples, weights);
  if (std::isnan(extent.check)) return refuseNotFinite(samples);

  FcmData data;
  data.values = samples;
  data.weights = weights;
  if (!weights.empty()) data.weight_scale = powerFor(*heaviest);
  // Scaling comes before the shift: the difference of two large values could overflow.
  data.scale = powerFor(std::max(std::abs(extent.low), std::abs(extent.high)));
  data.some = someValues(data);
  data.shift = shiftFor(data.some);
  data.stretch = powerFor(
      std::max(std::abs(data.shift - extent.low * data.scale), std::abs(extent.high * data.scale - data.shift)));
  data.lowest = extent.low;
  data.highest = extent.high;
  data.low = data.scaled(extent.low);
  data.high = data.scaled(extent.high);
  for (double& x : data.some) x = (x - data.shift) * data.stretch;
  return data;
}

FcmData scaledFcmData(std::span<const double> values, std::span<const double> weights) {
  FcmData data;
  data.values = values;
  data.weights = weights;
  data.low = data.lowest = values.front();
  data.high = data.highest = values.back();
  return data;
}

std::vector<double> distinctValues(const FcmData& data, std::size_t most) {
  std::vector<double> found;
  for (std::size_t i = 0; i < data.values.size() && found.size() < most; ++i) {
    if (data.weight(i) == 0) continue;
    const auto at = std::lower_bound(found.begin(), found.end(), data.values[i]);
    if (at == found.end() || *at != data.values[i]) found.insert(at, data.values[i]);
  }
  return found;
}

}  // namespace tactus::elicitation
