#include "app/workbench/understand/map/map_view_panel.h"

#include <QComboBox>
#include <QLabel>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {

QColor forceColor(double share) {
  // Terms so many that two neighbors look the same.
  constexpr std::size_t kTerms = 256;
  return theme::force(static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * (kTerms - 1))), kTerms);
}

QBrush silentGround() { return {theme::border(), Qt::BDiagPattern}; }

MapChoice::MapChoice(const SceneController& scene, ForceMapController& map, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      map_(map),
      who_(new QComboBox(this)),
      x_input_(new QComboBox(this)),
      y_input_(new QComboBox(this)) {
  who_->setAccessibleName(tr("Whose force is shown"));
  x_input_->setAccessibleName(tr("Input on the x axis"));
  y_input_->setAccessibleName(tr("Input on the y axis"));
  for (QComboBox* choice : {who_, x_input_, y_input_}) {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(5);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    choice->setMaximumWidth(200);
  }
  makeRow(
      this,
      {{who_, 2}, new QLabel(tr("over"), this), {x_input_, 3}, new QLabel(tr("and"), this), {y_input_, 3}, spring()},
      theme::kGrid / 2);

  connect(who_, &QComboBox::activated, this, [this](int row) {
    map_.setExpert(row == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row) - 1));
  });
  const auto choose_axes = [this] {
    map_.setAxes(static_cast<std::size_t>(x_input_->currentIndex()),
                 static_cast<std::size_t>(y_input_->currentIndex()));
  };
  connect(x_input_, &QComboBox::activated, this, choose_axes);
  connect(y_input_, &QComboBox::activated, this, choose_axes);
  connect(&map_, &ForceMapController::choiceChanged, this, &MapChoice::showChoice);
  connect(&scene_, &SceneController::modelChanged, this, &MapChoice::adoptModel);
}

QString MapChoice::who() const { return who_->currentText(); }

void MapChoice::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!std::exchange(counted_, true)) map_.addViewer();
}

void MapChoice::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (std::exchange(counted_, false)) map_.removeViewer();
}

void MapChoice::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  who_->clear();
  who_->addItem(tr("Mean"));
  for (const fuzzy::Expert& expert : model.experts) who_->addItem(labelOf(expert));
  for (QComboBox* choice : {x_input_, y_input_}) {
    choice->clear();
    for (const fuzzy::Variable& input : model.inputs) choice->addItem(labelOf(input));
  }
  showChoice();
}

void MapChoice::showChoice() {
  // The controller of the map hears of another model before this does.
  if (x_input_->count() != static_cast<int>(scene_.model()->model.inputs.size())) return;
  x_input_->setCurrentIndex(static_cast<int>(map_.xInput()));
  y_input_->setCurrentIndex(static_cast<int>(map_.yInput()));
  who_->setCurrentIndex(map_.expert() ? static_cast<int>(*map_.expert()) + 1 : 0);
}

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
  auto* layout =
      makeColumn(this, {makeRow({{new MapChoice(scene, map, this), 1}, menu_}, theme::kGrid / 2), {content_.plot, 1}},
                 theme::kGrid / 2, {theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid});
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

void MapViewPanel::showEvent(QShowEvent* event) {
  Card::showEvent(event);
  if (scene_.model() != nullptr) compute_->request();
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
