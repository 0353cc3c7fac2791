#include "app/workbench/understand/map/surface_picture.h"

#include <QElapsedTimer>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/plot/label_layout.h"
#include "app/workbench/plot/landmarks.h"
#include "app/workbench/understand/map/map_view_panel.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kCellsPerLook = 64;  // cells between two looks at the clock
constexpr double kSeam = 0.7;              // px, of the outline that closes the hairlines between smooth cells
const QColor kMeshColor(0, 0, 0, 64);      // on the colors of the forces, whatever the theme
const QColor kRimColor(0, 0, 0, 110);      // borders and the rims of holes

}  // namespace

SurfacePainting::SurfacePainting(std::shared_ptr<const SurfaceMesh> mesh, const SurfaceProjection& seen,
                                 Quality quality)
    : mesh_(std::move(mesh)), seen_(seen), quality_(quality), order_(mesh_->cells(), seen.toViewer()) {
  TACTUS_CHECK(mesh_->cells() > 0);
  line_every_ = std::max<std::size_t>(1, mesh_->cells() / kMeshLines);
  nodes_.reserve((mesh_->cells() + 1) * (mesh_->cells() + 1));
  for (std::size_t y = 0; y <= mesh_->cells(); ++y) {
    for (std::size_t x = 0; x <= mesh_->cells(); ++x) nodes_.push_back(seen_(mesh_->node(x, y)));
  }
}

void SurfacePainting::paint(QPainter& painter) { paint(painter, std::numeric_limits<double>::infinity()); }

void SurfacePainting::paint(QPainter& painter, double budget_ms) {
  QElapsedTimer clock;
  clock.start();
  painter.setRenderHint(QPainter::Antialiasing, quality_ == Quality::kSmooth);
  while (!isDone() && static_cast<double>(clock.nsecsElapsed()) < budget_ms * 1e6) {
    const std::size_t end = std::min(next_ + kCellsPerLook, order_.count());
    for (; next_ < end; ++next_) {
      const auto [x, y] = order_.at(next_);
      if (isHole(x, y)) continue;
      paintCell(painter, x, y);
      paintEdges(painter, x, y);
    }
  }
}

void SurfacePainting::paintCell(QPainter& painter, std::size_t x, std::size_t y) const {
  const SurfaceCell& cell = mesh_->cell(x, y);
  const QColor color = litColor(cell.height, figures::brightness(cell.normal, seen_));
  painter.setPen(quality_ == Quality::kSmooth ? QPen(color, kSeam) : QPen(Qt::NoPen));
  painter.setBrush(color);
  const std::array<QPointF, 4> corners = {node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)};
  painter.drawConvexPolygon(corners.data(), 4);
}

// A line between two cells belongs to the nearer one, so that no fill covers half of it.
void SurfacePainting::paintEdges(QPainter& painter, std::size_t x, std::size_t y) const {
  const auto edge = [&](bool far, std::size_t line, bool beside_hole, const QPointF& from, const QPointF& to) {
    if (!beside_hole && (!far || line % line_every_ != 0)) return;
    // Flat ends, because half transparent lines that overlap leave dots.
    painter.setPen(QPen(beside_hole ? kRimColor : kMeshColor, 0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
  };
  const std::size_t last = mesh_->cells() - 1;
  edge(order_.xRises(), x, x == 0 || isHole(x - 1, y), node(x, y), node(x, y + 1));
  edge(!order_.xRises(), x + 1, x == last || isHole(x + 1, y), node(x + 1, y), node(x + 1, y + 1));
  edge(order_.yRises(), y, y == 0 || isHole(x, y - 1), node(x, y), node(x + 1, y));
  edge(!order_.yRises(), y + 1, y == last || isHole(x, y + 1), node(x, y + 1), node(x + 1, y + 1));
}

bool SurfacePainting::isHole(std::size_t x, std::size_t y) const { return mesh_->cell(x, y).hole; }

QRgb litColor(double share, double brightness) {
  static const std::array<QRgb, 256> kColors = [] {
    std::array<QRgb, 256> colors{};
    for (std::size_t i = 0; i < colors.size(); ++i) colors[i] = forceColor(static_cast<double>(i) / 255).rgb();
    return colors;
  }();
  const QRgb color = kColors[static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255))];
  const auto lit = [brightness](int channel) {
    return std::min(255, static_cast<int>(std::lround(channel * brightness)));
  };
  return qRgb(lit(qRed(color)), lit(qGreen(color)), lit(qBlue(color)));
}

