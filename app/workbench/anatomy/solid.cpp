#include "app/workbench/anatomy/solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactus::workbench::anatomy {
namespace {

using procedure::Point;

constexpr int kRim = 4;                 // steps between the outline and the first point of the grid inside
constexpr double kNearestShare = 0.02;  // of a step: a crossing is no nearer to a point of the grid
constexpr double kFadeShare = 0.16;     // of the frame
constexpr double kBorderShare = 1e-4;   // of the frame: a line so near to its border ends there
constexpr double kSolvedShare = 1e-5;   // of the largest value
constexpr std::uint32_t kNone = 0xFFFFFFFF;

Spot minus(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Spot cross(const Spot& a, const Spot& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A grid over the outline, on which u with u_xx + u_yy = -2 and u = 0 at the outline is solved. The half breadth is
/// the root of u: a strip becomes a round bar, a disk a flattened ball.
class Balloon {
 public:
  Balloon(const std::vector<Point>& outline, const Frame& frame, int cells) : frame_(frame) {
    placeGrid(outline, cells);
    if (columns_ == 0) return;
    findInside(outline);
    // An outline around the whole frame has no edge inside it: it is closed at the frame.
    if (chains_.empty()) {
      for (bool& open : open_) open = false;
      placeGrid(outline, cells);
      findInside(outline);
    }
    solve();
  }

  Solid solid(std::optional<double> breadth) {
    if (columns_ == 0 || !std::any_of(inside_.begin(), inside_.end(), [](char in) { return in != 0; })) return {};
    const double largest = std::sqrt(*std::max_element(u_.begin(), u_.end()));
    swell_ = breadth && largest > 0 ? *breadth / 2 / largest : 1;
    addVertices();
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) addCell(column, row);
    }
    for (Solid::Vertex& vertex : out_.vertices) {
      Spot& n = vertex.normal;
      const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      n = length > 0 ? Spot{n.x / length, n.y / length, n.z / length} : Spot{0, 0, 1};
    }
    return std::move(out_);
  }

 private:
  enum Side { kLeft, kRight, kTop, kBottom };

  /// The points between a node inside and the outline, on an edge of the grid.
  struct Chain {
    double share = 1;                                ///< of the edge, from the node inside to the outline
    std::array<std::uint32_t, kRim + 1> front = {};  ///< [0] is the node, [kRim] on the outline
    std::array<std::uint32_t, kRim + 1> back = {};
  };

  std::size_t node(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) + static_cast<std::size_t>(column);
  }
  bool isInside(int column, int row) const { return inside_[node(column, row)] != 0; }
  double xOf(int column) const { return left_ + column * step_x_; }
  double yOf(int row) const { return top_ + row * step_y_; }

