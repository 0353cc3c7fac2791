#include "app/workbench/understand/curves/force_spread.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"
#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::workbench {
namespace {

struct CurveTable {
  Q_DECLARE_TR_FUNCTIONS(CurveTable)
};

struct SpreadColumn {
  std::string name;
  std::function<PlotTable::Cell(std::size_t)> cell;
};

SpreadColumn forces(std::string name, const std::vector<fuzzy::Evaluation>& curve) {
  return {std::move(name), [&curve](std::size_t row) { return forceCell(curve[row]); }};
}

SpreadColumn numbers(std::string name, const std::vector<double>& values) {
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
  std::vector<SpreadColumn> columns;
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
  for (const SpreadColumn& column : columns) table.columns.push_back(column.name);
  for (std::size_t row = 0; row < curves.x.size(); ++row) {
    std::vector<PlotTable::Cell>& cells = table.rows.emplace_back();
    cells.emplace_back(curves.x[row]);
    for (const SpreadColumn& column : columns) cells.push_back(column.cell(row));
  }
  return table;
}

namespace {

constexpr std::size_t kMostExperts = 12;
constexpr double kLeastShare = 0.1;  // of the axis; shorter stretches are crossings

bool coincide(const std::vector<double>& x, const std::vector<fuzzy::Evaluation>& one,
              const std::vector<fuzzy::Evaluation>& other, double within_n) {
  const auto near = [&](std::size_t i) {
    return one[i].fired && other[i].fired && std::abs(one[i].force_n - other[i].force_n) <= within_n;
  };
  double together = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (near(i - 1) && near(i)) together += x[i] - x[i - 1];
  }
  return together >= kLeastShare * (x.back() - x.front());
}

}  // namespace

std::vector<Coincidence> coincidences(const figures::ForceCurves& curves, double within_n) {
  const std::size_t count = curves.experts.size();
  std::vector<Coincidence> out(count);
  if (count > kMostExperts || curves.x.size() < 2) return out;
  // The first expert of each group.
  std::vector<std::size_t> first(count);
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (first[j] == first[i] || !coincide(curves.x, curves.experts[i], curves.experts[j], within_n)) continue;
      const std::size_t joined = first[j];
      for (std::size_t& one : first) {
        if (one == joined) one = first[i];
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = {0, 0};
    for (std::size_t j = 0; j < count; ++j) {
      if (first[j] != first[i]) continue;
      if (j < i) ++out[i].member;
      ++out[i].of;
    }
  }
  return out;
}

ForceSpread spreadOf(const figures::ForceCurves& curves, std::span<const double> weights) {
  TACTUS_CHECK(weights.size() == curves.experts.size());
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = curves.x.size();
  ForceSpread spread{std::vector<double>(count, kNone), std::vector<double>(count, kNone),
                     std::vector<double>(count, kNone), std::vector<double>(count, kNone),
                     std::vector<double>(count, kNone)};
  for (std::size_t i = 0; i < count; ++i) {
    double lowest = HUGE_VAL;
    double highest = -HUGE_VAL;
    double weight = 0;
    double weight_squared = 0;
    double squares = 0;
    std::size_t speaking = 0;
    for (std::size_t expert = 0; expert < weights.size(); ++expert) {
      const fuzzy::Evaluation& here = curves.experts[expert][i];
      if (!here.fired || !(weights[expert] > 0)) continue;
      ++speaking;
      lowest = std::min(lowest, here.force_n);
      highest = std::max(highest, here.force_n);
      const double share = weights[expert];
      const double off = here.force_n - curves.mean[i].force_n;
      weight += share;
      weight_squared += share * share;
      squares += share * off * off;
    }
    if (speaking >= 2) {
      spread.lowest_n[i] = lowest;
      spread.highest_n[i] = highest;
    }
    if (speaking >= kFewestForDeviation) {
      const double deviation = std::sqrt(squares / (weight - weight_squared / weight));
      spread.deviation_n[i] = deviation;
      spread.minus_sd_n[i] = curves.mean[i].force_n - deviation;
      spread.plus_sd_n[i] = curves.mean[i].force_n + deviation;
    }
  }
  return spread;
}

}  // namespace tactus::workbench
