#include "experiments/table_strokes.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

namespace tactus::experiments {
namespace {

using Rows = std::vector<const study::SpeedSample*>;

bool sameRow(const study::SpeedSample* a, const study::SpeedSample* b) {
  return a->time_s == b->time_s && a->depth_mm == b->depth_mm && a->speed_mm_s == b->speed_mm_s;
}

Rows byTime(Rows rows) {
  const auto before = [](const study::SpeedSample* a, const study::SpeedSample* b) { return a->time_s < b->time_s; };
  if (!std::is_sorted(rows.begin(), rows.end(), before)) std::stable_sort(rows.begin(), rows.end(), before);
  rows.erase(std::unique(rows.begin(), rows.end(), sameRow), rows.end());
  return rows;
}

}  // namespace

std::vector<TableStroke> tableStrokes(std::span<const study::SpeedSample> samples) {
  std::vector<TableStroke> strokes;
  std::map<std::tuple<std::string_view, std::string_view, int>, std::size_t> places;
  std::size_t current = 0;
  for (const auto& sample : samples) {
    const auto is_of = [&sample](const TableStroke& stroke) {
      return stroke.number == sample.stroke && stroke.level == sample.level && stroke.participant == sample.participant;
    };
    // The rows of a stroke mostly stand together.
    if (strokes.empty() || !is_of(strokes[current])) {
      const auto [place, is_new] =
          places.try_emplace({sample.participant, sample.level, sample.stroke}, strokes.size());
      if (is_new) strokes.push_back({sample.participant, sample.level, sample.stroke, {}, {}});
      current = place->second;
    }
    strokes[current].rows.push_back(&sample);
  }
  for (auto& stroke : strokes) stroke.in_time = byTime(stroke.rows);
  return strokes;
}

std::vector<std::vector<const TableStroke*>> byParticipant(std::span<const TableStroke> strokes) {
  std::vector<std::vector<const TableStroke*>> groups;
  std::unordered_map<std::string_view, std::size_t> places;
  for (const auto& stroke : strokes) {
    const auto [place, is_new] = places.try_emplace(stroke.participant, groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(&stroke);
  }
  return groups;
}

std::string strokesText(std::span<const TableStroke* const> strokes, std::size_t of) {
  if (strokes.size() == of && of > 1) return "all " + std::to_string(of) + " strokes";
  if (strokes.size() == 1) return strokes.front()->name();
  const bool one_level = std::all_of(strokes.begin(), strokes.end(), [&strokes](const TableStroke* stroke) {
    return stroke->level == strokes.front()->level;
  });
  const std::string count = std::to_string(strokes.size()) + " strokes";
  if (one_level) return count + " at " + std::string(strokes.front()->level);
  return count + ", the first " + strokes.front()->name();
}

}  // namespace tactus::experiments