  void placeGrid(const std::vector<Point>& outline, int cells) {
    columns_ = rows_ = 0;
    if (outline.size() < 3) return;
    const auto [x_min, x_max] =
        std::minmax_element(outline.begin(), outline.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    const auto [y_min, y_max] =
        std::minmax_element(outline.begin(), outline.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    const double near_x = kBorderShare * frame_.width;
    const double near_y = kBorderShare * frame_.height;
    const double right = frame_.left + frame_.width;
    const double bottom = frame_.top + frame_.height;
    const bool reaches[] = {x_min->x <= frame_.left + near_x, x_max->x >= right - near_x,
                            y_min->y <= frame_.top + near_y, y_max->y >= bottom - near_y};
    double from_x = std::max(x_min->x, frame_.left), to_x = std::min(x_max->x, right);
    double from_y = std::max(y_min->y, frame_.top), to_y = std::min(y_max->y, bottom);
    if (!(to_x > from_x) || !(to_y > from_y)) return;
    const double step = std::max(to_x - from_x, to_y - from_y) / cells;
    for (const Side side : {kLeft, kRight, kTop, kBottom}) open_[side] = open_[side] && reaches[side];
    // Around what ends in the frame, a row of points lies outside.
    from_x -= open_[kLeft] ? 0 : step / 2;
    to_x += open_[kRight] ? 0 : step / 2;
    from_y -= open_[kTop] ? 0 : step / 2;
    to_y += open_[kBottom] ? 0 : step / 2;
    columns_ = std::max(2, static_cast<int>(std::lround((to_x - from_x) / step)));
    rows_ = std::max(2, static_cast<int>(std::lround((to_y - from_y) / step)));
    left_ = from_x;
    top_ = from_y;
    step_x_ = (to_x - from_x) / columns_;
    step_y_ = (to_y - from_y) / rows_;
  }

  /// Where the outline crosses the line at `place`, along the other axis, rising.
  template <class Along, class Over>
  static std::vector<double> crossings(const std::vector<Point>& outline, double place, Along along, Over over) {
    std::vector<double> out;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point& a = outline[i];
      const Point& b = outline[(i + 1) % outline.size()];
      if ((over(a) <= place) == (over(b) <= place)) continue;
      out.push_back(along(a) + (place - over(a)) / (over(b) - over(a)) * (along(b) - along(a)));
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  /// `place`, moved off a border of the frame, on which an outline that is cut there may run.
  static double within(double place, double from, double length) {
    return std::clamp(place, from + kBorderShare * length, from + length - kBorderShare * length);
  }

  void findInside(const std::vector<Point>& outline) {
    const auto x = [](const Point& p) { return p.x; };
    const auto y = [](const Point& p) { return p.y; };
    inside_.assign(node(columns_, rows_) + 1, 0);
    chains_.clear();
    along_.assign(inside_.size(), kNone);
    down_.assign(inside_.size(), kNone);
    std::vector<std::vector<double>> rows, columns;
    for (int row = 0; row <= rows_; ++row)
      rows.push_back(crossings(outline, within(yOf(row), frame_.top, frame_.height), x, y));
    for (int column = 0; column <= columns_; ++column)
      columns.push_back(crossings(outline, within(xOf(column), frame_.left, frame_.width), y, x));
    for (int row = 0; row <= rows_; ++row) {
      const auto& at = rows[static_cast<std::size_t>(row)];
      for (int column = 0; column <= columns_; ++column) {
        const double place = within(xOf(column), frame_.left, frame_.width);
        const bool closed = (column == 0 && !open_[kLeft]) || (column == columns_ && !open_[kRight]) ||
                            (row == 0 && !open_[kTop]) || (row == rows_ && !open_[kBottom]);
        inside_[node(column, row)] = !closed && (std::upper_bound(at.begin(), at.end(), place) - at.begin()) % 2 == 1;
      }
    }
    for (int row = 0; row <= rows_; ++row) {
      for (int column = 0; column <= columns_; ++column) {
        if (column < columns_ && isInside(column, row) != isInside(column + 1, row))
          along_[node(column, row)] =
              addChain(rows[static_cast<std::size_t>(row)], xOf(column), step_x_, isInside(column, row));
        if (row < rows_ && isInside(column, row) != isInside(column, row + 1))
          down_[node(column, row)] =
              addChain(columns[static_cast<std::size_t>(column)], yOf(row), step_y_, isInside(column, row));
      }
    }
  }

  /// For the edge from `place` to the next point of the grid, of which one is inside.
  std::uint32_t addChain(const std::vector<double>& crossings, double place, double step, bool begins_inside) {
    Chain chain;
    chain.share = 0.5;
    if (begins_inside) {
      const auto first = std::upper_bound(crossings.begin(), crossings.end(), place);
      if (first != crossings.end()) chain.share = (*first - place) / step;
    } else {
      const auto after = std::lower_bound(crossings.begin(), crossings.end(), place + step);
      if (after != crossings.begin()) chain.share = (place + step - *(after - 1)) / step;
    }
    chain.share = std::clamp(chain.share, kNearestShare, 1.0);
    chains_.push_back(chain);
    return static_cast<std::uint32_t>(chains_.size() - 1);
  }

  /// What the equation has of one axis at a node: `weight` of its value and the share of its neighbors in the sum.
  struct Pull {
    double weight = 0;
    double sum = 0;
  };
  struct Neighbor {
    double distance = 0;
    std::size_t node = 0;
    bool inside = false;  ///< otherwise on the outline
    bool exists = false;  ///< false: at a border where the body goes on as in a mirror
  };

  /// Of a node inside; Shortley and Weller's differences at the outline.
  Pull pullOf(Neighbor one, Neighbor other) const {
    if (!one.exists) one = other;
    if (!other.exists) other = one;
    const double both = one.distance + other.distance;
    Pull out;
    for (const Neighbor& neighbor : {one, other}) {
      const double weight = 2 / (both * neighbor.distance);
      out.weight += weight;
      if (neighbor.inside) out.sum += weight * u_[neighbor.node];
    }
    return out;
  }

  Neighbor neighbor(int column, int row, int to_column, int to_row) const {
    if (to_column < 0 || to_column > columns_ || to_row < 0 || to_row > rows_) return {};
    const double step = column != to_column ? step_x_ : step_y_;
    if (isInside(to_column, to_row)) return {step, node(to_column, to_row), true, true};
    const auto& chains = column != to_column ? along_ : down_;
    const std::uint32_t chain = chains[node(std::min(column, to_column), std::min(row, to_row))];
    return {step * chains_[chain].share, 0, false, true};
  }

  /// By successive over-relaxation.
  void solve() {
    u_.assign(inside_.size(), 0);
    const int longest = std::max(columns_, rows_);
    const double relax = 2 / (1 + std::sin(std::numbers::pi / (1.3 * longest)));
    for (int round = 0; round < 8 * longest; ++round) {
      double largest = 0, changed = 0;
      for (int row = 0; row <= rows_; ++row) {
        for (int column = 0; column <= columns_; ++column) {
          if (!isInside(column, row)) continue;
          const Pull x = pullOf(neighbor(column, row, column - 1, row), neighbor(column, row, column + 1, row));
          const Pull y = pullOf(neighbor(column, row, column, row - 1), neighbor(column, row, column, row + 1));
          double& value = u_[node(column, row)];
          const double change = relax * ((2 + x.sum + y.sum) / (x.weight + y.weight) - value);
          value = std::max(0.0, value + change);
          largest = std::max(largest, value);
          changed = std::max(changed, std::abs(change));
        }
      }
      if (changed <= kSolvedShare * largest) break;
    }
  }

  std::uint32_t addVertex(double x, double y, double z) {
    double seen = 1;
    const auto fade = [&](bool open, double distance, double length) {
      if (!open) return;
      const double share = std::clamp(distance / (kFadeShare * length), 0.0, 1.0);
      seen *= share * share * (3 - 2 * share);
    };
    fade(open_[kLeft], x - frame_.left, frame_.width);
    fade(open_[kRight], frame_.left + frame_.width - x, frame_.width);
    fade(open_[kTop], y - frame_.top, frame_.height);
    fade(open_[kBottom], frame_.top + frame_.height - y, frame_.height);
    out_.vertices.push_back({{x, y, z}, {}, seen});
    return static_cast<std::uint32_t>(out_.vertices.size() - 1);
  }

  void addVertices() {
    front_.assign(inside_.size(), kNone);
    back_.assign(inside_.size(), kNone);
    for (int row = 0; row <= rows_; ++row) {
      for (int column = 0; column <= columns_; ++column) {
        if (!isInside(column, row)) continue;
        const std::size_t at = node(column, row);
        const double z = swell_ * std::sqrt(u_[at]);
        front_[at] = addVertex(xOf(column), yOf(row), z);
        back_[at] = addVertex(xOf(column), yOf(row), -z);
      }
    }
    for (int row = 0; row <= rows_; ++row) {
      for (int column = 0; column <= columns_; ++column) {
        fillChain(along_[node(column, row)], column, row, column + 1, row);
        fillChain(down_[node(column, row)], column, row, column, row + 1);
      }
    }
  }

  // Near the outline the half breadth grows like the root of the distance: the points keep even steps of it.
  void fillChain(std::uint32_t number, int column, int row, int to_column, int to_row) {
    if (number == kNone) return;
    Chain& chain = chains_[number];
    if (!isInside(column, row)) {
      std::swap(column, to_column);
      std::swap(row, to_row);
    }
    const std::size_t from = node(column, row);
    chain.front[0] = front_[from];
    chain.back[0] = back_[from];
    const double z = swell_ * std::sqrt(u_[from]);
    for (int k = 1; k <= kRim; ++k) {
      const double left = static_cast<double>(kRim - k) / kRim;
      const double share = chain.share * (1 - left * left);
      const double x = xOf(column) + share * (xOf(to_column) - xOf(column));
      const double y = yOf(row) + share * (yOf(to_row) - yOf(row));
      const auto i = static_cast<std::size_t>(k);
      chain.front[i] = addVertex(x, y, left * z);
      chain.back[i] = k < kRim ? addVertex(x, y, -left * z) : chain.front[i];
    }
  }

  /// Not `shades`: of the cut at a border, whose points belong to the surface beside it.
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool shades = true) {
    out_.triangles.push_back({a, b, c});
    if (!shades) return;
    const auto at = [&](std::uint32_t i) { return out_.vertices[i].at; };
    const Spot normal = cross(minus(at(b), at(a)), minus(at(c), at(a)));
    for (const std::uint32_t i : {a, b, c}) {
      Spot& sum = out_.vertices[i].normal;
      sum = {sum.x + normal.x, sum.y + normal.y, sum.z + normal.z};
    }
  }

  /// A face of the front in the order of its corners, and the one behind it.
  struct Pair {
    std::uint32_t front;
    std::uint32_t back;
  };
  void addFace(const Pair& a, const Pair& b, const Pair& c) {
    addTriangle(a.front, b.front, c.front);
    addTriangle(a.back, c.back, b.back);
  }
  /// The wall at a border below the edge of the front from `a` to `b`.
  void addWall(const Pair& a, const Pair& b) {
    if (a.front != a.back) addTriangle(b.front, a.front, a.back, false);
    if (b.front != b.back) addTriangle(b.front, a.back, b.back, false);
  }

  void addCell(int column, int row) {
    struct Corner {
      int column;
      int row;
    };
    const Corner corners[] = {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}};
    const auto cornerAt = [&](int k) { return corners[k % 4]; };
    const auto inside = [&](int k) { return isInside(cornerAt(k).column, cornerAt(k).row); };
    const auto pairAt = [&](int k) {
      const std::size_t at = node(cornerAt(k).column, cornerAt(k).row);
      return Pair{front_[at], back_[at]};
    };
    const auto chainAt = [&](int k) -> const Chain& {
      const Corner a = cornerAt(k), b = cornerAt(k + 1);
      const auto& chains = a.row == b.row ? along_ : down_;
      return chains_[chains[node(std::min(a.column, b.column), std::min(a.row, b.row))]];
    };
    const auto pairOf = [](const Chain& chain, int k) {
      return Pair{chain.front[static_cast<std::size_t>(k)], chain.back[static_cast<std::size_t>(k)]};
    };
    std::vector<Pair> all;
    for (int k = 0; k < 4; ++k) {
      if (inside(k)) all.push_back(pairAt(k));
    }
    for (std::size_t k = 2; k < all.size(); ++k) addFace(all[0], all[k - 1], all[k]);
    const bool walls[] = {row == 0 && open_[kTop], column + 1 == columns_ && open_[kRight],
                          row + 1 == rows_ && open_[kBottom], column == 0 && open_[kLeft]};
    for (int k = 0; k < 4; ++k) {
      if (inside(k) && inside(k + 1)) {
        if (walls[k]) addWall(pairAt(k), pairAt(k + 1));
        continue;
      }
      if (inside(k) == inside(k + 1)) continue;
      if (walls[k]) {
        for (int i = 0; i < kRim; ++i) {
          const Pair inner = pairOf(chainAt(k), i), outer = pairOf(chainAt(k), i + 1);
          inside(k) ? addWall(inner, outer) : addWall(outer, inner);
        }
      }
      if (!inside(k)) continue;
      // From here to the edge where the line comes in again lies a strip along the outline.
      int in = k + 1;
      while (!inside(in + 1)) ++in;
      const Chain& leaves = chainAt(k);
      const Chain& enters = chainAt(in % 4);
      for (int i = 0; i < kRim; ++i) {
        addFace(pairOf(leaves, i), pairOf(leaves, i + 1), pairOf(enters, i + 1));
        if (i > 0 || leaves.front[0] != enters.front[0])
          addFace(pairOf(leaves, i), pairOf(enters, i + 1), pairOf(enters, i));
      }
    }
  }

  Frame frame_;
  std::array<bool, 4> open_ = {true, true, true, true};  ///< the body goes on beyond this border
  int columns_ = 0, rows_ = 0;
  double left_ = 0, top_ = 0, step_x_ = 0, step_y_ = 0;
  std::vector<char> inside_;          ///< of each node
  std::vector<Chain> chains_;         ///< of each edge of the grid that crosses the outline
  std::vector<std::uint32_t> along_;  ///< chain of the edge from a node to the right
  std::vector<std::uint32_t> down_;   ///< and of that down
  std::vector<double> u_;
  double swell_ = 1;
  std::vector<std::uint32_t> front_, back_;  ///< vertices of each node
  Solid out_;
};

}  // namespace

