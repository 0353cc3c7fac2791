#include "experiments/stroke_copies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace tactus::experiments {
namespace {

using study::DataFinding;

constexpr std::size_t kFewestRows = 8;
constexpr std::size_t kFewestValues = 5;
constexpr double kRounding = 2e-3;  // of the spread: what rounding a shifted column leaves
constexpr double kNoise = 0.03;     // of the spread
constexpr std::size_t kFewestShifted = 2;
constexpr std::size_t kFewestNoisy = 6;

/// A stroke as numbers to compare.
struct Speeds {
  const TableStroke* stroke;
  std::vector<double> mm_s;
  double spread = 0;  // standard deviation
};

std::optional<Speeds> speedsOf(const TableStroke& stroke) {
  if (stroke.rows.size() < kFewestRows) return std::nullopt;
  Speeds out{&stroke, {}, 0};
  std::set<double> values;
  double sum = 0;
  for (const auto* row : stroke.rows) {
    out.mm_s.push_back(row->speed_mm_s);
    if (values.size() < kFewestValues) values.insert(row->speed_mm_s);
    sum += row->speed_mm_s;
  }
  if (values.size() < kFewestValues) return std::nullopt;
  const auto count = static_cast<double>(out.mm_s.size());
  double squares = 0;
  for (const double speed : out.mm_s) squares += (speed - sum / count) * (speed - sum / count);
  out.spread = std::sqrt(squares / count);
  return out;
}

enum class Likeness { kNone, kNoisy, kShifted, kSame };

/// How alike two strokes of as many rows are.
Likeness likeness(const Speeds& a, const Speeds& b) {
  if (a.mm_s.size() != b.mm_s.size()) return Likeness::kNone;
  if (a.mm_s == b.mm_s) return Likeness::kSame;
  double shift = 0;
  for (std::size_t i = 0; i < a.mm_s.size(); ++i) shift += b.mm_s[i] - a.mm_s[i];
  shift /= static_cast<double>(a.mm_s.size());
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

using Group = std::vector<Speeds>;
using Place = std::pair<std::string_view, int>;

/// Two strokes that are the same, the original first.
struct Pair {
  const TableStroke* from;
  const TableStroke* copy;
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

/// Strokes with the same speeds row for row, whoever's and wherever they are.
std::map<std::string_view, std::vector<Pair>> samePairs(const std::vector<Group>& groups) {
  std::unordered_map<std::size_t, std::vector<const Speeds*>> by_hash;
  std::map<std::string_view, std::vector<Pair>> out;
  for (const auto& group : groups) {
    for (const auto& speeds : group) {
      std::size_t hash = speeds.mm_s.size();
      for (const double speed : speeds.mm_s) hash = hash * 1099511628211ULL ^ std::hash<double>{}(speed);
      auto& alike = by_hash[hash];
      const auto original = std::find_if(alike.begin(), alike.end(), [&speeds](const Speeds* other) {
        return likeness(*other, speeds) == Likeness::kSame;
      });
      if (original != alike.end()) {
        out[speeds.stroke->participant].push_back({(*original)->stroke, speeds.stroke});
      } else {
        alike.push_back(&speeds);
      }
    }
  }
  return out;
}

/// How alike the strokes of two participants are that have one level and number, if all of them are.
std::optional<Pair> likeAll(const Group& original, const Group& copy) {
  std::map<Place, const Speeds*> places;
  for (const auto& speeds : original) places[{speeds.stroke->level, speeds.stroke->number}] = &speeds;
  std::size_t both = 0;
  Likeness least = Likeness::kSame;
  for (const auto& speeds : copy) {
    const auto place = places.find({speeds.stroke->level, speeds.stroke->number});
    if (place == places.end()) continue;
    ++both;
    least = std::min(least, likeness(*place->second, speeds));
    if (least == Likeness::kNone) return std::nullopt;
  }
  const std::size_t fewest = least == Likeness::kNoisy ? kFewestNoisy : kFewestShifted;
  if (both < fewest) return std::nullopt;
  return Pair{original.front().stroke, copy.front().stroke};
}

}  // namespace

std::vector<DataFinding> strokeCopyFindings(std::span<const TableStroke> strokes) {
  std::vector<Group> groups;
  for (const auto& of_one : byParticipant(strokes)) {
    Group group;
    for (const auto* stroke : of_one) {
      if (auto speeds = speedsOf(*stroke)) group.push_back(std::move(*speeds));
    }
    if (!group.empty()) groups.push_back(std::move(group));
  }
  const auto same = samePairs(groups);
  std::vector<DataFinding> out;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string who(groups[i].front().stroke->participant);
    if (const auto found = same.find(who); found != same.end()) {
      const auto& pairs = found->second;
      std::string sentence = "The speeds of " + ofWhom(*pairs.front().copy) + " are those of " +
                             ofWhom(*pairs.front().from) + ", row for row: copied?";
      if (pairs.size() > 1) sentence += " There are " + std::to_string(pairs.size()) + " such strokes.";
      out.push_back(copied(pairs.front(), sentence));
      continue;
    }
    for (std::size_t k = 0; k < i; ++k) {
      const auto first = likeAll(groups[k], groups[i]);
      if (!first) continue;
      out.push_back(copied(*first, "All strokes of " + who + " have the speeds of those of " +
                                       std::string(first->from->participant) +
                                       ", but for a constant or a little noise: copied?"));
      break;
    }
  }
  return out;
}

}  // namespace tactus::experiments
