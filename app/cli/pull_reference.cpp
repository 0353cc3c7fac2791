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

/// `depth`, or with its unit `depth_mm`.
std::optional<std::size_t> columnOf(const CsvTable& table, const fuzzy::Variable& variable,
                                    const std::string& ending = {}) {
  const auto plain = table.find(variable.id + ending);
  return plain ? plain : table.find(variable.id + ending + "_" + base::columnKey(variable.unit));
}

base::Result<ReferenceColumns> referenceColumns(const CsvTable& table, const fuzzy::ForceModel& model) {
  ReferenceColumns out;
  std::vector<std::string> ids;
  bool any = false;
  for (const auto& input : model.inputs) {
    out.inputs.push_back(columnOf(table, input));
    any = any || out.inputs.back();
    ids.push_back(input.id);
  }
  const auto refuse = [&](std::string wanted) {
    return base::inFile({ErrorCode::kSchema, {}, "header", base::joined(table.columns(), ", "), std::move(wanted)},
                        table.file());
  };
  if (!any) return refuse("a column of an input: " + base::joined(ids, ", "));
  const std::string& name = model.output.id;
  out.low = columnOf(table, model.output, "_min");
  out.high = columnOf(table, model.output, "_max");
  const auto force = columnOf(table, model.output);
  if (force && (out.low || out.high)) return refuse("either " + name + ", or " + name + "_min and " + name + "_max");
  if (force) out.low = out.high = force;
  if (!out.low && !out.high) return refuse("a column " + name + ", or " + name + "_min, " + name + "_max or both");
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
  const auto isGap = [&](std::size_t row, const std::optional<std::size_t>& column) {
    return !column || base::trimmed(table->cell(row, *column)).empty();
  };
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    const bool no_low = isGap(row, columns->low);
    const bool no_high = isGap(row, columns->high);
    if (no_low && no_high) continue;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const auto& column = columns->inputs[i];
      const auto value = column ? inputValue(*table, row, *column, model.inputs[i]) : base::Result<double>(point[i]);
      if (!value) return tl::unexpected(value.error());
      out.curve.columns[i].push_back(*value);
    }
    const auto low = no_low ? base::Result<double>(-kFree) : table->number(row, *columns->low);
    if (!low) return tl::unexpected(low.error());
    const auto high = no_high ? base::Result<double>(kFree) : table->number(row, *columns->high);
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
