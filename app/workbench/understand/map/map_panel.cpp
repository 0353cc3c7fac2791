#include "app/workbench/understand/map/map_panel.h"

#include "app/workbench/base/refresh.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/force_map_plot.h"

namespace tactus::workbench {

MapPanel::MapPanel(SceneController& scene, ForceMapController& map, QWidget* parent)
    : MapPanel(scene, map, new ForceMapPlot(scene.ranges()), parent) {}

MapPanel::MapPanel(SceneController& scene, ForceMapController& map, ForceMapPlot* plot, QWidget* parent)
    : MapViewPanel(scene, map,
                   {plot, plot, nullptr, tr("A map needs a model with two inputs."), QStringLiteral("-map")}, parent),
      scene_(scene),
      map_(map),
      plot_(plot) {
  connect(plot, &ForceMapPlot::picked, this, [&scene, &map](double x, double y) {
    scene.setValue(map.xInput(), x);
    scene.setValue(map.yInput(), y);
  });
  auto* terms = new Refresh(this, [this] { showTerms(); });
  connect(&map, &ForceMapController::choiceChanged, terms, &Refresh::request);
  connect(&scene, &SceneController::modelChanged, terms, &Refresh::request);
  connect(&scene, &SceneController::termsChanged, terms, &Refresh::request);
}

void MapPanel::catchUp() {
  showTerms();
  MapViewPanel::catchUp();
}

void MapPanel::showTerms() {
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  plot_->setTerms(scene_.terms(inputs[map_.xInput()]), scene_.terms(inputs[map_.yInput()]));
}

}  // namespace tactus::workbench
