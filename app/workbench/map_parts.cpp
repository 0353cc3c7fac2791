#include "app/workbench/map_parts.h"

#include <QAction>

#include "app/workbench/model/model_controller.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_panel.h"
#include "app/workbench/understand/map/surface_panel.h"

namespace tactus::workbench {

MapParts::MapParts(MainWindow& window, const ModelController& models, SceneController& scene) {
  auto* forces = new ForceMapController(scene, this);
  view_ = new MapPanel(scene, *forces);
  map_ = &window.addPanel(QStringLiteral("map"), tr("Map"), view_);
  surface_ = &window.addPanel(QStringLiteral("surface"), tr("Surface"), new SurfacePanel(scene, *forces));

  QAction* const picture = window.menus().addAction(MenuSlot::kFilePictures, tr("Save picture of the &map…"),
                                                    Qt::CTRL | Qt::SHIFT | Qt::Key_E);
  picture->setEnabled(false);
  connect(picture, &QAction::triggered, &view_->plotMenu(), &PlotMenu::choosePicture);
  connect(&models, &ModelController::opened, picture,
          [picture, &models] { picture->setEnabled(models.current()->model.inputs.size() > 1); });
}

}  // namespace tactus::workbench
