#include "experiments/stroke_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace tactus::experiments {
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

}  // namespace tactus::experiments
