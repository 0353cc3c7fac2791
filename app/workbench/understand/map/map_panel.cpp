#include "app/workbench/understand/map/map_panel.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/refresh.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/plot/axis_zoom.h"
#include "app/workbench/plot/label_board.h"
#include "app/workbench/plot/landmark_marks.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_view_panel.h"

namespace tactus::workbench {
namespace {

constexpr double kSquare = 8;  // px, of the grid in which lines and numbers are kept apart

}  // namespace

ContourMarks::ContourMarks(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("main")) {}

void ContourMarks::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void ContourMarks::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QCPAxis* bottom = area->axis(QCPAxis::atBottom);
  const QCPAxis* left = area->axis(QCPAxis::atLeft);
  QColor color = Qt::white;  // on the colors of the map, whatever the theme
  color.setAlphaF(0.65F);
  painter->setPen(QPen(color, 1));
  std::vector<QVector<QLineF>> all;
  for (const Line& line : lines_) {
    QVector<QLineF>& pieces = all.emplace_back();
    pieces.reserve(static_cast<qsizetype>(line.pieces.size()));
    for (const QLineF& piece : line.pieces) {
      pieces << QLineF(bottom->coordToPixel(piece.x1()), left->coordToPixel(piece.y1()),
                       bottom->coordToPixel(piece.x2()), left->coordToPixel(piece.y2()));
    }
    painter->drawLines(pieces);
  }
  if (labelled_) drawLabels(*painter, all);
}

void ContourMarks::drawLabels(QCPPainter& painter, const std::vector<QVector<QLineF>>& pieces) const {
  const QFont font = theme::smallFont();
  const QFontMetricsF metrics(font);
  const QRectF area = mParentPlot->axisRect()->rect();
  // Which lines run through each square of the map, one bit for each.
  const int columns = static_cast<int>(area.width() / kSquare) + 1;
  const int rows = static_cast<int>(area.height() / kSquare) + 1;
  std::vector<std::uint32_t> lines_in(static_cast<std::size_t>(columns * rows), 0);
  const auto square = [&](const QPointF& at) {
    const int column = std::clamp(static_cast<int>((at.x() - area.left()) / kSquare), 0, columns - 1);
    const int row = std::clamp(static_cast<int>((at.y() - area.top()) / kSquare), 0, rows - 1);
    return static_cast<std::size_t>(row * columns + column);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const QLineF& piece : pieces[i]) {
      lines_in[square(piece.p1())] |= 1U << i % 32;
      lines_in[square(piece.p2())] |= 1U << i % 32;
    }
  }
  LabelBoard board(area.adjusted(2, 2, -2, -2));
  painter.setFont(font);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const QSizeF size(metrics.horizontalAdvance(lines_[i].text) + 6, metrics.height());
    const qsizetype count = pieces[i].size();
    // From the middle of the line outward.
    for (qsizetype step = 0; step < count; ++step) {
      const QPointF at = pieces[i][(count / 2 + (step % 2 == 0 ? step / 2 : count - 1 - step / 2)) % count].center();
      std::uint32_t lines = 0;
      for (double y = -size.height() / 2; y <= size.height() / 2; y += size.height() / 2) {
        for (double x = -size.width() / 2; x <= size.width() / 2; x += size.width() / 4) {
          lines |= lines_in[square(at + QPointF(x, y))];
        }
      }
      if ((lines & ~(1U << i % 32)) != 0 || !board.place({at, size, 0})) continue;
      const QRectF box(at - QPointF(size.width() / 2, size.height() / 2), size);
      painter.setPen(Qt::NoPen);
      painter.setBrush(lines_[i].ground);
      painter.drawRoundedRect(box, 3, 3);
      painter.setPen(Qt::white);
      painter.drawText(box, Qt::AlignCenter, lines_[i].text);
      break;
    }
  }
}

