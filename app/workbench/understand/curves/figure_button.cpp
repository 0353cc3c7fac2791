#include "app/workbench/understand/curves/figure_button.h"

#include <QMenu>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

// `Fig. 11: experts and mean (lubrication 1, speed 50 mm/s)` with the labels of the model.
QString presetText(const fuzzy::ForceModel& model, const FigurePreset& preset) {
  QStringList values;
  for (const fuzzy::Variable& input : model.inputs) {
    for (const FigurePreset::Setting& setting : preset.settings) {
      if (setting.input != input.id) continue;
      values << labelOf(input) + QLatin1Char(' ') + quantityText(setting.value, input.unit);
    }
  }
  return QStringLiteral("%1: %2 (%3)").arg(preset.figure, preset.shows, values.join(QStringLiteral(", ")));
}

}  // namespace

FigureButton::FigureButton(SceneController& scene, QWidget* parent)
    : QPushButton(tr("Figures"), parent), scene_(scene) {
  setMenu(new QMenu(this));
  // The style leaves no air around the text.
  keepFitted(*this, [this] { setMinimumWidth(fontMetrics().horizontalAdvance(text()) + 5 * theme::kGrid); });
  setToolTip(tr("Set the inputs as in a figure of the paper, and show the curves it shows"));
  connect(menu(), &QMenu::aboutToShow, this, &FigureButton::showFamily);
  connect(&scene_, &SceneController::modelChanged, this, &FigureButton::adoptModel);
  connect(&scene_, &SceneController::familyChanged, this, &FigureButton::showFamily);
}

void FigureButton::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const std::vector<FigurePreset> presets = figurePresets(model);
  menu()->clear();
  menu()->addAction(tr("Experts and mean"), &scene_, &SceneController::clearFamily)->setCheckable(true);
  menu()->addSeparator();
  for (const FigurePreset& preset : presets) {
    QAction* action = menu()->addAction(presetText(model, preset));
    action->setCheckable(!preset.varied.empty());
    action->setData(preset.figure);
    connect(action, &QAction::triggered, &scene_, [this, preset] { scene_.applyPreset(preset); });
  }
  setVisible(!presets.empty());
  showFamily();
}

void FigureButton::showFamily() {
  const QString figure = scene_.family() ? scene_.family()->figure : QString();
  setText(figure.isEmpty() ? tr("Figures") : figure);
  for (QAction* action : menu()->actions()) action->setChecked(action->data().toString() == figure);
}

}  // namespace tactus::workbench
