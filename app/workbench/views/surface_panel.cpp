#include "app/workbench/views/surface_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/workbench/controllers/force_map.h"
#include "app/workbench/controllers/map_table.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/plots/surface_plot.h"
#include "app/workbench/refresh.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/elided_label.h"
#include "app/workbench/views/map_choice.h"
#include "app/workbench/views/plot_menu.h"

namespace tactus::workbench {

SurfacePanel::SurfacePanel(const SceneController& scene, ForceMapController& map, QWidget* parent)
    : Card(parent),
      scene_(scene),
      map_(map),
      choice_(new MapChoice(scene, map, this)),
      plot_(new SurfacePlot(this)),
      menu_(new PlotMenu(
          *plot_, [this] { return table(); }, this)),
      hint_(new ElidedLabel(this)),
      missing_(new QLabel(tr("A surface needs a model with two inputs."), this)),
      compute_(new Refresh(this, [this] { map_.update(); })),
      draw_map_(new Refresh(this, [this] { showMap(); })),
      draw_point_(new Refresh(this, [this] { showPoint(); })) {
  missing_->setAlignment(Qt::AlignCenter);
  hint_->setFont(theme::smallFont());
  hint_->setFullText(
      tr("Drag or arrow keys turn, with Shift farther; the wheel zooms; double click or Home: standard view."));
  plot_->setAccessibleName(tr("Force over two inputs as a surface"));
  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid / 2);
  head->addWidget(choice_, 1);
  head->addWidget(menu_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid / 2);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  layout->addWidget(hint_);
  layout->addWidget(missing_, 1);
  missing_->hide();

  connect(&map_, &ForceMapController::choiceChanged, this, &SurfacePanel::showChoice);
  connect(&map_, &ForceMapController::mapChanged, this, &SurfacePanel::onMap);
  connect(&scene_, &SceneController::modelChanged, this, &SurfacePanel::adoptModel);
  connect(&scene_, &SceneController::modelEdited, compute_, &Refresh::request);
  connect(&scene_, &SceneController::modelEdited, draw_point_, &Refresh::request);
  connect(&scene_, &SceneController::valueChanged, this, &SurfacePanel::onValue);
}

void SurfacePanel::adoptModel() {
  const bool possible = scene_.model()->model.inputs.size() > 1;
  plot_->setVisible(possible);
  hint_->setVisible(possible);
  menu_->setEnabled(possible);
  missing_->setVisible(!possible);
  showChoice();
}

void SurfacePanel::showChoice() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  plot_->setAxes(model.inputs[map_.xInput()], model.inputs[map_.yInput()], model.output);
  compute_->request();
  draw_map_->request();
  draw_point_->request();
}

void SurfacePanel::showMap() { plot_->setMap(map_.map()); }

void SurfacePanel::onMap() {
  compute_->setRefining(!map_.isFinest());
  if (isVisible()) {
    showMap();
  } else {
    draw_map_->request();
  }
}

void SurfacePanel::showPoint() {
  const fuzzy::Evaluation& here = map_.forceAtPoint();
  const double x = scene_.value(map_.xInput());
  const double y = scene_.value(map_.yInput());
  plot_->setPoint(x, y, here.fired ? std::optional(here.force_n) : std::nullopt, map_.pointText());
}

void SurfacePanel::onValue(std::size_t input) {
  if (input != map_.xInput() && input != map_.yInput()) compute_->request();
  draw_point_->request();
}

PlotTable SurfacePanel::table() {
  PlotTable table = mapTable(scene_, map_, QStringLiteral("-surface"));
  // Hidden, the plot has followed nothing.
  showMap();
  return table;
}

}  // namespace tactus::workbench
