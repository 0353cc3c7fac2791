#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"

namespace tactus::cli {
namespace {

using base::CsvTable;
using base::Error;
using base::ErrorCode;
using base::Result;

/// The column of each input, in the order of the inputs.
Result<std::vector<std::size_t>> inputColumns(const fuzzy::ForceModel& model, const CsvTable& points) {
  std::vector<std::size_t> columns;
  for (const auto& input : model.inputs) {
    TACTUS_TRY(const auto column, points.require(input.id));
    columns.push_back(column);
  }
  for (const char* name : {"force", "fired"}) {
    if (!points.find(name)) continue;
    return tl::unexpected(Error{ErrorCode::kSchema, points.file(), "header", "a column " + base::quoted(name),
                                "points without it, because the result gets it"});
  }
  return columns;
}

}  // namespace

Result<Output> eval(const EvalOptions& options) {
  if (auto ok = requireOutput(options.out, {options.model, options.points}); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto opened, openedModel(options.model));
  TACTUS_TRY(const auto expert, expertOption(opened.model, options.model, options.expert));
  TACTUS_TRY(const auto points, CsvTable::read(options.points));
  TACTUS_TRY(const auto columns, inputColumns(opened.model, points));

  auto warnings = opened.warnings;
  if (auto note = points.note()) warnings.push_back(std::move(*note));
  auto header = points.columns();
  header.insert(header.end(), {"force", "fired"});
  base::CsvWriter csv(header);
  std::vector<double> point(columns.size());
  for (std::size_t row = 0; row < points.rowCount(); ++row) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      TACTUS_TRY(const auto value, points.number(row, columns[i]));
      point[i] = value;
    }
    const fuzzy::Evaluation force = options.sampling
                                        ? analysis::evaluateSampled(opened.compiled, point, *options.sampling, expert)
                                    : expert ? opened.compiled.evaluateExpert(*expert, point)
                                             : opened.compiled.evaluate(point);
    for (std::size_t column = 0; column < points.columns().size(); ++column) csv.cell(points.cell(row, column));
    csv.cell(force.force_n).cell(force.fired ? 1 : 0).endRow();
  }
  return written(options.out.empty() ? "-" : options.out, csv.text(), {"", std::move(warnings)}, false);
}

}  // namespace tactus::cli
