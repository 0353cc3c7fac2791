#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <optional>

#include "app/workbench/base/display_text.h"
#include "app/workbench/plot/label_layout.h"
#include "app/workbench/plot/landmarks.h"
#include "app/workbench/understand/map/surface_picture.h"

namespace tactus::workbench {
namespace {

constexpr double kTick = 5;       // px, length of a tick
constexpr double kPad = 3;        // px, from a tick to its number and from the numbers to the name
constexpr double kShortest = 36;  // px, of an axis that has numbers
constexpr double kPerTick = 52;   // px of an axis on the floor for each number
constexpr int kForceTicks = 5;    // as at the color scale
constexpr int kMostTicks = 6;
constexpr double kBar = 3;  // px, of a landmark
constexpr int kLandmarkRows = 8;
constexpr double kTie = 1e-6;  // px; edges no farther apart are at the same place

// Where axes want to stand. Of two edges at the same height the right one, because the force has the left.
constexpr QPointF kDown(0.02, 1);
constexpr QPointF kUp(0.02, -1);
constexpr QPointF kLeft(-1, 0);

enum Axis : std::size_t { kX, kY, kZ };

double& coordinate(BoxPoint& point, std::size_t axis) { return axis == kX ? point.x : axis == kY ? point.y : point.z; }

/// An edge of the box that is parallel to an axis.
struct Edge {
  std::size_t axis = kX;
  BoxPoint from;  ///< the low end
  BoxPoint to;

  BoxPoint at(double share) const {
    BoxPoint point = from;
    coordinate(point, axis) = share;
    return point;
  }
};

std::array<Edge, 4> edgesAlong(std::size_t axis) {
  std::array<Edge, 4> edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    Edge& edge = edges[i];
    edge.axis = axis;
    coordinate(edge.from, (axis + 1) % 3) = static_cast<double>(i & 1U);
    coordinate(edge.from, (axis + 2) % 3) = static_cast<double>(i >> 1U);
    edge.to = edge.from;
    coordinate(edge.to, axis) = 1;
  }
  return edges;
}

class Builder {
 public:
  Builder(const SurfaceProjection& seen, const std::array<const fuzzy::Variable*, 3>& variables, const QFont& font,
          const QRectF& bounds)
      : seen_(seen), variables_(variables), font_(font), metrics_(font), board_(bounds) {}

  SurfaceAxes build() {
    const Edge x = outermost(kX, kDown);
    const Edge y = outermost(kY, kDown);
    const Edge z = outermost(kZ, kLeft);
    for (const Edge& edge : {x, y, z}) chooseTicks(edge);
    addWalls();
    // The names first: an axis without a name says nothing, a number can be missed.
    for (const Edge& edge : {z, x, y}) addLine(edge);
    for (const Edge& edge : {z, x, y}) addName(edge);
    for (const Edge& edge : {z, x, y}) addNumbers(edge);
    for (const std::size_t axis : {kX, kY}) addLandmarks(axis);
    return std::move(axes_);
  }

 private:
  QLineF line(const Edge& edge) const { return {seen_(edge.from), seen_(edge.to)}; }

  // The edge whose middle lies farthest in `direction` on the screen; the nearest of those at the same place.
  Edge outermost(std::size_t axis, const QPointF& direction) const {
    std::optional<Edge> best;
    double best_place = 0;
    double best_nearness = 0;
    for (const Edge& edge : edgesAlong(axis)) {
      const double place = QPointF::dotProduct(line(edge).center(), direction);
      const double nearness = seen_.nearness(edge.at(0.5));
      const bool same = best && std::abs(place - best_place) < kTie;
      if (best && (same ? nearness <= best_nearness : place < best_place)) continue;
      best = edge;
      best_place = place;
      best_nearness = nearness;
    }
    return *best;
  }

  // The unit vector across an edge, away from the middle of the box.
  QPointF outward(const Edge& edge) const {
    const QLineF along = line(edge);
    QPointF across(along.dy(), -along.dx());
    across /= std::max(kTie, std::hypot(across.x(), across.y()));
    const QPointF away = along.center() - seen_({0.5, 0.5, 0.5});
    return QPointF::dotProduct(across, away) < 0 ? -across : across;
  }

  void chooseTicks(const Edge& edge) {
    const fuzzy::Variable& variable = *variables_[edge.axis];
    const int count =
        edge.axis == kZ ? kForceTicks : std::clamp(static_cast<int>(line(edge).length() / kPerTick), 1, kMostTicks);
    ticks_[edge.axis] = universeTicks(variable.min, variable.max, count);
  }

