#include "experiments/stroke_likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace tactus::experiments {
namespace {

constexpr std::size_t kFewestAlike = 8;
constexpr std::size_t kFewestValues = 5;
constexpr double kRounding = 2e-3;  // of the spread: what rounding a shifted column leaves
constexpr double kNoise = 0.03;     // of the spread
constexpr std::size_t kFewestOfPart = 20;
constexpr double kSameTimeS = 6e-4;  // tables round to a millisecond
constexpr double kSameDepthMm = 0.02;
constexpr double kSameSpeedMmS = 1e-6;
constexpr double kLongestLagS = 0.3;
constexpr double kCompared = 0.8;  // of the longer stroke: a fast one has a dozen rows at 100 Hz
constexpr double kMuch = 0.25;
constexpr double kPartMuch = 0.1;
constexpr std::size_t kPoints = 64;
constexpr int kRowsAround = 4;     // how far noise moves the place where a speed is first reached
constexpr double kHopeless = 0.2;  // of the spread: more than noise and a wrong row give
constexpr int kRefinements = 3;    // of the lag

const study::SpeedSample& rowOf(const StrokeNumbers& numbers, std::size_t i) { return *numbers.stroke->rows[i]; }

/// Whether `part`, from its first row on, is found in `whole` from the row `begin` on.
bool continues(const StrokeNumbers& part, const StrokeNumbers& whole, std::size_t begin) {
  const double time_s = part.time_s[0] - whole.time_s[begin];
  const double depth_mm = rowOf(part, 0).depth_mm - rowOf(whole, begin).depth_mm;
  std::size_t place = begin;
  for (std::size_t i = 0; i < part.mm_s.size(); ++i, ++place) {
    while (place < whole.mm_s.size() && whole.time_s[place] + time_s < part.time_s[i] - kSameTimeS) ++place;
    if (place == whole.mm_s.size()) return false;
    const bool same = std::abs(whole.time_s[place] + time_s - part.time_s[i]) <= kSameTimeS &&
                      std::abs(whole.mm_s[place] - part.mm_s[i]) <= kSameSpeedMmS &&
                      std::abs(rowOf(whole, place).depth_mm + depth_mm - rowOf(part, i).depth_mm) <= kSameDepthMm;
    if (!same) return false;
  }
  return true;
}

/// Speed at `time_s`, between the rows around it.
double speedAt(const StrokeNumbers& numbers, double time_s) {
  const auto after = std::upper_bound(numbers.time_s.begin(), numbers.time_s.end(), time_s);
  const auto i = static_cast<std::size_t>(after - numbers.time_s.begin());
  if (i == 0) return numbers.mm_s.front();
  if (i == numbers.time_s.size()) return numbers.mm_s.back();
  const double share = (time_s - numbers.time_s[i - 1]) / (numbers.time_s[i] - numbers.time_s[i - 1]);
  return numbers.mm_s[i - 1] + share * (numbers.mm_s[i] - numbers.mm_s[i - 1]);
}

/// When the speed first reaches half of the largest.
double halfwayS(const StrokeNumbers& numbers) {
  const auto at = std::find_if(numbers.mm_s.begin(), numbers.mm_s.end(),
                               [&numbers](double speed) { return speed >= 0.5 * numbers.largest; });
  return numbers.time_s[static_cast<std::size_t>(at - numbers.mm_s.begin())];
}

double lengthS(const StrokeNumbers& numbers) { return numbers.time_s.back() - numbers.time_s.front(); }

/// Two strokes side by side, `b` moved by `lag_s`: what is left of the difference of their speeds, and the lag that
/// makes it smaller.
struct Compared {
  double noise = 0;  ///< root mean square without the mean
  double better_lag_s = 0;
};

Compared compare(const StrokeNumbers& a, const StrokeNumbers& b, double lag_s, double from_s, double to_s) {
  std::array<double, kPoints> moved{};  // speeds of b
  std::array<double, kPoints> rest{};
  std::array<double, kPoints> slope{};
  double mean_rest = 0;
  double mean_slope = 0;
  const double step_s = (to_s - from_s) / static_cast<double>(kPoints - 1);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double time_s = from_s + step_s * static_cast<double>(i);
    moved[i] = speedAt(b, time_s + lag_s);
    rest[i] = moved[i] - speedAt(a, time_s);
    mean_rest += rest[i] / kPoints;
  }
  for (std::size_t i = 1; i + 1 < kPoints; ++i) {
    slope[i] = (moved[i + 1] - moved[i - 1]) / (2 * step_s);
    mean_slope += slope[i] / (kPoints - 2);
  }
  double squares = 0;
  double product = 0;
  double slopes = 0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    squares += (rest[i] - mean_rest) * (rest[i] - mean_rest);
    if (i == 0 || i + 1 == kPoints) continue;
    product += (rest[i] - mean_rest) * (slope[i] - mean_slope);
    slopes += (slope[i] - mean_slope) * (slope[i] - mean_slope);
  }
  return {std::sqrt(squares / kPoints), slopes > 0 ? lag_s - product / slopes : lag_s};
}

