#include "app/workbench/understand/curves/curve_table.h"

#include <QCoreApplication>
#include <cmath>
#include <functional>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

struct CurveTable {
  Q_DECLARE_TR_FUNCTIONS(CurveTable)
};

struct Column {
  std::string name;
  std::function<PlotTable::Cell(std::size_t)> cell;
};

Column forces(std::string name, const std::vector<fuzzy::Evaluation>& curve) {
  return {std::move(name), [&curve](std::size_t row) { return forceCell(curve[row]); }};
}

Column numbers(std::string name, const std::vector<double>& values) {
  return {std::move(name), [&values](std::size_t row) {
            return std::isnan(values[row]) ? PlotTable::Cell() : PlotTable::Cell(values[row]);
          }};
}

// `force_at_lubrication_0.25_n`
std::string familyColumn(const fuzzy::ForceModel& model, const CurveFamily& family, std::size_t line) {
  const std::string at = columnName(model.inputs[family.input].id + '_' + base::formatNumber(family.values[line]),
                                    model.inputs[family.input].unit);
  return columnName(model.output.id + "_at_" + at, model.output.unit);
}

}  // namespace

PlotTable curveTable(const SceneController& scene, const ShownCurves& shown, QStringList notes) {
  const fuzzy::ForceModel& model = scene.model()->model;
  const figures::ForceCurves& curves = scene.curves();
  std::vector<Column> columns;
  if (shown.mean) columns.push_back(forces(columnName(model.output), curves.mean));
  for (std::size_t i = 0; i < shown.experts.size(); ++i) {
    if (shown.experts[i]) columns.push_back(forces(columnName(model.output, model.experts[i]), curves.experts[i]));
  }
  ForceSpread spread;
  if (shown.range || shown.deviation) spread = spreadOf(curves, normalizedWeights(model));
  const auto named = [&model](const char* what) { return columnName(what + model.output.id, model.output.unit); };
  if (shown.range) {
    columns.push_back(numbers(named("lowest_"), spread.lowest_n));
    columns.push_back(numbers(named("highest_"), spread.highest_n));
  }
  if (shown.deviation) columns.push_back(numbers(named("sd_"), spread.deviation_n));
  if (scene.family()) {
    const CurveFamily& family = *scene.family();
    QStringList lines;
    for (std::size_t i = 0; i < shown.family.size(); ++i) {
      if (!shown.family[i]) continue;
      // Both are sampled at the same places.
      columns.push_back(forces(familyColumn(model, family, i), scene.familyCurves().curves[i]));
      lines << numberText(family.values[i]);
    }
    if (!lines.isEmpty()) {
      const fuzzy::Variable& varied = model.inputs[family.input];
      const QString values = (lines.join(QStringLiteral(", ")) + QLatin1Char(' ') + unitText(varied.unit)).trimmed();
      notes.prepend(
          CurveTable::tr("As in %1: mean of the experts at %2 %3").arg(family.figure, shortLabelOf(varied), values));
    }
  }

  const std::size_t axes[] = {scene.xInput()};
  PlotTable table =
      captionedTable(scene, CurveTable::tr("%1 along %2").arg(labelOf(model.output), labelOf(scene.xVariable())), axes,
                     notes, QStringLiteral("-curves"));
  table.columns = {columnName(scene.xVariable())};
  for (const Column& column : columns) table.columns.push_back(column.name);
  for (std::size_t row = 0; row < curves.x.size(); ++row) {
    std::vector<PlotTable::Cell>& cells = table.rows.emplace_back();
    cells.emplace_back(curves.x[row]);
    for (const Column& column : columns) cells.push_back(column.cell(row));
  }
  return table;
}

}  // namespace tactus::workbench
