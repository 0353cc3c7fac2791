// What a program is asked: the points of a model's checks, and scripted insertions.
#include <utility>

#include "app/certify/certificate.h"
#include "core/analysis/check_points.h"
#include "core/base/tables/csv.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/bundle_check.h"

namespace tactus::certify {
namespace {

using base::ErrorCode;

base::Result<std::vector<Point>> pointsAt(const fuzzy::ForceModel& model, std::vector<std::vector<double>> points) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  std::vector<Point> out;
  for (auto& inputs : points) {
    const fuzzy::Evaluation force = compiled.evaluate(inputs);
    out.push_back({std::move(inputs), force.force_n, force.fired});
  }
  return out;
}

/// The columns `names` of a table, row by row.
base::Result<std::vector<std::vector<double>>> rowsOf(const base::CsvTable& table,
                                                      const std::vector<std::string>& names) {
  std::vector<std::size_t> columns;
  for (const std::string& name : names) {
    TACTUS_TRY(const auto column, table.require(name));
    columns.push_back(column);
  }
  std::vector<std::vector<double>> rows(table.rowCount());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const std::size_t column : columns) {
      TACTUS_TRY(const auto value, table.number(r, column));
      rows[r].push_back(value);
    }
  }
  return rows;
}

base::Result<bundle::FeltTraces> readInsertions(const std::string& path, const fuzzy::ForceModel& model) {
  TACTUS_TRY(const auto inputs, render::tubeInputs(model));
  TACTUS_TRY(const auto table, base::CsvTable::read(path));
  TACTUS_TRY(const auto name, table.require("trace"));
  bundle::FeltTraces out;
  for (const std::size_t input : inputs.conditions) out.conditions.push_back(model.inputs[input].id);
  std::vector<std::string> names = {"position_mm", "held", "dt_s", "force_n", "depth_mm"};
  names.insert(names.end(), out.conditions.begin(), out.conditions.end());
  TACTUS_TRY(const auto rows, rowsOf(table, names));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r == 0 || table.cell(r, name) != table.cell(r - 1, name)) {
      out.traces.push_back({std::string(table.cell(r, name)), {}});
      out.felt.emplace_back();
    }
    const auto& row = rows[r];
    out.traces.back().steps.push_back({row[0], row[1] != 0, row[2], {row.begin() + 5, row.end()}});
    out.felt.back().push_back({row[3], row[4], 0, 0});
  }
  return out;
}

bundle::FeltTraces insertionsOf(const fuzzy::ForceModel& model) {
  return bundle::feltTraces(model).value_or(bundle::FeltTraces{});
}

}  // namespace

base::Result<Questions> questionsOf(fuzzy::ForceModel model, std::string sha256) {
  TACTUS_TRY(auto points, pointsAt(model, analysis::checkPoints(model)));
  auto insertions = insertionsOf(model);
  return Questions{std::move(model), std::move(sha256), std::move(points), std::move(insertions)};
}

base::Result<Questions> questionsOfBundle(const std::string& folder) {
  TACTUS_TRY(auto bundle, model_io::checkBundle(folder));
  std::string checks;
  std::string traces;
  for (const model_io::FileCheck& check : bundle.files) {
    if (!check.ok) {
      return base::fail(ErrorCode::kMismatch, folder, "a bundle that is not what it promises (" + check.wrong + ")",
                        "an undamaged one");
    }
    if (check.file.kind == "checks") checks = check.file.path;
    if (check.file.kind == "tube-checks") traces = check.file.path;
  }
  if (checks.empty()) return base::fail(ErrorCode::kSchema, folder, "a bundle without checks", "one with checks.csv");
  std::vector<std::string> inputs;
  for (const fuzzy::Variable& input : bundle.model.inputs) inputs.push_back(input.id);
  Questions out;
  TACTUS_TRY(const auto table, base::CsvTable::read(folder + "/" + checks));
  TACTUS_TRY(auto rows, rowsOf(table, inputs));
  TACTUS_TRY(out.points, pointsAt(bundle.model, std::move(rows)));
  if (traces.empty()) {
    out.insertions = insertionsOf(bundle.model);
  } else {
    TACTUS_TRY(out.insertions, readInsertions(folder + "/" + traces, bundle.model));
  }
  out.model = std::move(bundle.model);
  out.model_sha256 = std::move(bundle.model_sha256);
  return out;
}

}  // namespace tactus::certify
