#include <QFontMetricsF>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/map/map_panel.h"
#include "app/workbench/understand/map/surface_mesh.h"

namespace tactus::workbench {
namespace {

constexpr double kDegPerPx = 0.4;
constexpr double kFineDeg = 2;     // of an arrow key
constexpr double kCoarseDeg = 15;  // with Shift
constexpr double kZoomStep = 1.15;
constexpr double kFarthest = 0.7;
constexpr double kNearest = 4;
constexpr std::size_t kPictureCells = 100;  // along each input, of a picture
constexpr double kNotch = 120;              // of a wheel, in the unit of Qt

}  // namespace

SurfacePlot::SurfacePlot(QWidget* parent) : QWidget(parent) {
  setMinimumSize(260, 180);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::OpenHandCursor);
  setAttribute(Qt::WA_OpaquePaintEvent);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  slices_.setInterval(0);
  connect(&rest_, &QTimer::timeout, this, [this] { slices_.start(); });
  connect(&slices_, &QTimer::timeout, this, &SurfacePlot::refine);
}

void SurfacePlot::setAxes(const fuzzy::Variable& x, const fuzzy::Variable& y, const fuzzy::Variable& output) {
  frame_.x = x;
  frame_.y = y;
  frame_.output = output;
  point_.reset();
  setMap(nullptr);
}

void SurfacePlot::setMap(const ForceMap* map) {
  map_ = map ? std::optional(*map) : std::nullopt;
  if (map) {
    // The box is that of the part.
    std::tie(frame_.x.min, frame_.x.max) = std::pair(map->x_part.low, map->x_part.high);
    std::tie(frame_.y.min, frame_.y.max) = std::pair(map->y_part.low, map->y_part.high);
  }
  meshes_.clear();
  changed();
}

void SurfacePlot::setPoint(double x, double y, std::optional<double> force_n, const QString& tag) {
  Point point{x, y, {}, tag};
  if (force_n) point.height = std::clamp(shareOf(frame_.output, *force_n), 0.0, 1.0);
  point_ = std::move(point);
  update();
}

void SurfacePlot::setLook(const SurfaceLook& look) {
  if (look == frame_.look) return;
  frame_.look = look;
  changed();
}

void SurfacePlot::paintPicture(QCPPainter& painter, const QSize& size) {
  SurfaceFrame frame = frame_;
  frame.size = size;
  // Half as fine as the map: a vector file holds every cell, and the difference is not visible.
  const std::size_t stride = map_ && map_->side - 1 > kPictureCells ? 2 : 1;
  paintSurface(painter, frame, map_ ? mesh(stride) : nullptr, SurfacePainting::Quality::kSmooth);
}

void SurfacePlot::paintEvent(QPaintEvent* /*event*/) {
  if (stale_ || picture_.devicePixelRatio() != devicePixelRatioF()) paintQuick();
  QPainter painter(this);
  painter.drawImage(QPointF(0, 0), picture_);
  painter.setRenderHint(QPainter::Antialiasing);
  paintPoint(painter);
  if (hasFocus()) {
    painter.setPen(QPen(theme::accent(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  }
}

void SurfacePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  frame_.size = size();
  changed();
}

void SurfacePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) changed();
}

void SurfacePlot::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  // A hidden surface is not refined; refinement restarts when it is shown.
  rest_.stop();
  slices_.stop();
  stale_ = stale_ || !rested_;
}

void SurfacePlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  grabbed_ = event->position();
  setCursor(Qt::ClosedHandCursor);
}

void SurfacePlot::mouseMoveEvent(QMouseEvent* event) {
  if (!grabbed_) return;
  const QPointF moved = event->position() - *std::exchange(grabbed_, event->position());
  turn(moved.x() * kDegPerPx, moved.y() * kDegPerPx);
}

void SurfacePlot::mouseReleaseEvent(QMouseEvent* /*event*/) {
  grabbed_.reset();
  setCursor(Qt::OpenHandCursor);
}

void SurfacePlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) setLook({});
}

void SurfacePlot::wheelEvent(QWheelEvent* event) {
  zoomBy(std::pow(kZoomStep, event->angleDelta().y() / kNotch), event->position());
  event->accept();
}

