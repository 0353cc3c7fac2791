#include "app/workbench/views/map_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/plots/force_map_plot.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/refresh.h"

namespace tactus::workbench {

MapPanel::MapPanel(SceneController& scene, QWidget* parent)
    : Card(parent),
      scene_(scene),
      map_(scene),
      who_(new QComboBox(this)),
      x_input_(new QComboBox(this)),
      y_input_(new QComboBox(this)),
      plot_(new ForceMapPlot(this)),
      missing_(new QLabel(tr("A map needs a model with two inputs."), this)),
      compute_(new Refresh(this, [this] { map_.compute(); })),
      draw_point_(new Refresh(this, [this] { showPoint(); })) {
  who_->setAccessibleName(tr("Whose force the map shows"));
  x_input_->setAccessibleName(tr("Input on the x axis of the map"));
  y_input_->setAccessibleName(tr("Input on the y axis of the map"));
  for (QComboBox* choice : {who_, x_input_, y_input_}) {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(5);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    choice->setMaximumWidth(200);
  }
  missing_->setAlignment(Qt::AlignCenter);
  auto* save = new QToolButton(this);
  save->setIcon(style()->standardIcon(QStyle::SP_DialogSaveButton));
  save->setToolTip(tr("Save the map as a picture…"));
  save->setAccessibleName(save->toolTip());
  save->setAutoRaise(true);

  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid / 2);
  head->addWidget(who_, 2);
  head->addWidget(new QLabel(tr("over"), this));
  head->addWidget(x_input_, 3);
  head->addWidget(new QLabel(tr("and"), this));
  head->addWidget(y_input_, 3);
  head->addStretch(0);
  head->addWidget(save);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  layout->addWidget(missing_, 1);
  missing_->hide();

  connect(save, &QToolButton::clicked, this, &MapPanel::savePictureRequested);
  connect(who_, &QComboBox::activated, this, [this](int row) {
    map_.setExpert(row == 0 ? std::nullopt : std::optional(static_cast<std::size_t>(row) - 1));
  });
  const auto choose_axes = [this] {
    map_.setAxes(static_cast<std::size_t>(x_input_->currentIndex()),
                 static_cast<std::size_t>(y_input_->currentIndex()));
  };
  connect(x_input_, &QComboBox::activated, this, choose_axes);
  connect(y_input_, &QComboBox::activated, this, choose_axes);
  connect(plot_, &ForceMapPlot::picked, this, &MapPanel::setPoint);
  connect(&map_, &ForceMapController::choiceChanged, this, &MapPanel::showChoice);
  connect(&map_, &ForceMapController::mapChanged, this, &MapPanel::showMap);
  connect(&scene_, &SceneController::modelChanged, this, &MapPanel::adoptModel);
  connect(&scene_, &SceneController::modelEdited, compute_, &Refresh::request);
  connect(&scene_, &SceneController::modelEdited, draw_point_, &Refresh::request);
  connect(&scene_, &SceneController::valueChanged, this, &MapPanel::onValue);
}

base::Result<void> MapPanel::savePicture(const QString& path) {
  const OpenModel& open = *scene_.model();
  QString note = settingText();
  if (open.simulated) note += QStringLiteral(" – ") + tr("contains simulated data");
  return plot_->savePicture(path, text(open.model.name), note);
}

void MapPanel::hideEvent(QHideEvent* event) {
  Card::hideEvent(event);
  if (map_.isFinest()) return;
  map_.stop();
  compute_->request();  // when it is shown again
}

void MapPanel::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  who_->clear();
  who_->addItem(tr("Mean"));
  for (const fuzzy::Expert& expert : model.experts) who_->addItem(labelOf(expert));
  for (QComboBox* choice : {x_input_, y_input_}) {
    choice->clear();
    for (const fuzzy::Variable& input : model.inputs) choice->addItem(labelOf(input));
  }
  const bool possible = model.inputs.size() > 1;
  plot_->setVisible(possible);
  missing_->setVisible(!possible);
  showChoice();
}

void MapPanel::showChoice() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  // The map's own controller hears of another model before this panel does.
  if (x_input_->count() != static_cast<int>(model.inputs.size())) return;
  x_input_->setCurrentIndex(static_cast<int>(map_.xInput()));
  y_input_->setCurrentIndex(static_cast<int>(map_.yInput()));
  who_->setCurrentIndex(map_.expert() ? static_cast<int>(*map_.expert()) + 1 : 0);
  plot_->setAxes(model.inputs[map_.xInput()], model.inputs[map_.yInput()], model.output);
  compute_->request();
  draw_point_->request();
}

void MapPanel::showMap() {
  if (isVisible()) plot_->setMap(map_.map());
}

void MapPanel::showPoint() {
  const OpenModel& open = *scene_.model();
  const fuzzy::Evaluation here = map_.forceAtPoint();
  const QString force = here.fired ? forceText(here.force_n, open.model.output.unit) : tr("no rule fires");
  const fuzzy::Variable& x = open.model.inputs[map_.xInput()];
  const fuzzy::Variable& y = open.model.inputs[map_.yInput()];
  const double x_value = scene_.value(map_.xInput());
  const double y_value = scene_.value(map_.yInput());
  plot_->setPoint(x_value, y_value,
                  QStringLiteral("%1, %2   %3").arg(placeText(x, x_value), placeText(y, y_value), force));
}

void MapPanel::onValue(std::size_t input) {
  if (input != map_.xInput() && input != map_.yInput()) compute_->request();
  draw_point_->request();
}

void MapPanel::setPoint(double x, double y) {
  scene_.setValue(map_.xInput(), x);
  scene_.setValue(map_.yInput(), y);
}

QString MapPanel::settingText() const {
  const fuzzy::ForceModel& model = scene_.model()->model;
  QStringList parts{who_->currentText()};
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i == map_.xInput() || i == map_.yInput()) continue;
    parts << labelOf(model.inputs[i]) + QLatin1Char(' ') + quantityText(scene_.value(i), model.inputs[i].unit);
  }
  return parts.join(QStringLiteral(" · "));
}

}  // namespace tactus::workbench
