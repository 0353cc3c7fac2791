#include "app/cli/pull_reference.h"

#include <limits>
#include <optional>
#include <utility>

#include "core/base/tables/csv.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

using base::CsvTable;
using base::ErrorCode;

constexpr std::size_t kMostRows = 10'000;  // a search looks at each of them some ten thousand times

/// The column of each input that the table has, and of the forces.
struct ReferenceColumns {
  std::vector<std::optional<std::size_t>> inputs;
  std::optional<std::size_t> low, high;
};

base::Result<ReferenceColumns> referenceColumns(const CsvTable& table, const fuzzy::ForceModel& model) {
  ReferenceColumns out;
  std::vector<std::string> ids;
  bool any = false;
  for (const auto& input : model.inputs) {
    out.inputs.push_back(table.find(input.id));
    any = any || out.inputs.back();
    ids.push_back(input.id);
  }
  const auto refuse = [&](std::string wanted) {
    return base::inFile({ErrorCode::kSchema, {}, "header", base::joined(table.columns(), ", "), std::move(wanted)},
                        table.file());
  };
  if (!any) return refuse("a column of an input: " + base::joined(ids, ", "));
  out.low = table.find("force_min");
  out.high = table.find("force_max");
  const auto force = table.find("force");
  if (force && (out.low || out.high)) return refuse("either force, or force_min and force_max");
  if (force) out.low = out.high = force;
  if (!out.low && !out.high) return refuse("a column force, or force_min, force_max or both");
  return out;
}

/// The value of an input in a row.
base::Result<double> inputValue(const CsvTable& table, std::size_t row, std::size_t column,
                                const fuzzy::Variable& input) {
  const auto value = table.number(row, column);
  if (!value || (*value >= input.min && *value <= input.max)) return value;
  return table.refuse(row, column, ErrorCode::kValue,
                      "a value from " + base::formatNumber(input.min) + " to " + base::formatNumber(input.max));
}

}  // namespace

base::Result<ReadReference> readReference(const std::string& path, const fuzzy::ForceModel& model,
                                          std::span<const double> point) {
  const auto table = CsvTable::read(path);
  if (!table) return tl::unexpected(table.error());
  const auto columns = referenceColumns(*table, model);
  if (!columns) return tl::unexpected(columns.error());
  if (table->rowCount() == 0 || table->rowCount() > kMostRows) {
    return base::inFile(
        {ErrorCode::kLimit, {}, {}, std::to_string(table->rowCount()) + " rows", "1 to " + std::to_string(kMostRows)},
        path);
  }
  ReadReference out;
  if (auto note = table->note()) out.warnings.push_back(std::move(*note));
  out.curve.columns.resize(model.inputs.size());
  constexpr double kFree = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const auto& column = columns->inputs[i];
      const auto value = column ? inputValue(*table, row, *column, model.inputs[i]) : base::Result<double>(point[i]);
      if (!value) return tl::unexpected(value.error());
      out.curve.columns[i].push_back(*value);
    }
    const auto low = columns->low ? table->number(row, *columns->low) : base::Result<double>(-kFree);
    if (!low) return tl::unexpected(low.error());
    const auto high = columns->high ? table->number(row, *columns->high) : base::Result<double>(kFree);
    if (!high) return tl::unexpected(high.error());
    if (*low > *high) {
      return table->refuse(row, *columns->high, ErrorCode::kValue,
                           "at least force_min, which is " + base::formatNumber(*low));
    }
    out.curve.low_n.push_back(*low);
    out.curve.high_n.push_back(*high);
  }
  return out;
}

}  // namespace tactus::cli