namespace {

constexpr int kScaleWidth = 2 * theme::kGrid;  // px, as that of the map
constexpr int kScaleTicks = 5;

double line() { return QFontMetricsF(theme::smallFont()).height(); }

// Room for numbers and the name beside an axis, px.
double axisRoom() { return 2 * line() + 2 * theme::kGrid; }

double scaleRoom(const fuzzy::Variable& output) {
  const QFontMetricsF metrics(theme::smallFont());
  double numbers = 0;
  for (const double tick : universeTicks(output.min, output.max, kScaleTicks)) {
    numbers = std::max(numbers, metrics.horizontalAdvance(numberText(tick, 4)));
  }
  return kScaleWidth + 8 + numbers + 4 + line();
}

void drawText(QPainter& painter, const SurfaceText& text) {
  painter.save();
  painter.translate(text.box.middle);
  painter.rotate(text.box.angle_deg);
  const QSizeF size = text.box.size;
  painter.drawText(QRectF(-size.width() / 2 - 1, -size.height() / 2, size.width() + 2, size.height()), Qt::AlignCenter,
                   text.text);
  painter.restore();
}

// Runs of holes along x, as wide as they go, so that few polygons are painted.
void paintHoles(QPainter& painter, const SurfaceProjection& seen, const SurfaceMesh& mesh) {
  const double floor = farCorner(seen).z;
  const auto cells = static_cast<double>(mesh.cells());
  painter.setPen(Qt::NoPen);
  painter.setBrush(silentGround());
  for (std::size_t y = 0; y < mesh.cells(); ++y) {
    const double low = static_cast<double>(y) / cells;
    const double high = static_cast<double>(y + 1) / cells;
    for (std::size_t x = 0; x < mesh.cells(); ++x) {
      if (!mesh.cell(x, y).hole) continue;
      const double from = static_cast<double>(x) / cells;
      while (x < mesh.cells() && mesh.cell(x, y).hole) ++x;
      const double to = static_cast<double>(x) / cells;
      const std::array<QPointF, 4> corners = {seen({from, low, floor}), seen({to, low, floor}), seen({to, high, floor}),
                                              seen({from, high, floor})};
      painter.drawConvexPolygon(corners.data(), 4);
    }
  }
}

void paintScale(QPainter& painter, const SurfaceFrame& frame) {
  const QRectF area = frame.scaleArea();
  const QRectF bar(area.left(), area.top(), kScaleWidth, area.height());
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  constexpr int kStops = 16;
  for (int i = 0; i < kStops; ++i) {
    const double share = static_cast<double>(i) / (kStops - 1);
    gradient.setColorAt(share, forceColor(share));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(gradient);
  painter.drawRect(bar);

  const fuzzy::Variable& output = frame.output;
  const QFontMetricsF metrics(theme::smallFont());
  painter.setFont(theme::smallFont());
  painter.setPen(theme::mutedInk());
  for (const double tick : universeTicks(output.min, output.max, kScaleTicks)) {
    const double y = bar.bottom() - (tick - output.min) / (output.max - output.min) * bar.height();
    painter.drawLine(QLineF(bar.right(), y, bar.right() + 4, y));
    painter.drawText(QPointF(bar.right() + 8, y + (metrics.ascent() - metrics.descent()) / 2), numberText(tick, 4));
  }
  const QString name = axisText(output);
  drawText(painter,
           {name, {{area.right() - line() / 2, area.center().y()}, {metrics.horizontalAdvance(name), line()}, 90}});
}

// Ground, walls and, hatched on the floor, the holes: what lies behind the mesh.
void paintBehind(QPainter& painter, const SurfaceFrame& frame, const SurfaceAxes& axes, const SurfaceMesh* mesh) {
  painter.fillRect(QRectF({0, 0}, frame.size), theme::card());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::window());
  for (const QPolygonF& wall : axes.walls) painter.drawPolygon(wall);
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (mesh) paintHoles(painter, frame.projection(), *mesh);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::grid(), 1));
  painter.drawLines(axes.grid);
  painter.setPen(QPen(theme::border(), 1));
  painter.drawLines(axes.edges);
}

