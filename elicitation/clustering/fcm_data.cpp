#include "elicitation/clustering/fcm_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

constexpr std::size_t kShort = 2048;            // data up to this length are sorted
constexpr std::size_t kMostDistinct = 4096;     // more distinct values go into a histogram
constexpr unsigned kSlotBits = 14;              // of the table of distinct values, a quarter full at most
constexpr std::size_t kRepeatsOfQuantised = 4;  // among data.some; 4,096 equally frequent values give about eight
constexpr std::size_t kFewestBins = 1024;
constexpr std::size_t kMostBins = 65536;
constexpr std::size_t kSamplesPerBin = 32;  // on average, between the two limits

struct Entry {
  double value;
  double weight;
};

/// From entries in any order, equal ones joined, those without weight left out.
FcmEntries joined(std::vector<Entry> list) {
  std::stable_sort(list.begin(), list.end(), [](const Entry& a, const Entry& b) { return a.value < b.value; });
  FcmEntries out;
  out.exact = true;
  for (const Entry& entry : list) {
    if (entry.weight == 0) continue;
    if (out.values.empty() || entry.value != out.values.back()) {
      out.values.push_back(entry.value);
      out.weights.push_back(0);
    }
    out.weights.back() += entry.weight;
  }
  return out;
}

FcmEntries fromShort(const FcmData& data) {
  std::vector<Entry> list(data.values.size());
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = {data.scaled(data.values[i]), data.weight(i)};
  return joined(std::move(list));
}

bool looksQuantised(const FcmData& data) {
  std::size_t repeats = 0;
  for (std::size_t i = 1; i < data.some.size(); ++i) repeats += data.some[i] == data.some[i - 1] ? 1 : 0;
  return repeats >= kRepeatsOfQuantised;
}

/// A hash table of the distinct values, given up as soon as there are too many.
std::optional<FcmEntries> fromQuantised(const FcmData& data) {
  std::vector<Entry> table(std::size_t{1} << kSlotBits, {0, -1});  // weight -1: free
  std::size_t distinct = 0;
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    const double value = data.values[i] + 0.0;  // -0 becomes 0
    std::size_t slot = (std::bit_cast<std::uint64_t>(value) * 0x9E3779B97F4A7C15U) >> (64U - kSlotBits);
    while (table[slot].weight >= 0 && table[slot].value != value) slot = (slot + 1) & (table.size() - 1);
    if (table[slot].weight < 0) {
      if (++distinct > kMostDistinct) return std::nullopt;
      table[slot] = {value, 0};
    }
    table[slot].weight += data.weight(i);
  }
  std::erase_if(table, [](const Entry& entry) { return entry.weight < 0; });
  for (Entry& entry : table) entry.value = data.scaled(entry.value);
  return joined(std::move(table));
}

/// Which bin a scaled value x falls into, by the leading bits of |x| + linear: up to |x| = linear all bins are equally
/// wide, beyond it their width doubles with each power of two.
class Bins {
 public:
  Bins(double linear, std::size_t most) : linear_(linear), first_(std::bit_cast<std::int64_t>(linear)) {
    while (shift_ < 52 && 2 * (sideOf(1) + 1) > static_cast<std::int64_t>(most)) ++shift_;
    middle_ = sideOf(1) + 1;
  }

  std::size_t count() const { return static_cast<std::size_t>(2 * middle_); }
  std::size_t of(double x) const {
    const std::int64_t side = sideOf(x);
    return static_cast<std::size_t>(x < 0 ? middle_ - 1 - side : middle_ + side);
  }

 private:
  std::int64_t sideOf(double x) const {
    return (std::bit_cast<std::int64_t>(std::abs(x) + linear_) - first_) >> shift_;
  }

  double linear_;
  std::int64_t first_;
  int shift_ = 32;
  std::int64_t middle_ = 0;
};

/// A power of two of about the distance from 0 within which most samples lie.
double linearPart(const FcmData& data) {
  const std::size_t tenth = data.some.size() / 10;
  const double core = std::max(std::abs(data.some[tenth]), std::abs(data.some[data.some.size() - 1 - tenth]));
  return core > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(core) + 1, -1000, -1)) : 0x1p-10;
}

FcmEntries histogram(const FcmData& data) {
  struct Bin {
    double weight = 0;
    double sum = 0;
  };
  const std::size_t n = data.values.size();
  const Bins bins(linearPart(data), std::clamp(n / kSamplesPerBin, kFewestBins, kMostBins));
  std::vector<Bin> list(bins.count());
  const auto add = [&](std::size_t i) {
    const double weight = data.weight(i);
    if (weight == 0) return;  // may lie outside all bins
    const double x = data.scaled(data.values[i]);
    Bin& bin = list[bins.of(x)];
    bin.weight += weight;
    bin.sum += weight * x;
  };
  // Neighbors in time often share a bin; four places in turn need not wait for each other.
  const std::size_t quarter = n / 4;
  for (std::size_t i = 0; i < quarter; ++i) {
    for (std::size_t part = 0; part < 4; ++part) add(i + part * quarter);
  }
  for (std::size_t i = 4 * quarter; i < n; ++i) add(i);

  FcmEntries out;
  for (const Bin& bin : list) {
    if (bin.weight == 0) continue;
    const double mean = bin.sum / bin.weight;
    if (!out.values.empty() && mean <= out.values.back()) {  // rounding of the means of two neighbors
      out.weights.back() += bin.weight;
      continue;
    }
    out.values.push_back(mean);
    out.weights.push_back(bin.weight);
  }
  return out;
}

}  // namespace

FcmData FcmEntries::view() const { return scaledFcmData(values, weights); }

FcmEntries condense(const FcmData& data) {
  if (data.values.size() <= kShort) return fromShort(data);
  if (looksQuantised(data)) {
    if (auto entries = fromQuantised(data)) return std::move(*entries);
  }
  return histogram(data);
}

FcmEntries coarser(const FcmEntries& entries, std::size_t most) {
  if (entries.size() <= most) return entries;
  double total = 0;
  for (const double weight : entries.weights) total += weight;
  // Half of the entries may end because they are wide, the other half because they are heavy.
  const double half = static_cast<double>(most) / 2;
  const double width = (entries.values.back() - entries.values.front()) / half;
  const double heavy = total / half;

  FcmEntries out;
  for (std::size_t i = 0; i < entries.size();) {
    const double begin = entries.values[i];
    double sum = 0;
    double weight = 0;
    while (i < entries.size() && entries.values[i] - begin <= width && weight < heavy) {
      sum += entries.weights[i] * (entries.values[i] - begin);
      weight += entries.weights[i++];
    }
    out.values.push_back(begin + sum / weight);
    out.weights.push_back(weight);
  }
  return out;
}

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
  TACTUS_TRY(const auto heaviest, checkWeights(samples, weights));
  const Extent extent = extentOf(samples, weights);
  if (std::isnan(extent.check)) return refuseNotFinite(samples);

  FcmData data;
  data.values = samples;
  data.weights = weights;
  if (!weights.empty()) data.weight_scale = powerFor(heaviest);
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
