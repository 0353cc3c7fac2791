#include "app/workbench/views/map_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/workbench/controllers/force_map.h"
#include "app/workbench/controllers/map_table.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/plots/force_map_plot.h"
#include "app/workbench/refresh.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/map_choice.h"
#include "app/workbench/views/plot_menu.h"

namespace tactus::workbench {

MapPanel::MapPanel(SceneController& scene, ForceMapController& map, QWidget* parent)
    : Card(parent),
      scene_(scene),
      map_(map),
      choice_(new MapChoice(scene, map, this)),
      plot_(new ForceMapPlot(this)),
      menu_(new PlotMenu(
          *plot_, [this] { return table(); }, this)),
      missing_(new QLabel(tr("A map needs a model with two inputs."), this)),
      compute_(new Refresh(this, [this] { map_.update(); })),
      draw_map_(new Refresh(this, [this] { showMap(); })),
      draw_point_(new Refresh(this, [this] { showPoint(); })) {
  missing_->setAlignment(Qt::AlignCenter);
  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid / 2);
  head->addWidget(choice_, 1);
  head->addWidget(menu_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  layout->addWidget(missing_, 1);
  missing_->hide();

  connect(plot_, &ForceMapPlot::picked, this, &MapPanel::setPoint);
  connect(&map_, &ForceMapController::choiceChanged, this, &MapPanel::showChoice);
  connect(&map_, &ForceMapController::mapChanged, this, &MapPanel::onMap);
  connect(&scene_, &SceneController::modelChanged, this, &MapPanel::adoptModel);
  connect(&scene_, &SceneController::modelEdited, compute_, &Refresh::request);
  connect(&scene_, &SceneController::modelEdited, draw_point_, &Refresh::request);
  connect(&scene_, &SceneController::valueChanged, this, &MapPanel::onValue);
}

void MapPanel::adoptModel() {
  const bool possible = scene_.model()->model.inputs.size() > 1;
  plot_->setVisible(possible);
  menu_->setEnabled(possible);
  missing_->setVisible(!possible);
  showChoice();
}

void MapPanel::showChoice() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  plot_->setAxes(model.inputs[map_.xInput()], model.inputs[map_.yInput()], model.output);
  compute_->request();
  draw_map_->request();
  draw_point_->request();
}

void MapPanel::showMap() { plot_->setMap(map_.map()); }

// At once where somebody sees it, so that an edit is on the screen within its frame.
void MapPanel::onMap() {
  compute_->setRefining(!map_.isFinest());
  if (isVisible()) {
    showMap();
  } else {
    draw_map_->request();
  }
}

void MapPanel::showPoint() {
  plot_->setPoint(scene_.value(map_.xInput()), scene_.value(map_.yInput()), map_.pointText());
}

void MapPanel::onValue(std::size_t input) {
  if (input != map_.xInput() && input != map_.yInput()) compute_->request();
  draw_point_->request();
}

void MapPanel::setPoint(double x, double y) {
  scene_.setValue(map_.xInput(), x);
  scene_.setValue(map_.yInput(), y);
}

PlotTable MapPanel::table() {
  PlotTable table = mapTable(scene_, map_, QStringLiteral("-map"));
  // Hidden, the plot has followed nothing.
  showMap();
  return table;
}

}  // namespace tactus::workbench