// Axes, landmarks and color scale: what lies beside it.
void paintBeside(QPainter& painter, const SurfaceFrame& frame, const SurfaceAxes& axes) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme::mutedInk());
  for (const QPolygonF& bar : axes.landmark_bars) painter.drawConvexPolygon(bar);
  painter.setPen(QPen(theme::mutedInk(), 0.8));
  painter.drawLines(axes.landmark_leads);
  painter.setPen(QPen(theme::mutedInk(), 1));
  painter.drawLines(axes.axis_lines);
  painter.setFont(theme::smallFont());
  for (const SurfaceText& number : axes.numbers) drawText(painter, number);
  for (const SurfaceText& name : axes.names) drawText(painter, name);
  QFont italic = theme::smallFont();
  italic.setItalic(true);
  painter.setFont(italic);
  for (const SurfaceText& landmark : axes.landmarks) drawText(painter, landmark);
  paintScale(painter, frame);
}

}  // namespace

QRectF SurfaceFrame::boxArea() const {
  const bool landmarks = !landmarksFor(x).empty() || !landmarksFor(y).empty();
  const double top = landmarks ? 3 * line() : theme::kGrid;
  const QRectF area = textArea().adjusted(axisRoom(), top, -axisRoom() / 2, -axisRoom());
  return {area.topLeft(), QSizeF(std::max(1.0, area.width()), std::max(1.0, area.height()))};
}

QRectF SurfaceFrame::scaleArea() const {
  const double width = scaleRoom(output);
  return {size.width() - width, line(), width, std::max(1.0, size.height() - 2 * line())};
}

QRectF SurfaceFrame::textArea() const { return {0, 0, scaleArea().left() - theme::kGrid, size.height()}; }

SurfaceAxes SurfaceFrame::axes() const {
  return surfaceAxes(projection(), x, y, output, theme::smallFont(), textArea());
}

SurfaceProjection SurfaceFrame::projection() const { return {look.angles, boxArea(), look.zoom, look.shift}; }

double paintSurface(QPainter& painter, const SurfaceFrame& frame, std::shared_ptr<const SurfaceMesh> mesh,
                    SurfacePainting::Quality quality) {
  const SurfaceAxes axes = frame.axes();
  paintBehind(painter, frame, axes, mesh.get());
  QElapsedTimer clock;
  clock.start();
  if (mesh) SurfacePainting(std::move(mesh), frame.projection(), quality).paint(painter);
  const auto mesh_ns = static_cast<double>(clock.nsecsElapsed());
  paintBeside(painter, frame, axes);
  return mesh_ns;
}

SurfaceImage::SurfaceImage(const SurfaceFrame& frame, std::shared_ptr<const SurfaceMesh> mesh,
                           double device_pixel_ratio)
    : frame_(frame),
      axes_(frame.axes()),
      image_((frame.size * device_pixel_ratio).toSize(), QImage::Format_RGB32),
      painting_(mesh, frame.projection(), SurfacePainting::Quality::kSmooth) {
  image_.setDevicePixelRatio(device_pixel_ratio);
  QPainter painter(&image_);
  paintBehind(painter, frame_, axes_, mesh.get());
}

void SurfaceImage::work(double budget_ms) {
  QPainter painter(&image_);
  painting_.paint(painter, budget_ms);
  if (!painting_.isDone()) return;
  paintBeside(painter, frame_, axes_);
  done_ = true;
}

}  // namespace tactus::workbench
