#include "app/workbench/feel/trace_table.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_history.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/plot_caption.h"

namespace tactus::workbench {
namespace {

struct TraceTable {
  Q_DECLARE_TR_FUNCTIONS(TraceTable)
};

}  // namespace

PlotTable traceTable(const SceneController& scene, const FeelHistory& history,
                     const std::optional<haptics::DeviceInfo>& device) {
  // Depth and speed change along the trace.
  std::vector<std::size_t> moving;
  for (const char* id : {kDepthId, kSpeedId}) {
    if (const auto input = inputNamed(scene.model()->model, id)) moving.push_back(*input);
  }
  QString felt_on;
  if (device) {
    felt_on = device->simulated ? TraceTable::tr("Felt on: %1, a simulated device").arg(text(device->name))
                                : TraceTable::tr("Felt on: %1").arg(text(device->name));
  }
  PlotTable table =
      captionedTable(scene, TraceTable::tr("force felt in the last %1 s").arg(numberText(FeelHistory::kTraceS)), moving,
                     {felt_on}, QStringLiteral("-force-trace"));
  table.columns = {"time_s", "force_n", "model_force_n", "source_force_n"};
  if (history.hasRecorded()) table.columns.emplace_back("recorded_force_n");
  for (const TracePoint& point : history.trace()) {
    auto& row = table.rows.emplace_back();
    for (const double value : {point.time_s - history.nowS(), point.force_n, point.model_n, point.friction_n}) {
      row.emplace_back(value);
    }
    if (!history.hasRecorded()) continue;
    if (point.recorded_n) {
      row.emplace_back(*point.recorded_n);
    } else {
      row.emplace_back();
    }
  }
  return table;
}

}  // namespace tactus::workbench