/// Whether the speeds are the same with a lag near `lag_s`.
bool isSameWithLag(const StrokeNumbers& a, const StrokeNumbers& b, double lag_s, double longer_s) {
  for (int i = 0; i < kRefinements; ++i) {
    const double from_s = std::max(a.time_s.front(), b.time_s.front() - lag_s);
    const double to_s = std::min(a.time_s.back(), b.time_s.back() - lag_s);
    if (to_s - from_s < kCompared * longer_s) return false;
    const auto compared = compare(a, b, lag_s, from_s, to_s);
    if (compared.noise <= kNoise * a.spread) return true;
    if (compared.noise > kHopeless * a.spread) return false;
    lag_s = compared.better_lag_s;
  }
  return false;
}

}  // namespace

std::optional<StrokeNumbers> numbersOf(const TableStroke& stroke) {
  if (stroke.rows.size() < kFewestAlike) return std::nullopt;
  StrokeNumbers out;
  out.stroke = &stroke;
  out.in_time = true;
  std::set<double> values;
  double sum = 0;
  for (const auto* row : stroke.rows) {
    out.in_time = out.in_time && (out.time_s.empty() || row->time_s > out.time_s.back());
    out.mm_s.push_back(row->speed_mm_s);
    out.time_s.push_back(row->time_s);
    if (values.size() < kFewestValues) values.insert(row->speed_mm_s);
    sum += row->speed_mm_s;
    out.largest = std::max(out.largest, row->speed_mm_s);
  }
  if (values.size() < kFewestValues) return std::nullopt;
  const auto count = static_cast<double>(out.mm_s.size());
  out.mean = sum / count;
  double squares = 0;
  for (const double speed : out.mm_s) squares += (speed - out.mean) * (speed - out.mean);
  out.spread = std::sqrt(squares / count);
  return out;
}

Likeness rowLikeness(const StrokeNumbers& a, const StrokeNumbers& b) {
  if (a.mm_s.size() != b.mm_s.size()) return Likeness::kNone;
  if (a.mm_s == b.mm_s) return Likeness::kSame;
  const double shift = b.mean - a.mean;
  double squares = 0;
  double largest = 0;
  const double most = kNoise * kNoise * a.spread * a.spread * static_cast<double>(a.mm_s.size());
  for (std::size_t i = 0; i < a.mm_s.size(); ++i) {
    const double rest = b.mm_s[i] - a.mm_s[i] - shift;
    squares += rest * rest;
    largest = std::max(largest, std::abs(rest));
    if (squares > most) return Likeness::kNone;
  }
  return largest <= kRounding * a.spread ? Likeness::kShifted : Likeness::kNoisy;
}

bool isPart(const StrokeNumbers& a, const StrokeNumbers& b) {
  const auto& part = a.mm_s.size() <= b.mm_s.size() ? a : b;
  const auto& whole = a.mm_s.size() <= b.mm_s.size() ? b : a;
  const std::size_t rows = part.mm_s.size();
  if (!a.in_time || !b.in_time || rows < kFewestOfPart || 2 * rows < whole.mm_s.size()) return false;
  // Rows left out change neither the largest speed nor the spread by much; most pairs of strokes end here.
  if (part.largest > whole.largest || part.largest < (1 - kPartMuch) * whole.largest) return false;
  if (std::abs(part.spread - whole.spread) > kPartMuch * whole.spread) return false;
  for (std::size_t begin = 0; begin + rows <= whole.mm_s.size(); ++begin) {
    if (std::abs(whole.mm_s[begin] - part.mm_s[0]) <= kSameSpeedMmS && continues(part, whole, begin)) return true;
  }
  return false;
}

bool isSameMotion(const StrokeNumbers& a, const StrokeNumbers& b) {
  if (!a.in_time || !b.in_time) return false;
  const double longer_s = std::max(lengthS(a), lengthS(b));
  if (std::abs(lengthS(a) - lengthS(b)) > (1 - kCompared) * longer_s) return false;
  // Quick, and generous: most pairs of strokes end here.
  if (std::abs(a.largest - b.largest) > kMuch * a.largest || std::abs(a.spread - b.spread) > kMuch * a.spread)
    return false;
  // A copy mostly keeps the rows of its original, and noise in them is only the same where they meet.
  const double start_lag_s = b.time_s.front() - a.time_s.front();
  const double step_s = lengthS(a) / static_cast<double>(a.time_s.size() - 1);
  const double rows = std::round((halfwayS(b) - halfwayS(a) - start_lag_s) / step_s);
  for (int row = -kRowsAround; row <= kRowsAround; ++row) {
    const double lag_s = start_lag_s + (rows + row) * step_s;
    if (std::abs(lag_s - start_lag_s) <= kLongestLagS && isSameWithLag(a, b, lag_s, longer_s)) return true;
  }
  return false;
}

}  // namespace tactus::experiments