  void addWalls() {
    const BoxPoint far = farCorner(seen_);
    for (std::size_t across = 0; across < 3; ++across) {
      const std::size_t one = (across + 1) % 3;
      const std::size_t other = (across + 2) % 3;
      BoxPoint corner = far;
      for (const auto& [a, b] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}}) {
        coordinate(corner, one) = a;
        coordinate(corner, other) = b;
        axes_.walls[across] << seen_(corner);
      }
      for (const std::size_t along : {one, other}) {
        const std::size_t rest = along == one ? other : one;
        const fuzzy::Variable& variable = *variables_[along];
        for (const double tick : ticks_[along]) {
          BoxPoint from = far;
          coordinate(from, along) = shareOf(variable, tick);
          coordinate(from, rest) = 0;
          BoxPoint to = from;
          coordinate(to, rest) = 1;
          const bool border = tick == variable.min || tick == variable.max;
          (border ? axes_.edges : axes_.grid).emplace_back(seen_(from), seen_(to));
        }
      }
    }
  }

  void addLine(const Edge& edge) {
    const QLineF along = line(edge);
    if (along.length() < kShortest) return;
    axes_.axis_lines.push_back(along);
    for (const double tick : ticks_[edge.axis]) {
      const QPointF at = seen_(edge.at(shareOf(*variables_[edge.axis], tick)));
      axes_.axis_lines.emplace_back(at, at + outward(edge) * kTick);
    }
  }

  // How far a text that is `size` large reaches across an edge from its middle.
  static double halfAcross(const QSizeF& size, const QPointF& across) {
    return (std::abs(across.x()) * size.width() + std::abs(across.y()) * size.height()) / 2;
  }

  QSizeF sizeOf(const QString& text) const { return {metrics_.horizontalAdvance(text), metrics_.height()}; }

  void addNumbers(const Edge& edge) {
    if (line(edge).length() < kShortest) return;
    const QPointF across = outward(edge);
    std::vector<double> ticks = ticks_[edge.axis];
    // The ends first, which say how far the universe goes.
    std::rotate(ticks.begin() + 1, ticks.end() - 1, ticks.end());
    for (const double tick : ticks) {
      const QString text = numberText(tick, 4);
      const QSizeF size = sizeOf(text);
      const QPointF at = seen_(edge.at(shareOf(*variables_[edge.axis], tick)));
      const TurnedBox box{at + across * (kTick + kPad + halfAcross(size, across)), size, 0};
      const TurnedBox room{box.middle, size + QSizeF(2 * kPad, 0), 0};
      if (board_.place(room)) axes_.numbers.push_back({text, box});
    }
  }

  void addName(const Edge& edge) {
    const QLineF along = line(edge);
    if (along.length() < kShortest) return;
    const QPointF across = outward(edge);
    double numbers = 0;
    for (const double tick : ticks_[edge.axis]) {
      numbers = std::max(numbers, 2 * halfAcross(sizeOf(numberText(tick, 4)), across));
    }
    const QString text = axisText(*variables_[edge.axis]);
    const QSizeF size = sizeOf(text);
    // Along the edge, and never upside down.
    double angle = -along.angle();
    while (angle <= -90) angle += 180;
    while (angle > 90) angle -= 180;
    // A name that goes up reads from below, as those of plots do.
    if (angle > 89.9) angle -= 180;
    const double distance = kTick + numbers + 2 * kPad + size.height() / 2;
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9, 0.0, 1.0}) {
      const TurnedBox box{along.pointAt(share) + across * distance, size, angle};
      if (!board_.place(box)) continue;
      axes_.names.push_back({text, box});
      return;
    }
  }

  void addLandmarks(std::size_t axis) {
    const std::vector<Landmark> landmarks = landmarksFor(*variables_[axis]);
    if (landmarks.empty()) return;
    const Edge edge = outermost(axis, kUp);
    if (line(edge).length() < kShortest) return;
    const QPointF across = outward(edge) * kBar;
    QFont italic = font_;
    italic.setItalic(true);
    const QFontMetricsF metrics(italic);
    std::vector<Name> names;
    for (const Landmark& landmark : landmarks) {
      const fuzzy::Variable& depth = *variables_[axis];
      if (landmark.to_mm < depth.min || landmark.from_mm > depth.max) continue;
      const double from_mm = std::max(landmark.from_mm, depth.min);
      const double to_mm = std::min(landmark.to_mm, depth.max);
      QLineF bar(seen_(edge.at(shareOf(depth, from_mm))), seen_(edge.at(shareOf(depth, to_mm))));
      // A point is as wide as it is seen well.
      if (bar.length() < 1.5) {
        const QPointF half = line(edge).unitVector().p2() - line(edge).p1();
        bar = QLineF(bar.center() - half * 0.75, bar.center() + half * 0.75);
      }
      axes_.landmark_bars << QPolygonF({bar.p1(), bar.p2(), bar.p2() + across, bar.p1() + across});
      names.push_back(
          {landmark.name, bar.center() + across, {metrics.horizontalAdvance(landmark.name) + 4, metrics.height()}});
    }
    placeNames(std::move(names), line(edge));
  }

  /// Of a landmark: wants to stand above `bar`.
  struct Name {
    QString text;
    QPointF bar;
    QSizeF size;
  };
  struct PlacedNames {
    std::vector<SurfaceText> texts;
    QVector<QLineF> leads;
  };

  // From the lower end of the slanting edge upward, so that the names become a stair; the way that finds room for more
  // names wins.
  void placeNames(std::vector<Name> names, const QLineF& edge) {
    const double rise = std::abs(edge.dx()) > kTie ? edge.dy() / edge.dx() : 0;
    const double side = rise >= 0 ? 1 : -1;
    std::sort(names.begin(), names.end(),
              [side](const Name& a, const Name& b) { return side * a.bar.x() > side * b.bar.x(); });
    PlacedNames best;
    LabelBoard best_board = board_;
    // Each above its bar as far as that goes; otherwise as flags, each beside a pole on its bar.
    const std::vector above = {0.0, 0.25, 0.5, -0.25, -0.5};
    for (const auto& shifts : {above, std::vector{0.5}}) {
      if (best.texts.size() == names.size()) break;
      LabelBoard board = board_;
      PlacedNames placed;
      for (const Name& name : names) {
        if (!placeName(board, name, side, shifts, rise, placed)) placeName(board, name, side, above, rise, placed);
      }
      if (placed.texts.size() <= best.texts.size()) continue;
      best = std::move(placed);
      best_board = std::move(board);
    }
    axes_.landmarks.insert(axes_.landmarks.end(), best.texts.begin(), best.texts.end());
    axes_.landmark_leads << best.leads;
    board_ = std::move(best_board);
  }

  static bool placeName(LabelBoard& board, const Name& name, double way, const std::vector<double>& shifts, double rise,
                        PlacedNames& placed) {
    for (int row = 0; row < kLandmarkRows; ++row) {
      for (const double shift : shifts) {
        if (tryName(board, name, row, way * shift, rise, placed)) return true;
      }
    }
    return false;
  }

  static bool tryName(LabelBoard& board, const Name& name, int row, double shift, double rise, PlacedNames& placed) {
    const double middle = name.bar.x() + shift * name.size.width();
    // The text stays clear of the slanting edge of the box over its whole width.
    const double half = name.size.width() / 2;
    const double highest =
        name.bar.y() + std::min({0.0, rise * (middle - half - name.bar.x()), rise * (middle + half - name.bar.x())});
    const double bottom = highest - kPad - row * name.size.height();
    const TurnedBox box{{middle, bottom - name.size.height() / 2}, name.size, 0};
    const QLineF lead(name.bar, {name.bar.x(), bottom});
    const TurnedBox lead_box = boxOf(lead, 1.5);
    if (!board.isFree(box) || !board.isFree(lead_box)) return false;
    board.occupy(box);
    board.occupy(lead_box);
    placed.texts.push_back({name.text, box});
    placed.leads << lead;
    return true;
  }

  const SurfaceProjection& seen_;
  std::array<const fuzzy::Variable*, 3> variables_;
  QFont font_;
  QFontMetricsF metrics_;
  LabelBoard board_;
  std::array<std::vector<double>, 3> ticks_;
  SurfaceAxes axes_;
};

}  // namespace

double shareOf(const fuzzy::Variable& variable, double value) {
  return (value - variable.min) / (variable.max - variable.min);
}

SurfaceAxes surfaceAxes(const SurfaceProjection& seen, const fuzzy::Variable& x, const fuzzy::Variable& y,
                        const fuzzy::Variable& z, const QFont& font, const QRectF& bounds) {
  return Builder(seen, {&x, &y, &z}, font, bounds).build();
}

BoxPoint farCorner(const SurfaceProjection& seen) {
  const BoxVector& viewer = seen.toViewer();
  return {viewer.x > 0 ? 0.0 : 1.0, viewer.y > 0 ? 0.0 : 1.0, viewer.z < 0 ? 1.0 : 0.0};
}

}  // namespace tactus::workbench
