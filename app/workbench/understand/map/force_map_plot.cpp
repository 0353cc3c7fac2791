#include "app/workbench/understand/map/force_map_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/axis_zoom.h"
#include "app/workbench/plot/landmark_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_labels.h"
#include "app/workbench/understand/map/contour_lines.h"
#include "app/workbench/understand/map/force_colors.h"
#include "app/workbench/understand/map/map_marks.h"

namespace tactus::workbench {
namespace {

constexpr int kRoomy = 360;      // px: below this height the map needs the room of the landmarks' names
constexpr int kLow = 240;        // px: below this height the boxes above the map alone name its axes
constexpr int kBeside = 2;       // px from the map or its landmarks to the bars of the terms
constexpr int kBeforeScale = 4;  // px from the names of the terms to the color scale

QCPColorGradient forceColors() {
  constexpr std::size_t kStops = 16;
  QCPColorGradient gradient;
  gradient.clearColorStops();
  for (std::size_t i = 0; i < kStops; ++i) {
    const double share = static_cast<double>(i) / (kStops - 1);
    gradient.setColorStopAt(share, forceColor(share));
  }
  gradient.setNanHandling(QCPColorGradient::nhTransparent);
  return gradient;
}

}  // namespace

ForceMapPlot::ForceMapPlot(ShownRanges& ranges, QWidget* parent)
    : QWidget(parent), plot_(makePlot(this)), zoom_(new AxisZoom(*plot_, ranges)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);
  setMinimumSize(260, 180);
  setAccessibleName(tr("Force over two inputs as a map"));

  colors_ = new QCPColorMap(plot_->xAxis, plot_->yAxis);
  scale_ = new QCPColorScale(plot_);
  scale_->setBarWidth(2 * theme::kGrid);
  plot_->plotLayout()->addElement(0, 1, scale_);
  colors_->setColorScale(scale_);
  colors_->setGradient(forceColors());
  auto* margins = new QCPMarginGroup(plot_);
  plot_->axisRect()->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
  scale_->setMarginGroup(QCP::msTop | QCP::msBottom, margins);
  plot_->axisRect()->setBackground(silentGround());

  contours_ = new ContourMarks(*plot_);
  landmarks_ = new LandmarkMarks(*plot_, LandmarkMarks::Place::kAbove);
  y_landmarks_ = new LandmarkMarks(*plot_, LandmarkMarks::Place::kBeside);
  x_terms_ = new TermLabels(*plot_, 1);
  y_terms_ = new TermLabels(*plot_, 1, TermLabels::Side::kRight);
  for (TermLabels* terms : {x_terms_, y_terms_}) terms->setBars(true);
  cross_ = new MapCross(*plot_);
  connect(plot_, &QCustomPlot::mousePress, this, &ForceMapPlot::onMouse);
  connect(plot_, &QCustomPlot::mouseMove, this, &ForceMapPlot::onMouse);
}

void ForceMapPlot::setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) {
  x_ = x;
  y_ = y;
  styleAxis(*plot_->xAxis, x);
  styleAxis(*plot_->yAxis, y);
  zoom_->setInputs(x, y);
  styleAxis(*scale_->axis(), output);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) axis->grid()->setVisible(false);
  output_ = output;
  scale_->setDataRange(QCPRange(output.min, output.max));
  landmarks_->setVariable(x);
  y_landmarks_->setVariable(y);
  setToolTip(landmarks_->explanation() + y_landmarks_->explanation());
  makeRoom(height());
  setMap(nullptr);
}

void ForceMapPlot::setTerms(const std::vector<fuzzy::Term>& x, const std::vector<fuzzy::Term>& y) {
  constexpr std::size_t kInOneRow = 3;
  x_terms_->setRows(x.size() > kInOneRow ? 2 : 1);
  y_terms_->setRows(y.size() > kInOneRow ? 2 : 1);
  x_terms_->setTerms(x_, x);
  y_terms_->setTerms(y_, y);
  makeRoom(height());
  redraw(*plot_);
}

// From the plot outward: landmarks, bars of the terms, their names.
void ForceMapPlot::makeRoom(int height) {
  using Text = LandmarkMarks::Text;
  const bool low = height < kLow;
  landmarks_->setText(height >= kRoomy ? Text::kNames : low ? Text::kNone : Text::kNumbers);
  plot_->xAxis->setLabel(low ? QString() : axisText(x_));
  plot_->yAxis->setLabel(low ? unitText(y_.unit) : axisText(y_));
  scale_->axis()->setLabel(low ? unitText(output_.unit) : axisText(output_));
  x_terms_->setDistance(landmarks_->height() + kBeside);
  y_terms_->setDistance(kBeside);
  plot_->axisRect()->setMinimumMargins(
      QMargins(0, landmarks_->height() + kBeside + x_terms_->height(), kBeside + y_terms_->height() + kBeforeScale, 0));
}

void ForceMapPlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  makeRoom(height());
}

void ForceMapPlot::setMap(const ForceMap* map) {
  if (!map) {
    colors_->data()->clear();
    contours_->set({});
    redraw(*plot_);
    return;
  }
  const int side = static_cast<int>(map->side);
  QCPColorMapData* cells = colors_->data();
  cells->setSize(side, side);
  cells->setRange(QCPRange(map->x_part.low, map->x_part.high), QCPRange(map->y_part.low, map->y_part.high));
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto column = static_cast<std::size_t>(x);
      const auto row = static_cast<std::size_t>(y);
      cells->setCell(x, y,
                     map->isFired(column, row) ? map->force(column, row) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  const double step_x = (map->x_part.high - map->x_part.low) / (side - 1);
  const double step_y = (map->y_part.high - map->y_part.low) / (side - 1);
  std::vector<ContourMarks::Line> lines;
  const QCPRange range = scale_->dataRange();
  const std::vector<double> levels = contourLevels(range.lower, range.upper);
  std::vector<std::vector<QLineF>> pieces = contourLines(*map, levels);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    ContourMarks::Line line{numberText(levels[i]), forceColor((levels[i] - range.lower) / range.size()),
                            std::move(pieces[i])};
    for (QLineF& piece : line.pieces) {
      piece.setLine(map->x_part.low + piece.x1() * step_x, map->y_part.low + piece.y1() * step_y,
                    map->x_part.low + piece.x2() * step_x, map->y_part.low + piece.y2() * step_y);
    }
    lines.push_back(std::move(line));
  }
  // While the map is coarse its lines still move.
  contours_->set(std::move(lines), map->side == ForceMapController::kSides.back());
  redraw(*plot_);
}

void ForceMapPlot::setPoint(double x, double y, std::optional<double> /*force_n*/, const QString& tag) {
  cross_->set(x, y, tag);
  redraw(*plot_);
}

void ForceMapPlot::paintPicture(QCPPainter& painter, const QSize& size) {
  makeRoom(size.height());
  paintPlot(*plot_, painter, size, {cross_});
  makeRoom(height());
}

void ForceMapPlot::onMouse(QMouseEvent* event) {
  if (!event->buttons().testFlag(Qt::LeftButton)) return;
  if (event->type() == QEvent::MouseButtonPress && !plot_->axisRect()->rect().contains(event->position().toPoint())) {
    return;
  }
  emit picked(placeOf(x_, plot_->xAxis->pixelToCoord(event->position().x())),
              placeOf(y_, plot_->yAxis->pixelToCoord(event->position().y())));
}

}  // namespace tactus::workbench
