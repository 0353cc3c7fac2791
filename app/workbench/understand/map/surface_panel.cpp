#include "app/workbench/understand/map/surface_panel.h"

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/understand/map/surface_plot.h"

namespace tactus::workbench {
namespace {

QWidget* hint() {
  auto* label = new ElidedLabel;
  label->setFont(theme::smallFont());
  label->setFullText(SurfacePanel::tr(
      "Drag or arrow keys turn, with Shift farther; the wheel zooms; double click or Home: standard view."));
  return label;
}

}  // namespace

SurfacePanel::SurfacePanel(const SceneController& scene, ForceMapController& map, QWidget* parent)
    : SurfacePanel(scene, map, new SurfacePlot, parent) {}

SurfacePanel::SurfacePanel(const SceneController& scene, ForceMapController& map, SurfacePlot* plot, QWidget* parent)
    : MapViewPanel(scene, map,
                   {plot, plot, hint(), tr("A surface needs a model with two inputs."), QStringLiteral("-surface")},
                   parent) {
  plot->setAccessibleName(tr("Force over two inputs as a surface"));
}

}  // namespace tactus::workbench