Solid solidOf(const std::vector<Point>& outline, const Frame& frame, std::optional<double> breadth, int cells) {
  return Balloon(outline, frame, cells).solid(breadth);
}

Spot wayAt(const procedure::Picture& picture, double place_mm) {
  const Point at = procedure::placeAt(picture, place_mm);
  const auto& mm = picture.way_mm;
  const double place = std::clamp(place_mm, mm.front(), mm.back());
  const auto i = static_cast<std::size_t>(std::upper_bound(mm.begin() + 1, mm.end() - 1, place) - mm.begin());
  const double share = (place - mm[i - 1]) / (mm[i] - mm[i - 1]);
  return {at.x, at.y, std::lerp(picture.way_across[i - 1], picture.way_across[i], share)};
}

std::vector<Spot> wayBetween(const procedure::Picture& picture, double from_mm, double to_mm) {
  std::vector<Spot> out = {wayAt(picture, from_mm)};
  for (std::size_t i = 0; i < picture.way.size(); ++i) {
    if (picture.way_mm[i] > from_mm && picture.way_mm[i] < to_mm)
      out.push_back({picture.way[i].x, picture.way[i].y, picture.way_across[i]});
  }
  out.push_back(wayAt(picture, to_mm));
  return out;
}

std::vector<Spot> toolTo(const procedure::Picture& picture, double depth_mm, double outside) {
  const double begin_mm = picture.way_mm.front();
  const Spot enters = wayAt(picture, begin_mm);
  const Spot next = wayAt(picture, begin_mm + 0.02 * (picture.way_mm.back() - begin_mm));
  const double dx = next.x - enters.x, dy = next.y - enters.y, length = std::max(std::hypot(dx, dy), 1e-9);
  const auto before = [&](double distance) {
    return Spot{enters.x - distance * dx / length, enters.y - distance * dy / length, enters.z};
  };
  std::vector<Spot> out;
  for (const procedure::Point& point : picture.approach) out.push_back({point.x, point.y, enters.z});
  if (out.empty()) out = {before(outside), before(depth_mm < begin_mm ? outside / 2 : 0)};
  if (depth_mm > begin_mm) {
    const auto way = wayBetween(picture, begin_mm, depth_mm);
    out.insert(out.end(), way.begin(), way.end());
  }
  return out;
}

