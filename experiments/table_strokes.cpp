#include "experiments/table_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "experiments/stroke_units.h"

namespace tactus::experiments {
namespace {

using Value = double study::SpeedSample::*;

struct Columns {
  std::string_view one, other;
  Value first, second;
};

constexpr std::array<Columns, 3> kPairs = {{
    {"depth_mm", "speed_mm_s", &study::SpeedSample::depth_mm, &study::SpeedSample::speed_mm_s},
    {"time_s", "depth_mm", &study::SpeedSample::time_s, &study::SpeedSample::depth_mm},
    {"time_s", "speed_mm_s", &study::SpeedSample::time_s, &study::SpeedSample::speed_mm_s},
}};

bool makesSense(const TableStroke& stroke) {
  return rowOrder(stroke) == RowOrder::kRising && unitFit(stroke).verdict == UnitFit::Verdict::kFits;
}

bool mostMakeSense(std::size_t good, std::size_t of) { return good >= 2 && 4 * good >= 3 * of; }

/// How many of the strokes make sense once `columns` are exchanged.
std::size_t goodWith(const Columns& columns, std::span<const TableStroke* const> strokes) {
  std::size_t good = 0;
  for (const auto* stroke : strokes) {
    std::vector<study::SpeedSample> rows;
    rows.reserve(stroke->rows.size());
    for (const auto* row : stroke->rows) {
      rows.push_back(*row);
      std::swap(rows.back().*columns.first, rows.back().*columns.second);
    }
    const auto exchanged = tableStrokes(rows);
    if (makesSense(exchanged.front())) ++good;
  }
  return good;
}

}  // namespace

std::optional<study::DataFinding> swappedColumns(std::span<const TableStroke* const> strokes) {
  const auto good =
      std::count_if(strokes.begin(), strokes.end(), [](const auto* stroke) { return makesSense(*stroke); });
  if (2 * static_cast<std::size_t>(good) >= strokes.size()) return std::nullopt;
  for (const auto& columns : kPairs) {
    if (!mostMakeSense(goodWith(columns, strokes), strokes.size())) continue;
    const std::string who(strokes.front()->participant);
    return study::refusal(study::DataFinding::Kind::kColumnsSwapped, who,
                          {study::kSpeedsTable, strokes.front()->line(), columns.one},
                          "in " + strokesText(strokes, strokes.size()) + " of " + who + " the columns " +
                              std::string(columns.one) + " and " + std::string(columns.other) + " look swapped",
                          "exchange them there, so that s, mm and mm/s fit each other");
  }
  return std::nullopt;
}

namespace {

using study::DataFinding;
using Kind = DataFinding::Kind;
using Severity = DataFinding::Severity;

constexpr double kOtherDepthMm = 2;
constexpr std::size_t kMostRestarts = 4;

/// Times begin again: they fall a few times, each time to the first tenth of the stroke.
bool restarts(const TableStroke& stroke, std::size_t falls) {
  if (falls > kMostRestarts || falls * 4 > stroke.rows.size()) return false;
  const double first_s = stroke.in_time.front()->time_s;
  const double tenth_s = 0.1 * (stroke.in_time.back()->time_s - first_s);
  for (std::size_t i = 1; i < stroke.rows.size(); ++i) {
    const bool falls_here = stroke.rows[i]->time_s < stroke.rows[i - 1]->time_s;
    if (falls_here && stroke.rows[i]->time_s > first_s + tenth_s) return false;
  }
  return true;
}

/// Rows in time order that have the time of the row before and another depth.
std::size_t clashes(const TableStroke& stroke) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < stroke.in_time.size(); ++i) {
    const auto& before = *stroke.in_time[i - 1];
    const auto& row = *stroke.in_time[i];
    if (row.time_s == before.time_s && std::abs(row.depth_mm - before.depth_mm) >= kOtherDepthMm) ++count;
  }
  return count;
}

struct Disorder {
  RowOrder order;
  Kind kind;
  Severity severity;
  std::string_view column, says;
};

constexpr std::array<Disorder, 5> kDisorders = {{
    {RowOrder::kNoTimes, Kind::kNoTimes, Severity::kNote, "time_s",
     "all rows have one time, so whether the speeds fit the depths cannot be seen"},
    {RowOrder::kBackwards, Kind::kRowsBackwards, Severity::kWarning, "time_s",
     "the rows stand backwards: times fall from the first row to the last"},
    {RowOrder::kTwice, Kind::kRowsTwice, Severity::kWarning, "time_s",
     "rows stand twice, with the same time, depth and speed, and count twice"},
    {RowOrder::kRestarts, Kind::kStrokeTwice, Severity::kWarning, "stroke",
     "the time begins again: two strokes under one number, which count as one?"},
    {RowOrder::kUnsorted, Kind::kRowsUnsorted, Severity::kWarning, "time_s", "the rows are not in the order of time"},
}};

}  // namespace

RowOrder rowOrder(const TableStroke& stroke) {
  const auto& rows = stroke.rows;
  std::size_t falls = 0;
  std::size_t same = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i]->time_s < rows[i - 1]->time_s) ++falls;
    if (rows[i]->time_s == rows[i - 1]->time_s) ++same;
  }
  if (rows.size() < 3) return RowOrder::kRising;
  if (same + 1 == rows.size()) return RowOrder::kNoTimes;
  if (5 * (rows.size() - stroke.in_time.size()) >= rows.size()) return RowOrder::kTwice;
  if (falls == 0) return 5 * clashes(stroke) >= rows.size() ? RowOrder::kRestarts : RowOrder::kRising;
  if (falls + same + 1 == rows.size()) return RowOrder::kBackwards;
  return restarts(stroke, falls) ? RowOrder::kRestarts : RowOrder::kUnsorted;
}

std::vector<DataFinding> rowFindings(std::span<const TableStroke* const> strokes) {
  std::vector<RowOrder> orders;
  for (const auto* stroke : strokes) orders.push_back(rowOrder(*stroke));
  std::vector<DataFinding> out;
  for (const auto& disorder : kDisorders) {
    std::vector<const TableStroke*> concerned;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      if (orders[i] == disorder.order) concerned.push_back(strokes[i]);
    }
    if (concerned.empty()) continue;
    const std::string who(concerned.front()->participant);
    const std::string says(disorder.says);
    out.push_back(
        {disorder.kind,
         disorder.severity,
         who,
         {study::kSpeedsTable, concerned.front()->line(), disorder.column},
         "In " + strokesText(concerned, strokes.size()) + " of " + who + ' ' + says + (says.ends_with('?') ? "" : "."),
         {},
         {}});
  }
  return out;
}

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
