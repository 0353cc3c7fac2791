#include "app/workbench/understand/curves/curve_items.h"

#include <QCoreApplication>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/curves/curve_looks.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "app/workbench/understand/curves/reading_model.h"

namespace tactus::workbench {
namespace {

using Items = std::vector<CurveLegend::Item>;

constexpr std::size_t kMostChips = 8;  // experts with a name of their own in the legend

struct CurveItems {
  Q_DECLARE_TR_FUNCTIONS(CurveItems)
};

std::function<void(bool)> showRows(ReadingModel& readings, int first, int last) {
  return [&readings, first, last](bool shown) {
    for (int row = first; row <= last; ++row) {
      readings.setData(readings.index(row, ReadingModel::kWho), shown ? Qt::Checked : Qt::Unchecked,
                       Qt::CheckStateRole);
    }
  };
}

void addExperts(Items& items, const fuzzy::ForceModel& model, const CurvePlot& plot, ReadingModel& readings) {
  const std::size_t experts = model.experts.size();
  if (experts > kMostChips) {
    LegendEntry all = plot.lineOf(0);
    all.name = CurveItems::tr("%n expert(s)", nullptr, static_cast<int>(experts));
    items.push_back({std::move(all), CurveItems::tr("The lines of all experts; single ones under Forces here"),
                     readings.isShown(1), showRows(readings, 1, static_cast<int>(experts))});
    return;
  }
  for (std::size_t i = 0; i < experts; ++i) {
    const int row = static_cast<int>(i) + 1;
    // The id is short enough for a row of its own; the label is in the tool tip, the table and every picture.
    LegendEntry line = plot.lineOf(i);
    line.name = text(model.experts[i].id);
    items.push_back({std::move(line), CurveItems::tr("Expert %1").arg(labelOf(model.experts[i])), readings.isShown(row),
                     showRows(readings, row, row)});
  }
}

void addSpread(Items& items, std::size_t experts, CurvePlot& plot, const std::function<void()>& changed) {
  if (experts >= 2) {
    items.push_back({rangeLook(CurveItems::tr("Range")),
                     CurveItems::tr("From the lowest to the highest force of the experts who have a rule there"),
                     plot.spreadShown().range, [&plot, changed](bool shown) {
                       plot.setSpreadShown({shown, plot.spreadShown().deviation});
                       changed();
                     }});
  }
  if (experts >= kFewestForDeviation) {
    items.push_back(
        {deviationLook(CurveItems::tr("± 1 SD")),
         CurveItems::tr("Mean ± 1 standard deviation (n − 1) of the %n expert(s), where three or more have a rule. "
                        "So few people say little about others; the range says what these said.",
                        nullptr, static_cast<int>(experts)),
         plot.spreadShown().deviation, [&plot, changed](bool shown) {
           plot.setSpreadShown({plot.spreadShown().range, shown});
           changed();
         }});
  }
}

void addFamily(Items& items, const fuzzy::ForceModel& model, const CurveFamily& family, CurvePlot& plot) {
  for (std::size_t i = 0; i < family.values.size(); ++i) {
    LegendEntry line = plot.familyLine(i);
    const QString tip = CurveItems::tr("%1: the mean of the experts at %2").arg(family.figure, line.name);
    // The name of the input once, where one line stands next to the other.
    if (i > 0) line.name = quantityText(family.values[i], model.inputs[family.input].unit);
    items.push_back(
        {std::move(line), tip, plot.isFamilyShown(i), [&plot, i](bool shown) { plot.setFamilyShown(i, shown); }});
  }
}

}  // namespace

Items curveItems(const SceneController& scene, CurvePlot& plot, ReadingModel& readings,
                 const std::function<void()>& spread_changed) {
  const fuzzy::ForceModel& model = scene.model()->model;
  Items items;
  items.push_back({plot.lineOf(std::nullopt),
                   scene.family() ? CurveItems::tr("The mean of the experts at the operating point")
                                  : CurveItems::tr("The mean of the experts"),
                   readings.isShown(ReadingModel::kMeanRow),
                   showRows(readings, ReadingModel::kMeanRow, ReadingModel::kMeanRow)});
  if (scene.family()) {
    addFamily(items, model, *scene.family(), plot);
  } else {
    addExperts(items, model, plot, readings);
    addSpread(items, model.experts.size(), plot, spread_changed);
  }
  return items;
}

std::optional<int> curveItemOf(const SceneController& scene, int row) {
  if (row == ReadingModel::kMeanRow) return 0;
  if (scene.family()) return std::nullopt;
  if (scene.model()->model.experts.size() <= kMostChips) return row;
  return row == 1 ? std::optional(1) : std::nullopt;
}

}  // namespace tactus::workbench
