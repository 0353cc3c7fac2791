#include "app/workbench/understand/map/map_choice.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {

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
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(theme::kGrid / 2);
  layout->addWidget(who_, 2);
  layout->addWidget(new QLabel(tr("over"), this));
  layout->addWidget(x_input_, 3);
  layout->addWidget(new QLabel(tr("and"), this));
  layout->addWidget(y_input_, 3);
  layout->addStretch(0);

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

}  // namespace tactus::workbench