// The overlay has a buffer of its own, so the cross moves without drawing the map again.
MapCross::MapCross(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")), font_(theme::smallFont()) {}

void MapCross::set(double x, double y, QString tag) {
  x_ = x;
  y_ = y;
  tag_ = std::move(tag);
}

void MapCross::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void MapCross::draw(QCPPainter* painter) {
  const QCPAxisRect* area = mParentPlot->axisRect();
  const QPointF place(area->axis(QCPAxis::atBottom)->coordToPixel(x_), area->axis(QCPAxis::atLeft)->coordToPixel(y_));
  QColor line = Qt::white;
  line.setAlphaF(0.9F);
  for (const QPen& pen : {QPen(theme::accent(), 2.6), QPen(line, 1)}) {
    painter->setPen(pen);
    painter->drawLine(QLineF(place.x(), area->top(), place.x(), area->bottom()));
    painter->drawLine(QLineF(area->left(), place.y(), area->right(), place.y()));
  }
  painter->setPen(QPen(Qt::white, 1.5));
  painter->setBrush(theme::accent());
  painter->drawEllipse(place, 4.5, 4.5);

  const QFontMetricsF metrics(font_);
  const double width = metrics.horizontalAdvance(tag_) + 12;
  const double height = metrics.height() + 6;
  // In a narrow map neither side has room; the names of the axis stay readable.
  const double left =
      place.x() + 8 + width <= area->right() ? place.x() + 8 : std::max<double>(area->left(), place.x() - 8 - width);
  const double top = place.y() - 8 - height >= area->top() ? place.y() - 8 - height : place.y() + 8;
  painter->setPen(Qt::NoPen);
  painter->setBrush(theme::accent());
  painter->drawRoundedRect(QRectF(left, top, width, height), 4, 4);
  painter->setPen(Qt::white);
  painter->setFont(font_);
  painter->drawText(QPointF(left + 6, top + height - 3 - metrics.descent()), tag_);
}

namespace {

constexpr int kRoomy = 360;      // px: below this height the map needs the room of the landmarks' names
constexpr int kLowMap = 240;     // px: below this height the boxes above the map alone name its axes
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
  makeColumn(this, {plot_});
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
  const bool low = height < kLowMap;
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
  // All colors for the forces that are there: between the least and the largest one.
  double least_n = output_.max;
  double largest_n = output_.min;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto column = static_cast<std::size_t>(x);
      const auto row = static_cast<std::size_t>(y);
      const bool fired = map->isFired(column, row);
      const double force = fired ? map->force(column, row) : std::numeric_limits<double>::quiet_NaN();
      if (fired) {
        least_n = std::min(least_n, force);
        largest_n = std::max(largest_n, force);
      }
      cells->setCell(x, y, force);
    }
  }
  const bool differ = largest_n > least_n;
  scale_->setDataRange(differ ? QCPRange(least_n, largest_n) : QCPRange(output_.min, output_.max));
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

MapPanel::MapPanel(SceneController& scene, ForceMapController& map, QWidget* parent)
    : MapPanel(scene, map, new ForceMapPlot(scene.ranges()), parent) {}

MapPanel::MapPanel(SceneController& scene, ForceMapController& map, ForceMapPlot* plot, QWidget* parent)
    : MapViewPanel(scene, map,
                   {plot, plot, nullptr, tr("A map needs a model with two inputs."), QStringLiteral("-map")}, parent),
      scene_(scene),
      map_(map),
      plot_(plot) {
  connect(plot, &ForceMapPlot::picked, this, [&scene, &map](double x, double y) {
    scene.setValue(map.xInput(), x);
    scene.setValue(map.yInput(), y);
  });
  auto* terms = new Refresh(this, [this] { showTerms(); });
  connect(&map, &ForceMapController::choiceChanged, terms, &Refresh::request);
  connect(&scene, &SceneController::modelChanged, terms, &Refresh::request);
  connect(&scene, &SceneController::termsChanged, terms, &Refresh::request);
}

void MapPanel::catchUp() {
  showTerms();
  MapViewPanel::catchUp();
}

void MapPanel::showTerms() {
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  plot_->setTerms(scene_.terms(inputs[map_.xInput()]), scene_.terms(inputs[map_.yInput()]));
}

}  // namespace tactus::workbench
