#include "app/workbench/feel/sagittal_drawing.h"

#include <QTransform>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace tactus::workbench::sagittal {
namespace {

struct Anchor {
  double depth_mm;
  double x;
  double y;
  double width;
};

// Depths of an adult: nostril, choana 64, back wall of the nasopharynx 94, soft palate 120, epiglottis 150, upper
// sphincter 200, lower sphincter 430, stomach beyond. The esophagus is drawn shorter than it is.
constexpr std::array kWay = {Anchor{-60, 8, 176, 10},   Anchor{-20, 33, 141, 10},  Anchor{0, 44, 126, 12},
                             Anchor{20, 62, 117, 20},   Anchor{64, 104, 112, 22},  Anchor{85, 124, 114, 20},
                             Anchor{94, 132, 121, 18},  Anchor{120, 138, 146, 16}, Anchor{150, 141, 176, 18},
                             Anchor{175, 143, 200, 15}, Anchor{200, 146, 222, 9},  Anchor{300, 151, 271, 10},
                             Anchor{415, 152, 326, 10}, Anchor{435, 148, 338, 11}, Anchor{470, 134, 354, 22},
                             Anchor{520, 112, 366, 30}, Anchor{560, 94, 366, 26},  Anchor{600, 79, 360, 18}};

constexpr QPointF kPivot(150, 196);  // upper neck
constexpr double kLargestTurn = 26;  // degrees on the canvas
constexpr double kStiffAbove = 150;  // all of the head turns, …
constexpr double kStillBelow = 236;  // … and nothing below the neck

// The head turns about the neck; between head and chest the turn fades.
QPointF posed(const QPointF& point, double flexion) {
  const double share = std::clamp((kStillBelow - point.y()) / (kStillBelow - kStiffAbove), 0.0, 1.0);
  const double smooth = share * share * (3 - 2 * share);
  QTransform turn;
  turn.translate(kPivot.x(), kPivot.y());
  turn.rotate(-kLargestTurn * flexion * smooth);
  turn.translate(-kPivot.x(), -kPivot.y());
  return turn.map(point);
}

// A smooth line through points (Catmull and Rom), each posed.
QPainterPath through(const std::vector<QPointF>& points, double flexion, bool closed = false) {
  std::vector<QPointF> at;
  for (const QPointF& point : points) at.push_back(posed(point, flexion));
  const auto count = static_cast<std::ptrdiff_t>(at.size());
  const auto pointOf = [&](std::ptrdiff_t i) {
    return at[static_cast<std::size_t>(closed ? (i + count) % count : std::clamp<std::ptrdiff_t>(i, 0, count - 1))];
  };
  QPainterPath path(at.front());
  for (std::ptrdiff_t i = 0; i < (closed ? count : count - 1); ++i) {
    const QPointF from = pointOf(i);
    const QPointF to = pointOf(i + 1);
    path.cubicTo(from + (to - pointOf(i - 1)) / 6, to - (pointOf(i + 2) - from) / 6, to);
  }
  if (closed) path.closeSubpath();
  return path;
}

}  // namespace

QPainterPath outline(double flexion) {
  // Front: forehead, nose, mouth, chin, neck, chest, belly. Back: crown, nape, shoulders, back.
  QPainterPath front =
      through({{118, 16}, {84, 24},   {62, 46},   {54, 72},   {54, 86},  {45, 104}, {34, 120}, {37, 128},
               {50, 131}, {51, 138},  {45, 146},  {50, 152},  {47, 160}, {52, 167}, {54, 182}, {66, 192},
               {92, 196}, {108, 204}, {110, 222}, {100, 244}, {72, 266}, {56, 300}, {50, 340}, {48, 398}},
              flexion);
  const QPainterPath back = through({{118, 16},
                                     {158, 16},
                                     {196, 36},
                                     {216, 74},
                                     {214, 116},
                                     {200, 150},
                                     {190, 178},
                                     {190, 208},
                                     {206, 230},
                                     {228, 256},
                                     {238, 300},
                                     {236, 350},
                                     {228, 398}},
                                    flexion);
  front.connectPath(back.toReversed());
  return front;
}

QPainterPath airway(double flexion) {
  QPainterPath path = through({{50, 151}, {70, 150}, {96, 146}, {118, 152}, {130, 172}}, flexion);
  path.addPath(through({{132, 190}, {128, 206}, {126, 232}, {126, 262}, {128, 292}}, flexion));
  // The epiglottis between the two ways.
  path.addPath(through({{131, 189}, {126, 180}, {124, 170}}, flexion));
  return path;
}

QPainterPath stomach(double flexion) {
  return through({{146, 332},
                  {154, 322},
                  {170, 322},
                  {176, 342},
                  {162, 372},
                  {128, 390},
                  {92, 388},
                  {72, 374},
                  {64, 358},
                  {72, 346},
                  {86, 350},
                  {106, 350},
                  {128, 344}},
                 flexion, true);
}

QPointF placeAt(double depth_mm, double flexion) {
  const double depth = std::clamp(depth_mm, kWay.front().depth_mm, kWay.back().depth_mm);
  const auto above = std::find_if(kWay.begin() + 1, kWay.end() - 1,
                                  [depth](const Anchor& anchor) { return anchor.depth_mm >= depth; });
  const auto below = std::prev(above);
  const auto pointOf = [](const Anchor& anchor) { return QPointF(anchor.x, anchor.y); };
  const QPointF before = pointOf(below == kWay.begin() ? *below : *std::prev(below));
  const QPointF after = pointOf(std::next(above) == kWay.end() ? *above : *std::next(above));
  const QPointF from = pointOf(*below);
  const QPointF to = pointOf(*above);
  // Cubic Hermite with the slopes of the chords over depth, so that equal depths are nearly equal ways.
  const double span = above->depth_mm - below->depth_mm;
  const double before_span = below == kWay.begin() ? 0 : below->depth_mm - std::prev(below)->depth_mm;
  const double after_span = std::next(above) == kWay.end() ? 0 : std::next(above)->depth_mm - above->depth_mm;
  const QPointF slope_from = (to - before) / (span + before_span) * span;
  const QPointF slope_to = (after - from) / (span + after_span) * span;
  const double t = (depth - below->depth_mm) / span;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return posed(
      from * (2 * t3 - 3 * t2 + 1) + slope_from * (t3 - 2 * t2 + t) + to * (3 * t2 - 2 * t3) + slope_to * (t3 - t2),
      flexion);
}

double widthAt(double depth_mm) {
  const auto above =
      std::find_if(kWay.begin(), kWay.end(), [depth_mm](const Anchor& anchor) { return anchor.depth_mm >= depth_mm; });
  if (above == kWay.begin()) return kWay.front().width;
  if (above == kWay.end()) return kWay.back().width;
  const auto below = std::prev(above);
  return std::lerp(below->width, above->width, (depth_mm - below->depth_mm) / (above->depth_mm - below->depth_mm));
}

double endMm() { return kWay.back().depth_mm; }

}  // namespace tactus::workbench::sagittal
