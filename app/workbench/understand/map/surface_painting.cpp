#include "app/workbench/understand/map/surface_painting.h"

#include <QElapsedTimer>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "app/workbench/understand/map/force_colors.h"
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

}  // namespace tactus::workbench