void SurfacePlot::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? kCoarseDeg : kFineDeg;
  switch (event->key()) {
    case Qt::Key_Left: return turn(-step, 0);
    case Qt::Key_Right: return turn(step, 0);
    case Qt::Key_Up: return turn(0, -step);
    case Qt::Key_Down: return turn(0, step);
    case Qt::Key_Plus:
    case Qt::Key_Equal: return zoomBy(kZoomStep, frame_.boxArea().center());
    case Qt::Key_Minus: return zoomBy(1 / kZoomStep, frame_.boxArea().center());
    case Qt::Key_Home: return setLook({});
    default: QWidget::keyPressEvent(event);
  }
}

void SurfacePlot::changed() {
  stale_ = true;
  rested_ = false;
  finest_.reset();
  slices_.stop();
  if (!isVisible()) return;
  rest_.start();
  update();
}

void SurfacePlot::paintQuick() {
  const double ratio = devicePixelRatioF();
  const QSize pixels = (QSizeF(size()) * ratio).toSize();
  if (picture_.size() != pixels) picture_ = QImage(pixels, QImage::Format_RGB32);
  picture_.setDevicePixelRatio(ratio);
  const std::size_t stride = map_ ? quickStride() : 0;
  const std::shared_ptr<const SurfaceMesh> quick = map_ ? mesh(stride) : nullptr;
  QPainter painter(&picture_);
  const double mesh_ns = paintSurface(painter, frame_, quick, SurfacePainting::Quality::kQuick);
  cells_shown_ = quick ? quick->cells() : 0;
  // A slow moving mean, so that one late frame does not make the next ones coarse.
  if (quick) cell_ns_ += 0.2 * (mesh_ns / static_cast<double>(cells_shown_ * cells_shown_) - cell_ns_);
  stale_ = false;
  // A new screen can bring a picture here without `changed`.
  if (!rest_.isActive() && !slices_.isActive()) rest_.start();
}

void SurfacePlot::refine() {
  if (!map_) {
    slices_.stop();
    rested_ = true;
    return;
  }
  if (!finest_) finest_ = std::make_unique<SurfaceImage>(frame_, mesh(1), devicePixelRatioF());
  finest_->work(kSliceMs);
  if (!finest_->isDone()) return;
  slices_.stop();
  picture_ = finest_->image();
  finest_.reset();
  cells_shown_ = mesh(1)->cells();
  rested_ = true;
  update();
}

void SurfacePlot::turn(double right_deg, double down_deg) {
  SurfaceLook look = frame_.look;
  // What is dragged to the right goes to the right: the viewer goes to the left.
  look.angles.azimuth_deg = std::remainder(look.angles.azimuth_deg - right_deg, 360);
  look.angles.elevation_deg = std::clamp(look.angles.elevation_deg + down_deg, -90.0, 90.0);
  setLook(look);
}

void SurfacePlot::zoomBy(double factor, QPointF around) {
  SurfaceLook look = frame_.look;
  look.zoom = std::clamp(look.zoom * factor, kFarthest, kNearest);
  // What is under the mouse stays there, as long as the middle of the box stays in the picture.
  const QRectF area = frame_.boxArea();
  const QPointF from_middle = around - area.center();
  const QPointF shift = from_middle - (from_middle - look.shift) * (look.zoom / frame_.look.zoom);
  look.shift = {std::clamp(shift.x(), -area.width() / 2, area.width() / 2),
                std::clamp(shift.y(), -area.height() / 2, area.height() / 2)};
  if (look.zoom <= 1) look.shift = {};
  setLook(look);
}

std::size_t SurfacePlot::quickStride() const {
  const std::size_t cells = map_->side - 1;
  std::size_t stride = 1;
  const auto fits = [&] {
    return static_cast<double>((cells / stride) * (cells / stride)) * cell_ns_ <= kQuickMs * 1e6;
  };
  while (!fits() && cells % (2 * stride) == 0) stride *= 2;
  return stride;
}

