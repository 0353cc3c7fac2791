#include "app/workbench/views/curves_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/controllers/plot_caption.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/models/reading_model.h"
#include "app/workbench/plots/curve_plot.h"
#include "app/workbench/refresh.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/plot_menu.h"

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

CurvesPanel::CurvesPanel(SceneController& scene, ReadingModel& readings, QWidget* parent)
    : Card(parent),
      scene_(scene),
      title_(new QLabel(this)),
      x_input_(new QComboBox(this)),
      presets_(new QPushButton(tr("Figures"), this)),
      plot_(new CurvePlot(this)),
      menu_(new PlotMenu(
          *plot_, [this] { return table(); }, this)),
      draw_curves_(new Refresh(this, [this] { plot_->setCurves(scene_.curves()); })),
      draw_reading_(new Refresh(this, [this] { plot_->setReading(scene_.reading()); })) {
  title_->setFont(theme::headingFont());
  title_->setTextFormat(Qt::PlainText);
  title_->setBuddy(x_input_);
  x_input_->setAccessibleName(tr("Input on the x axis"));
  x_input_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  presets_->setMenu(new QMenu(presets_));
  // The style leaves no air around the text.
  presets_->setMinimumWidth(presets_->sizeHint().width() + 2 * theme::kGrid);
  presets_->setToolTip(tr("Set the inputs as in a figure of the paper"));

  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(title_);
  head->addWidget(x_input_);
  head->addStretch(1);
  head->addWidget(presets_);
  head->addWidget(menu_);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);

  connect(x_input_, &QComboBox::activated, this, &CurvesPanel::onXInputChosen);
  connect(plot_, &CurvePlot::hovered, &scene_, &SceneController::setHover);
  connect(plot_, &CurvePlot::hoverLeft, &scene_, &SceneController::clearHover);
  connect(plot_, &CurvePlot::picked, &scene_, [this](double x) { scene_.setValue(scene_.xInput(), x); });
  connect(&readings, &ReadingModel::rowShownChanged, this, &CurvesPanel::onRowShown);
  connect(&scene_, &SceneController::modelChanged, this, &CurvesPanel::adoptModel);
  connect(&scene_, &SceneController::xInputChanged, this, &CurvesPanel::showAxes);
  connect(&scene_, &SceneController::termsChanged, this, &CurvesPanel::showTerms);
  connect(&scene_, &SceneController::curvesChanged, draw_curves_, &Refresh::request);
  connect(&scene_, &SceneController::readingChanged, draw_reading_, &Refresh::request);
}

void CurvesPanel::adoptModel() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  title_->setText(tr("%1 along").arg(labelOf(model.output)));

  const QSignalBlocker no_signal(x_input_);
  x_input_->clear();
  for (const fuzzy::Variable& input : model.inputs) x_input_->addItem(labelOf(input));

  const std::vector<FigurePreset> presets = figurePresets(model);
  presets_->menu()->clear();
  for (const FigurePreset& preset : presets) {
    QAction* action = presets_->menu()->addAction(presetText(model, preset));
    connect(action, &QAction::triggered, &scene_, [this, preset] { scene_.applyPreset(preset); });
  }
  presets_->setVisible(!presets.empty());

  showAxes();
  draw_curves_->request();
  draw_reading_->request();
}

void CurvesPanel::showAxes() {
  const QSignalBlocker no_signal(x_input_);
  x_input_->setCurrentIndex(static_cast<int>(scene_.xInput()));
  const fuzzy::ForceModel& model = scene_.model()->model;
  plot_->setAxes(scene_.xVariable(), model.output, model.experts);
  showTerms();
}

void CurvesPanel::showTerms() { plot_->setTerms(scene_.xVariable(), scene_.terms(scene_.xVariable())); }

void CurvesPanel::onXInputChosen(int index) { scene_.setXInput(static_cast<std::size_t>(index)); }

void CurvesPanel::onRowShown(int row, bool shown) {
  if (row == ReadingModel::kMeanRow) {
    plot_->setMeanShown(shown);
  } else {
    plot_->setExpertShown(static_cast<std::size_t>(row) - 1, shown);
  }
  draw_reading_->request();
}

PlotTable CurvesPanel::table() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const ForceCurves& curves = scene_.curves();
  // Hidden, the plot has followed nothing.
  plot_->setCurves(curves);
  const std::size_t axes[] = {scene_.xInput()};
  PlotTable out = captionedTable(scene_, tr("%1 along %2").arg(labelOf(model.output), labelOf(scene_.xVariable())),
                                 axes, {}, QStringLiteral("-curves"));
  out.columns = {columnName(scene_.xVariable())};
  if (plot_->isMeanShown()) out.columns.push_back(columnName(model.output));
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    if (plot_->isExpertShown(i)) out.columns.push_back(columnName(model.output, model.experts[i]));
  }
  for (std::size_t row = 0; row < curves.x.size(); ++row) {
    std::vector<PlotTable::Cell> cells{curves.x[row]};
    if (plot_->isMeanShown()) cells.push_back(forceCell(curves.mean[row]));
    for (std::size_t i = 0; i < model.experts.size(); ++i) {
      if (plot_->isExpertShown(i)) cells.push_back(forceCell(curves.experts[i][row]));
    }
    out.rows.push_back(std::move(cells));
  }
  return out;
}

}  // namespace tactus::workbench
