#include "app/workbench/understand/map/map_view_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_choice.h"
#include "app/workbench/understand/map/map_table.h"
#include "app/workbench/understand/map/map_view.h"

namespace tactus::workbench {

MapViewPanel::MapViewPanel(const SceneController& scene, ForceMapController& map, const Content& content,
                           QWidget* parent)
    : Card(parent),
      scene_(scene),
      map_(map),
      content_(content),
      menu_(new PlotMenu(
          *content.view, [this] { return table(); }, this)),
      missing_(new QLabel(content.missing, this)),
      compute_(new Refresh(this,
                           [this] {
                             map_.update();
                             compute_->setRefining(!map_.isFinest());
                           })),
      draw_map_(new Refresh(this, [this] { showMap(); })),
      draw_point_(new Refresh(this, [this] { showPoint(); })) {
  missing_->setAlignment(Qt::AlignCenter);
  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid / 2);
  head->addWidget(new MapChoice(scene, map, this), 1);
  head->addWidget(menu_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid / 2);
  layout->addLayout(head);
  layout->addWidget(content_.plot, 1);
  if (content_.below) layout->addWidget(content_.below);
  layout->addWidget(missing_, 1);
  missing_->hide();

  connect(&map_, &ForceMapController::choiceChanged, this, &MapViewPanel::showChoice);
  connect(&map_, &ForceMapController::mapChanged, this, &MapViewPanel::onMap);
  connect(&scene_, &SceneController::modelChanged, this, &MapViewPanel::adoptModel);
  connect(&scene_, &SceneController::modelEdited, compute_, &Refresh::request);
  connect(&scene_, &SceneController::modelEdited, draw_point_, &Refresh::request);
  connect(&scene_, &SceneController::valueChanged, this, &MapViewPanel::onValue);
  connect(&scene_.ranges(), &ShownRanges::changed, this, &MapViewPanel::onRange);
}

void MapViewPanel::adoptModel() {
  const bool possible = scene_.model()->model.inputs.size() > 1;
  content_.plot->setVisible(possible);
  if (content_.below) content_.below->setVisible(possible);
  menu_->setEnabled(possible);
  missing_->setVisible(!possible);
  showChoice();
}

void MapViewPanel::showChoice() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  content_.view->setAxes(model.inputs[map_.xInput()], model.inputs[map_.yInput()], model.output);
  compute_->request();
  draw_map_->request();
  draw_point_->request();
}

void MapViewPanel::showMap() { content_.view->setMap(map_.map()); }

// At once while the panel is visible, so that an edit is painted within its frame.
void MapViewPanel::onMap() {
  compute_->setRefining(!map_.isFinest());
  if (isVisible()) {
    showMap();
  } else {
    draw_map_->request();
  }
}

void MapViewPanel::showPoint() {
  const fuzzy::Evaluation& here = map_.forceAtPoint();
  content_.view->setPoint(scene_.value(map_.xInput()), scene_.value(map_.yInput()),
                          here.fired ? std::optional(here.force_n) : std::nullopt, map_.pointText());
}

void MapViewPanel::onValue(std::size_t input) {
  if (input != map_.xInput() && input != map_.yInput()) compute_->request();
  draw_point_->request();
}

void MapViewPanel::onRange(const std::string& input_id) {
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  if (input_id == inputs[map_.xInput()].id || input_id == inputs[map_.yInput()].id) compute_->request();
}

PlotTable MapViewPanel::table() {
  PlotTable table = mapTable(scene_, map_, content_.suffix);
  // Hidden, the plot has followed nothing.
  catchUp();
  return table;
}

}  // namespace tactus::workbench