Turn frontTurn(procedure::FrontSide front) {
  switch (front) {
    case procedure::FrontSide::kLeft: return {90, 0};
    case procedure::FrontSide::kRight: return {-90, 0};
    case procedure::FrontSide::kTop: return {0, 90};
    case procedure::FrontSide::kBottom: break;
  }
  return {0, -90};
}

Projection::Projection(const Turn& turn, const Spot& center, double scale, double x, double y)
    : center_(center), scale_(scale), x_(x), y_(y) {
  // Whole turns are left out before the sines, so that they change nothing at all.
  const double yaw = std::remainder(turn.yaw_deg, 360) * std::numbers::pi / 180;
  const double pitch = std::remainder(turn.pitch_deg, 360) * std::numbers::pi / 180;
  const double cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
  rows_ = {cy, 0, sy, -sy * sp, cp, cy * sp, -sy * cp, -sp, cy * cp};
}

Spot Projection::turned(const Spot& d) const {
  return {rows_[0] * d.x + rows_[1] * d.y + rows_[2] * d.z, rows_[3] * d.x + rows_[4] * d.y + rows_[5] * d.z,
          rows_[6] * d.x + rows_[7] * d.y + rows_[8] * d.z};
}

Spot Projection::operator()(const Spot& at) const {
  const Spot t = turned(minus(at, center_));
  return {x_ + scale_ * t.x, y_ + scale_ * t.y, scale_ * t.z};
}

}  // namespace tactus::workbench::anatomy
