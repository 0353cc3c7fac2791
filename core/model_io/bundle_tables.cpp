// The tables of a bundle against the model: its forces, and the insertions.
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/bundle_check.h"
#include "core/render/tube_checks.h"

namespace tactus::model_io {

base::Result<TableError> errorOfChecks(const fuzzy::ForceModel& model, std::string text, const std::string& file) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  TACTUS_TRY(const auto table, base::CsvTable::parse(std::move(text), file));
  std::vector<std::size_t> columns;
  std::vector<std::string> names;
  for (const fuzzy::Variable& input : model.inputs) names.push_back(input.id);
  names.insert(names.end(), {"force", "fired"});
  for (const std::string& name : names) {
    TACTUS_TRY(const auto column, table.require(name));
    columns.push_back(column);
  }
  TableError out;
  std::vector<double> row(columns.size());
  for (std::size_t r = 0; r < table.rowCount(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      TACTUS_TRY(const auto value, table.number(r, columns[c]));
      row[c] = value;
    }
    const std::span point = std::span(row).first(model.inputs.size());
    const fuzzy::Evaluation force = compiled.evaluate(point);
    if (force.fired != (row.back() != 0)) {
      return table.refuse(
          r, columns.back(), base::ErrorCode::kMismatch,
          std::string(force.fired ? "1" : "0") + ", because " + (force.fired ? "a" : "no") + " rule fires there");
    }
    const double error_n = std::abs(force.force_n - row[row.size() - 2]);
    ++out.points;
    if (!(error_n > out.largest_n)) continue;
    out.largest_n = error_n;
    out.at.assign(point.begin(), point.end());
  }
  return out;
}

namespace {

constexpr double kMostDepthMm = 1e-9;

/// The columns of a table of insertions, in their order.
struct TubeColumns {
  std::size_t trace = 0;
  std::size_t position = 0, held = 0, dt = 0;
  std::vector<std::size_t> conditions;
  std::size_t force = 0, depth = 0, phase = 0, stroke = 0;
};

base::Result<TubeColumns> tubeColumns(const base::CsvTable& table, const fuzzy::ForceModel& model,
                                      const render::TubeInputs& inputs) {
  TubeColumns out;
  TACTUS_TRY(out.trace, table.require("trace"));
  TACTUS_TRY(out.position, table.require("position_mm"));
  TACTUS_TRY(out.held, table.require("held"));
  TACTUS_TRY(out.dt, table.require("dt_s"));
  for (const std::size_t input : inputs.conditions) {
    TACTUS_TRY(const auto column, table.require(model.inputs[input].id));
    out.conditions.push_back(column);
  }
  TACTUS_TRY(out.force, table.require("force_n"));
  TACTUS_TRY(out.depth, table.require("depth_mm"));
  TACTUS_TRY(out.phase, table.require("phase"));
  TACTUS_TRY(out.stroke, table.require("stroke"));
  return out;
}

base::Result<render::TubeStep> stepOf(const base::CsvTable& table, std::size_t row, const TubeColumns& columns) {
  render::TubeStep out;
  TACTUS_TRY(out.position_mm, table.number(row, columns.position));
  TACTUS_TRY(const double held, table.number(row, columns.held));
  TACTUS_TRY(out.dt_s, table.number(row, columns.dt));
  out.held = held != 0;
  for (const std::size_t column : columns.conditions) {
    TACTUS_TRY(const double value, table.number(row, column));
    out.conditions.push_back(value);
  }
  return out;
}

}  // namespace

base::Result<TableError> errorOfTubeChecks(const fuzzy::ForceModel& model, std::string text, const std::string& file) {
  TACTUS_TRY(const auto inputs, render::tubeInputs(model));
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  TACTUS_TRY(const auto table, base::CsvTable::parse(std::move(text), file));
  TACTUS_TRY(const TubeColumns columns, tubeColumns(table, model, inputs));
  TableError out;
  std::optional<render::TubeRun> run;
  std::string trace;
  double traces = 0;
  double step_number = 0;
  for (std::size_t r = 0; r < table.rowCount(); ++r) {
    if (!run || table.cell(r, columns.trace) != trace) {
      run.emplace(model, inputs, compiled);
      trace = table.cell(r, columns.trace);
      ++traces;
      step_number = 0;
    }
    ++step_number;
    TACTUS_TRY(const auto step, stepOf(table, r, columns));
    TACTUS_TRY(const auto felt, run->step(step));
    TACTUS_TRY(const double force_n, table.number(r, columns.force));
    TACTUS_TRY(const double depth_mm, table.number(r, columns.depth));
    TACTUS_TRY(const double phase, table.number(r, columns.phase));
    TACTUS_TRY(const double stroke, table.number(r, columns.stroke));
    const auto wrong = [&](std::size_t column, double wanted) {
      return table.refuse(r, column, base::ErrorCode::kMismatch,
                          base::formatNumber(wanted) + ", which the renderer gives there");
    };
    if (phase != felt.phase) return wrong(columns.phase, felt.phase);
    if (stroke != felt.stroke) return wrong(columns.stroke, felt.stroke);
    if (!(std::abs(depth_mm - felt.depth_mm) <= kMostDepthMm)) return wrong(columns.depth, felt.depth_mm);
    const double error_n = std::abs(force_n - felt.force_n);
    ++out.points;
    if (!(error_n > out.largest_n)) continue;
    out.largest_n = error_n;
    out.at = {traces, step_number};
  }
  return out;
}

}  // namespace tactus::model_io
