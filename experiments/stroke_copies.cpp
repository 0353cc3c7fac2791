#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "experiments/table_findings.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {
namespace {

// How alike two strokes of a table are: the same rows, some of them, or the same motion a little later.

/// A stroke as numbers to compare. It views the stroke.
struct StrokeNumbers {
  const TableStroke* stroke = nullptr;
  std::vector<double> mm_s;    ///< speeds, row after row
  std::vector<double> time_s;  ///< of the rows
  double mean = 0;             ///< of the speeds
  double spread = 0;           ///< standard deviation of the speeds
  double largest = 0;          ///< speed
  bool in_time = false;        ///< times rise from row to row
};

enum class Likeness {
  kNone,
  kNoisy,    ///< speeds that differ by noise of at most 3 % of their spread, and by a constant
  kShifted,  ///< by a constant alone
  kPart,     ///< rows of the one are missing in the other
  kSame,     ///< the same speeds, row for row
};

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

/// Nothing for a stroke that says too little: fewer than 8 rows, or than 5 different speeds.
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

/// Row by row, for as many rows; otherwise kNone.
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

/// Whether the stroke with fewer rows (20 or more, half of the other's or more) is the other one with rows left out:
/// each of its rows has its time, depth and speed, but for a constant in times and in depths.
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

/// Whether the speeds are the same over time but for a lag of at most 0.3 s, a constant, and noise of at most 3 % of
/// their spread, while four fifths of the longer stroke are compared.
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

using study::DataFinding;

constexpr std::size_t kFewestShifted = 2;
constexpr std::size_t kFewestNoisy = 6;
constexpr double kNearMean = 0.05;  // of a mean speed: rows left out change it by less

using StrokeGroup = std::vector<StrokeNumbers>;

/// Two strokes that are the same, the original first.
struct Pair {
  const TableStroke* from;
  const TableStroke* copy;
  bool in_part = false;  ///< rows are missing in one of them
};

DataFinding copied(const Pair& first, const std::string& how) {
  const auto& row = *first.copy->rows.front();
  return {DataFinding::Kind::kStrokeCopied,
          DataFinding::Severity::kWarning,
          row.participant,
          {study::kSpeedsTable, row.line, "speed_mm_s"},
          how,
          {},
          {}};
}

std::string ofWhom(const TableStroke& stroke) { return stroke.name() + " of " + std::string(stroke.participant); }

using Pairs = std::map<std::string_view, std::vector<Pair>>;

/// Strokes with the same speeds row for row, of any participant, at any place. The others go into `rest`.
Pairs samePairs(const std::vector<StrokeGroup>& groups, std::vector<const StrokeNumbers*>& rest) {
  std::unordered_map<std::size_t, std::vector<const StrokeNumbers*>> by_hash;
  Pairs out;
  for (const auto& group : groups) {
    for (const auto& numbers : group) {
      std::size_t hash = numbers.mm_s.size();
      for (const double speed : numbers.mm_s) hash = hash * 1099511628211ULL ^ std::hash<double>{}(speed);
      auto& alike = by_hash[hash];
      const auto original = std::find_if(alike.begin(), alike.end(), [&numbers](const StrokeNumbers* other) {
        return rowLikeness(*other, numbers) == Likeness::kSame;
      });
      if (original != alike.end()) {
        out[numbers.stroke->participant].push_back({(*original)->stroke, numbers.stroke});
      } else {
        alike.push_back(&numbers);
        rest.push_back(&numbers);
      }
    }
  }
  return out;
}

/// Adds strokes that are another one with rows left out; `strokes` in the order of the table.
void addParts(const std::vector<const StrokeNumbers*>& strokes, Pairs& out) {
  std::vector<std::size_t> by_mean(strokes.size());
  for (std::size_t i = 0; i < by_mean.size(); ++i) by_mean[i] = i;
  std::sort(by_mean.begin(), by_mean.end(),
            [&strokes](std::size_t a, std::size_t b) { return strokes[a]->mean < strokes[b]->mean; });
  std::vector<bool> is_copy(strokes.size());
  for (std::size_t i = 0; i < by_mean.size(); ++i) {
    const double most = (1 + kNearMean) * strokes[by_mean[i]]->mean;
    for (std::size_t k = i + 1; k < by_mean.size() && strokes[by_mean[k]]->mean <= most; ++k) {
      const auto [first, second] = std::minmax(by_mean[i], by_mean[k]);
      if (is_copy[second] || !isPart(*strokes[first], *strokes[second])) continue;
      is_copy[second] = true;
      out[strokes[second]->stroke->participant].push_back({strokes[first]->stroke, strokes[second]->stroke, true});
    }
  }
}

/// How alike two strokes of two participants are.
Likeness likeness(const StrokeNumbers& a, const StrokeNumbers& b) {
  const auto rows = rowLikeness(a, b);
  return rows == Likeness::kNone && isSameMotion(a, b) ? Likeness::kNoisy : rows;
}

/// The first strokes of two participants whose strokes are alike wherever both have one of a level and number.
std::optional<Pair> likeAll(const StrokeGroup& original, const StrokeGroup& copy) {
  std::size_t both = 0;
  Likeness least = Likeness::kSame;
  for (const auto& numbers : copy) {
    const auto other = std::find_if(original.begin(), original.end(), [&numbers](const StrokeNumbers& one) {
      return one.stroke->number == numbers.stroke->number && one.stroke->level == numbers.stroke->level;
    });
    if (other == original.end()) continue;
    ++both;
    least = std::min(least, likeness(*other, numbers));
    if (least == Likeness::kNone) return std::nullopt;
  }
  const std::size_t fewest = least == Likeness::kNoisy ? kFewestNoisy : kFewestShifted;
  if (both < fewest) return std::nullopt;
  return Pair{original.front().stroke, copy.front().stroke};
}

}  // namespace

std::vector<DataFinding> strokeCopyFindings(std::span<const TableStroke> strokes) {
  std::vector<StrokeGroup> groups;
  for (const auto& of_one : byParticipant(strokes)) {
    StrokeGroup group;
    for (const auto* stroke : of_one) {
      if (auto numbers = numbersOf(*stroke)) group.push_back(std::move(*numbers));
    }
    if (!group.empty()) groups.push_back(std::move(group));
  }
  std::vector<const StrokeNumbers*> rest;
  auto same = samePairs(groups, rest);
  addParts(rest, same);
  std::vector<DataFinding> out;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string who(groups[i].front().stroke->participant);
    if (const auto found = same.find(who); found != same.end()) {
      const auto& pairs = found->second;
      std::string sentence = "The speeds of " + ofWhom(*pairs.front().copy) + " are those of " +
                             ofWhom(*pairs.front().from) +
                             (pairs.front().in_part ? ", with rows left out: copied?" : ", row for row: copied?");
      if (pairs.size() > 1) sentence += " There are " + std::to_string(pairs.size()) + " such strokes.";
      out.push_back(copied(pairs.front(), sentence));
      continue;
    }
    for (std::size_t k = 0; k < i; ++k) {
      const auto first = likeAll(groups[k], groups[i]);
      if (!first) continue;
      out.push_back(copied(*first, "All strokes of " + who + " have the speeds of those of " +
                                       std::string(first->from->participant) +
                                       ", but for a constant, a lag or a little noise: copied?"));
      break;
    }
  }
  return out;
}

}  // namespace tactus::experiments
