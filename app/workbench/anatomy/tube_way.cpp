#include "app/workbench/anatomy/tube_way.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/workbench/anatomy/neck_rig.h"

namespace tactus::workbench::anatomy {
namespace {

constexpr std::size_t kSteps = 32;   // for each piece: 0.5 mm and less
constexpr std::size_t kNostril = 4;  // the point at the origin

// From the hand to the stomach, upright.
constexpr std::array kThrough = {
    QPointF(-70, 52),    QPointF(-46, 44),    QPointF(-24, 28),    QPointF(-8, 10),     QPointF(0, 0),
    QPointF(4, -6),      QPointF(11, -8),     QPointF(24, -7),     QPointF(45, -4.2),   QPointF(62, -2),
    QPointF(74, 0),      QPointF(83, 6),      QPointF(88, 16),     QPointF(90, 28),     QPointF(90, 42),
    QPointF(90, 56),     QPointF(91, 70),     QPointF(93.5, 85),   QPointF(97, 99),     QPointF(100.5, 109),
    QPointF(104.5, 122), QPointF(109.5, 138), QPointF(115.5, 157), QPointF(121.5, 178), QPointF(127, 198),
    QPointF(130, 212),   QPointF(132.5, 230), QPointF(134, 248),   QPointF(133.5, 266), QPointF(131, 282),
    QPointF(127, 297),   QPointF(121, 312),   QPointF(114.5, 324), QPointF(109, 333),   QPointF(106, 341),
    QPointF(103, 356),   QPointF(97, 372),    QPointF(86, 385),    QPointF(72, 392),    QPointF(60, 392)};

// A smooth line through points (Catmull and Rom): each piece is a cubic whose control points lie at a sixth of the
// chord between the neighbors.
std::vector<QPointF> smoothLine(const std::vector<QPointF>& through) {
  const std::size_t last = through.size() - 1;
  std::vector<QPointF> line;
  line.reserve(last * kSteps + 1);
  for (std::size_t i = 0; i < last; ++i) {
    const QPointF from = through[i];
    const QPointF to = through[i + 1];
    const QPointF leaving = from + (to - through[i == 0 ? 0 : i - 1]) / 6;
    const QPointF arriving = to - (through[std::min(i + 2, last)] - from) / 6;
    for (std::size_t step = 0; step < kSteps; ++step) {
      const double t = static_cast<double>(step) / static_cast<double>(kSteps);
      const double s = 1 - t;
      line.push_back(from * (s * s * s) + leaving * (3 * s * s * t) + arriving * (3 * s * t * t) + to * (t * t * t));
    }
  }
  line.push_back(through.back());
  return line;
}

std::vector<QPointF> lineAt(double flexion_deg) {
  std::vector<QPointF> through;
  through.reserve(kThrough.size());
  for (const QPointF& point : kThrough) through.push_back(posed(point, Part::kSoft, flexion_deg));
  return smoothLine(through);
}

// The way along `line`, 0 at the nostril.
std::vector<double> lengthsOf(const std::vector<QPointF>& line) {
  std::vector<double> lengths(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const QPointF step = line[i] - line[i - 1];
    lengths[i] = lengths[i - 1] + std::hypot(step.x(), step.y());
  }
  const double nostril = lengths[kNostril * kSteps];
  for (double& length : lengths) length -= nostril;
  return lengths;
}

}  // namespace

TubeWay::TubeWay(double flexion_deg) : line_(lineAt(flexion_deg)), depths_(lengthsOf(lineAt(0))) {}

QPointF TubeWay::placeAt(double depth_mm) const {
  const double depth = std::clamp(depth_mm, beginMm(), endMm());
  const auto above = std::lower_bound(depths_.begin() + 1, depths_.end() - 1, depth);
  const auto i = static_cast<std::size_t>(above - depths_.begin());
  const double share = (depth - depths_[i - 1]) / (depths_[i] - depths_[i - 1]);
  return line_[i - 1] + (line_[i] - line_[i - 1]) * share;
}

std::vector<QPointF> TubeWay::between(double from_mm, double to_mm) const {
  std::vector<QPointF> points = {placeAt(from_mm)};
  for (std::size_t i = 0; i < line_.size(); ++i) {
    if (depths_[i] > from_mm && depths_[i] < to_mm) points.push_back(line_[i]);
  }
  points.push_back(placeAt(to_mm));
  return points;
}

double TubeWay::drawnLengthMm(double depth_mm) const {
  const std::vector<QPointF> points = depth_mm < 0 ? between(depth_mm, 0) : between(0, depth_mm);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const QPointF step = points[i] - points[i - 1];
    length += std::hypot(step.x(), step.y());
  }
  return depth_mm < 0 ? -length : length;
}

}  // namespace tactus::workbench::anatomy
