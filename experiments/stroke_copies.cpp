#include "experiments/stroke_copies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "experiments/stroke_likeness.h"

namespace tactus::experiments {
namespace {

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
