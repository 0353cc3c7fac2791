#include "app/workbench/views/curves_panel.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSignalBlocker>
#include <QUrl>
#include <QVBoxLayout>
#include <utility>

#include "app/workbench/controllers/force_spread.h"
#include "app/workbench/controllers/ghost_controller.h"
#include "app/workbench/controllers/plot_caption.h"
#include "app/workbench/controllers/reference_controller.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/display_text.h"
#include "app/workbench/models/reading_model.h"
#include "app/workbench/plots/curve_looks.h"
#include "app/workbench/plots/curve_plot.h"
#include "app/workbench/refresh.h"
#include "app/workbench/theme.h"
#include "app/workbench/views/curve_legend.h"
#include "app/workbench/views/elided_label.h"
#include "app/workbench/views/plot_menu.h"
#include "app/workbench/views/reference_bar.h"
#include "app/workbench/views/say.h"

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

constexpr std::size_t kMostChips = 8;  // experts with a name of their own in the legend

// The one table that is dragged, or an empty path.
QString draggedTable(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() != 1 || !urls.first().isLocalFile()) return {};
  const QString path = urls.first().toLocalFile();
  return path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive) ? path : QString();
}

}  // namespace

CurvesPanel::CurvesPanel(SceneController& scene, ReadingModel& readings, QWidget* parent)
    : Card(parent),
      scene_(scene),
      readings_(readings),
      title_(new QLabel(this)),
      x_input_(new QComboBox(this)),
      presets_(new QPushButton(tr("Figures"), this)),
      plot_(new CurvePlot(this)),
      menu_(new PlotMenu(
          *plot_, [this] { return table(); }, this)),
      legend_(new CurveLegend(this)),
      ghost_chip_(new LegendChip(ghostLook(tr("Before the last edit")), {}, this)),
      difference_(new ElidedLabel(this)),
      draw_curves_(new Refresh(this, [this] { drawCurves(); })),
      draw_ghost_(new Refresh(this, [this] { drawGhost(); })),
      draw_references_(new Refresh(this, [this] { drawReferences(); })),
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

  difference_->setFont(theme::smallFont());
  ghost_chip_->setChecked(true);

  auto* head = new QHBoxLayout;
  head->setSpacing(theme::kGrid);
  head->addWidget(title_);
  head->addWidget(x_input_);
  head->addStretch(1);
  head->addWidget(presets_);
  head->addWidget(menu_);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(theme::kGrid + 4, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid / 2);
  legend_->setTail({ghost_chip_, difference_});
  layout->addLayout(head);
  layout->addWidget(legend_);
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

void CurvesPanel::setGhost(GhostController& ghost) {
  ghost_ = &ghost;
  connect(ghost_chip_, &LegendChip::toggled, ghost_, &GhostController::setOn);
  connect(ghost_, &GhostController::changed, draw_ghost_, &Refresh::request);
  connect(&scene_, &SceneController::curvesChanged, draw_ghost_, &Refresh::request);
  draw_ghost_->request();
}

void CurvesPanel::setReferences(ReferenceController& references) {
  references_ = &references;
  reference_bar_ = new ReferenceBar(references, scene_, this);
  static_cast<QVBoxLayout*>(layout())->addWidget(reference_bar_);
  setAcceptDrops(true);
  connect(references_, &ReferenceController::changed, draw_references_, &Refresh::request);
  connect(references_, &ReferenceController::refused, this,
          [this](const QString& sentence) { sayError(*this, sentence); });
}

void CurvesPanel::setFast(bool fast) { plot_->setFast(fast); }

void CurvesPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedTable(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void CurvesPanel::dropEvent(QDropEvent* event) {
  const QString path = draggedTable(*event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  references_->open(path);
}

void CurvesPanel::drawCurves() {
  plot_->setCurves(scene_.curves());
  if (reference_bar_) reference_bar_->showDifferences();
}

void CurvesPanel::drawGhost() {
  const bool any = ghost_ && (ghost_->before() || !ghost_->isOn());
  plot_->setGhost(ghost_ ? ghost_->curves() : nullptr, ghost_ ? ghost_->label() : QString());
  ghost_chip_->setEnabled(any);
  if (!ghost_) return;
  ghost_chip_->setName(ghost_->label());
  ghost_chip_->setToolTip(ghost_->whatChanged().isEmpty() ? tr("Show the curves before an edit as dashed lines")
                                                          : tr("Since then: %1").arg(ghost_->whatChanged()));
  difference_->setFullText(any ? ghost_->differenceText() : tr("nothing is edited yet"));
}

void CurvesPanel::drawReferences() {
  plot_->setReferences(references_ ? references_->shown() : std::vector<ReferenceCurve>());
  if (reference_bar_) reference_bar_->showDifferences();
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
  showLines();
  showLegend();
  showTerms();
  draw_ghost_->request();
  draw_references_->request();
}

// Another axis brings new lines, and what was hidden stays hidden.
void CurvesPanel::showLines() {
  for (int row = 0; row < readings_.rowCount(); ++row) {
    const bool shown = readings_.isShown(row);
    if (row == ReadingModel::kMeanRow) {
      plot_->setMeanShown(shown);
    } else {
      plot_->setExpertShown(static_cast<std::size_t>(row) - 1, shown);
    }
  }
}

void CurvesPanel::showLegend() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const std::size_t experts = model.experts.size();
  const auto show_rows = [this](int first, int last, bool shown) {
    for (int row = first; row <= last; ++row) {
      readings_.setData(readings_.index(row, ReadingModel::kWho), shown ? Qt::Checked : Qt::Unchecked,
                        Qt::CheckStateRole);
    }
  };
  std::vector<CurveLegend::Item> items;
  items.push_back({plot_->lineOf(std::nullopt), tr("The mean of the experts"),
                   readings_.isShown(ReadingModel::kMeanRow),
                   [show_rows](bool shown) { show_rows(ReadingModel::kMeanRow, ReadingModel::kMeanRow, shown); }});
  if (experts <= kMostChips) {
    for (std::size_t i = 0; i < experts; ++i) {
      const int row = static_cast<int>(i) + 1;
      // The id is short enough for a row of its own; the label is in the tool tip, the table and every picture.
      LegendEntry line = plot_->lineOf(i);
      line.name = text(model.experts[i].id);
      items.push_back({line, tr("Expert %1").arg(labelOf(model.experts[i])), readings_.isShown(row),
                       [show_rows, row](bool shown) { show_rows(row, row, shown); }});
    }
  } else {
    LegendEntry all = plot_->lineOf(0);
    all.name = tr("%1 experts").arg(experts);
    const int last = static_cast<int>(experts);
    items.push_back({all, tr("The lines of all experts; single ones under Forces here"), readings_.isShown(1),
                     [show_rows, last](bool shown) { show_rows(1, last, shown); }});
  }
  const auto redraw = [this](SpreadShown shown) {
    plot_->setSpreadShown(shown);
    draw_curves_->request();
  };
  if (experts >= 2) {
    items.push_back({rangeLook(tr("Range")),
                     tr("From the lowest to the highest force of the experts who have a rule there"),
                     plot_->spreadShown().range, [this, redraw](bool shown) {
                       redraw({shown, plot_->spreadShown().deviation});
                     }});
  }
  if (experts >= kFewestForDeviation) {
    items.push_back({deviationLook(tr("± 1 SD")),
                     tr("Mean ± 1 standard deviation (n − 1) of the %1 experts, where three or more have a rule. "
                        "So few people say little about others; the range says what these said.")
                         .arg(experts),
                     plot_->spreadShown().deviation, [this, redraw](bool shown) {
                       redraw({plot_->spreadShown().range, shown});
                     }});
  }
  legend_->setItems(std::move(items));
}

void CurvesPanel::showTerms() { plot_->setTerms(scene_.xVariable(), scene_.terms(scene_.xVariable())); }

void CurvesPanel::onXInputChosen(int index) { scene_.setXInput(static_cast<std::size_t>(index)); }

void CurvesPanel::onRowShown(int row, bool shown) {
  if (row == ReadingModel::kMeanRow) {
    plot_->setMeanShown(shown);
  } else {
    plot_->setExpertShown(static_cast<std::size_t>(row) - 1, shown);
  }
  showLegend();
  draw_ghost_->request();
  draw_reading_->request();
}

PlotTable CurvesPanel::table() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const ForceCurves& curves = scene_.curves();
  // Hidden, the plot has followed nothing.
  drawCurves();
  drawGhost();
  const std::size_t axes[] = {scene_.xInput()};
  PlotTable out = captionedTable(scene_, tr("%1 along %2").arg(labelOf(model.output), labelOf(scene_.xVariable())),
                                 axes, notes(), QStringLiteral("-curves"));
  out.columns = {columnName(scene_.xVariable())};
  std::vector<const std::vector<fuzzy::Evaluation>*> lines;
  if (plot_->isMeanShown()) {
    out.columns.push_back(columnName(model.output));
    lines.push_back(&curves.mean);
  }
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    if (!plot_->isExpertShown(i)) continue;
    out.columns.push_back(columnName(model.output, model.experts[i]));
    lines.push_back(&curves.experts[i]);
  }
  for (std::size_t row = 0; row < curves.x.size(); ++row) {
    std::vector<PlotTable::Cell> cells{curves.x[row]};
    for (const auto* line : lines) cells.push_back(forceCell((*line)[row]));
    out.rows.push_back(std::move(cells));
  }
  return out;
}

// What is compared with the curves, in words: its numbers have places of their own and stand in no column.
QStringList CurvesPanel::notes() const {
  QStringList out;
  if (ghost_ && ghost_->curves()) {
    const QString since =
        ghost_->whatChanged().isEmpty() ? QString() : tr(" (since then: %1)").arg(ghost_->whatChanged());
    out << tr("Dashed: %1%2, %3").arg(ghost_->label(), since, ghost_->differenceText());
  }
  if (!references_) return out;
  const std::vector<ReferenceCurve> shown = references_->shown();
  const auto& differences = references_->differences();
  const QString against =
      references_->expert() ? labelOf(scene_.model()->model.experts[*references_->expert()]) : tr("the mean");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    out << tr("Reference %1 and %2: %3").arg(shown[i].name, against, references_->differenceText(differences[i]));
  }
  return out;
}

}  // namespace tactus::workbench
