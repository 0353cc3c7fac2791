#include "experiments/stroke_columns.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/stroke_rows.h"
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

}  // namespace tactus::experiments