std::shared_ptr<const SurfaceMesh> SurfacePlot::mesh(std::size_t stride) {
  for (const auto& [known, mesh] : meshes_) {
    if (known == stride) return mesh;
  }
  auto made = std::make_shared<SurfaceMesh>(*map_, frame_.output.min, frame_.output.max, stride);
  meshes_.emplace_back(stride, made);
  return made;
}

void SurfacePlot::paintPoint(QPainter& painter) {
  if (!point_ || !map_) return;
  const double x = shareOf(frame_.x, point_->x);
  const double y = shareOf(frame_.y, point_->y);
  // Beside the part that is shown.
  if (x < 0 || x > 1 || y < 0 || y > 1) return;
  const SurfaceProjection seen = frame_.projection();
  const SurfaceMesh& ground = *mesh(quickStride());
  QColor white = Qt::white;
  white.setAlphaF(0.9F);
  const auto twice = [&](const auto& draw) {
    for (const QPen& pen : {QPen(theme::accent(), 2.6), QPen(white, 1)}) {
      painter.setPen(pen);
      draw();
    }
  };
  painter.save();
  painter.setClipRect(frame_.textArea());
  painter.setBrush(Qt::NoBrush);
  std::vector<QPolygonF> lines;
  for (const auto& run : visibleSections(ground, x, y, seen.toViewer())) {
    QPolygonF& line = lines.emplace_back();
    for (const BoxPoint& place : run) line << seen(place);
  }
  twice([&] {
    for (const QPolygonF& line : lines) painter.drawPolyline(line);
  });

  // Down to the floor, and from there to the edges with the numbers.
  const BoxPoint foot{x, y, 0};
  const BoxPoint top{x, y, point_->height.value_or(0)};
  painter.setPen(QPen(theme::accent(), 1.2, Qt::DashLine));
  painter.drawLine(seen(foot), seen(top));
  const BoxPoint far = farCorner(seen);
  painter.setPen(QPen(theme::accent(), 1, Qt::DotLine));
  painter.drawLine(seen(foot), seen({x, 1 - far.y, 0}));
  painter.drawLine(seen(foot), seen({1 - far.x, y, 0}));

  const bool hidden = point_->height && isCovered(ground, top, seen.toViewer());
  painter.setPen(QPen(hidden || !point_->height ? theme::accent() : QColor(Qt::white), 1.5));
  painter.setBrush(hidden || !point_->height ? QColor(255, 255, 255, 150) : theme::accent());
  painter.drawEllipse(seen(top), 4.5, 4.5);
  painter.restore();

  const QFont font = theme::smallFont();
  const QFontMetricsF metrics(font);
  const QSizeF size(metrics.horizontalAdvance(point_->tag) + 12, metrics.height() + 6);
  const QRectF room = frame_.textArea();
  const QPointF at = seen(top);
  const double left = std::clamp(at.x() + 10 + size.width() <= room.right() ? at.x() + 10 : at.x() - 10 - size.width(),
                                 room.left(), std::max(room.left(), room.right() - size.width()));
  const double upper = std::clamp(at.y() - 10 - size.height(), room.top(), room.bottom() - size.height());
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::accent());
  painter.drawRoundedRect(QRectF({left, upper}, size), 4, 4);
  painter.setPen(Qt::white);
  painter.setFont(font);
  painter.drawText(QPointF(left + 6, upper + size.height() - 3 - metrics.descent()), point_->tag);
}

namespace {

QWidget* hint() {
  auto* label = new ElidedLabel;
  label->setFont(theme::smallFont());
  label->setFullText(SurfacePanel::tr(
      "Drag or arrow keys turn, with Shift farther; the wheel zooms; double click or Home: standard view."));
  return label;
}

}  // namespace

SurfacePanel::SurfacePanel(const SceneController& scene, ForceMapController& map, QWidget* parent)
    : SurfacePanel(scene, map, new SurfacePlot, parent) {}

SurfacePanel::SurfacePanel(const SceneController& scene, ForceMapController& map, SurfacePlot* plot, QWidget* parent)
    : MapViewPanel(scene, map,
                   {plot, plot, hint(), tr("A surface needs a model with two inputs."), QStringLiteral("-surface")},
                   parent) {
  plot->setAccessibleName(tr("Force over two inputs as a surface"));
}

}  // namespace tactus::workbench
