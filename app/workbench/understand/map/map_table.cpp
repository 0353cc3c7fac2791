#include "app/workbench/understand/map/map_table.h"

#include <QCoreApplication>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"
#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {
namespace {

struct MapTable {
  Q_DECLARE_TR_FUNCTIONS(MapTable)
};

}  // namespace

PlotTable mapTable(const SceneController& scene, ForceMapController& controller, const QString& suffix) {
  const fuzzy::ForceModel& model = scene.model()->model;
  const fuzzy::Variable& x = model.inputs[controller.xInput()];
  const fuzzy::Variable& y = model.inputs[controller.yInput()];
  const fuzzy::Expert* expert = controller.expert() ? &model.experts[*controller.expert()] : nullptr;
  controller.finish();
  const ForceMap& map = *controller.map();

  const std::size_t axes[] = {controller.xInput(), controller.yInput()};
  const QString what = MapTable::tr("%1 over %2 and %3").arg(labelOf(model.output), labelOf(x), labelOf(y));
  const QString whose = expert ? MapTable::tr("expert %1").arg(labelOf(*expert)) : MapTable::tr("mean of the experts");
  PlotTable table = captionedTable(scene, QStringLiteral("%1, %2").arg(what, whose), axes, {}, suffix);
  table.columns = {columnName(x), columnName(y), expert ? columnName(model.output, *expert) : columnName(model.output)};
  const auto place = [&map](const figures::Interval& part, std::size_t i) {
    return std::lerp(part.low, part.high, static_cast<double>(i) / static_cast<double>(map.side - 1));
  };
  for (std::size_t row = 0; row < map.side; ++row) {
    for (std::size_t column = 0; column < map.side; ++column) {
      table.rows.push_back({place(map.x_part, column), place(map.y_part, row),
                            forceCell({map.force(column, row), map.isFired(column, row)})});
    }
  }
  return table;
}

}  // namespace tactus::workbench
