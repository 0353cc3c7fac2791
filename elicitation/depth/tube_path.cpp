#include "elicitation/depth/tube_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;

// Gauss and Legendre's five points on [0, 1]: exact for polynomials of degree 9 (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 5> kNodes = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                          0.95308992296933200};
constexpr std::array<double, 5> kWeights = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                            0.23931433524968324, 0.11846344252809454};
constexpr int kPieces = 4;     // of a gap for its length: far below a thousandth of a millimeter
constexpr int kLooks = 16;     // places of a gap at which the nearest one is looked for first
constexpr int kHalvings = 48;  // of a bracket: to the last digits

bool isFinite(const ImagePoint& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

/// The second derivatives of the natural spline through `values` over gaps of the lengths `h` (Thomas' algorithm).
std::vector<double> naturalBends(const std::vector<double>& values, const std::vector<double>& h) {
  const std::size_t n = values.size();
  std::vector<double> bends(n, 0.0);
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double right = 6 * ((values[i + 1] - values[i]) / h[i] - (values[i] - values[i - 1]) / h[i - 1]);
    const double pivot = 2 * (h[i - 1] + h[i]) - h[i - 1] * upper[i - 1];
    upper[i] = h[i] / pivot;
    bends[i] = (right - h[i - 1] * bends[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bends[i] -= upper[i] * bends[i + 1];
  return bends;
}

}  // namespace

double distance(const ImagePoint& one, const ImagePoint& other) { return std::hypot(one.x - other.x, one.y - other.y); }

base::Result<double> mmPerPixel(const ImagePoint& one, const ImagePoint& other, double length_mm) {
  if (!(std::isfinite(length_mm) && length_mm > 0)) {
    return fail(ErrorCode::kValue, "known length", base::formatNumber(length_mm), "a length above 0 mm");
  }
  const double length_px = distance(one, other);
  if (!(length_px >= 1)) {
    return fail(ErrorCode::kValue, "known length", "points less than a pixel apart", "two ends of a line on the image");
  }
  return length_mm / length_px;
}

base::Result<TubePath> TubePath::through(std::vector<ImagePoint> points, double mm_per_px) {
  if (points.size() < 2) {
    return fail(ErrorCode::kData, "path of the tube", std::to_string(points.size()) + " points", "at least two");
  }
  if (!(std::isfinite(mm_per_px) && mm_per_px > 0)) {
    return fail(ErrorCode::kValue, "scale of the image", base::formatNumber(mm_per_px) + " mm per pixel",
                "a number above 0");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string place = "point " + std::to_string(i + 1) + " of the path";
    if (!isFinite(points[i]))
      return fail(ErrorCode::kValue, place, "a number that is not finite", "a place on the image");
    if (i > 0 && !(distance(points[i - 1], points[i]) > 0)) {
      return fail(ErrorCode::kData, place, "the same place as the point before", "another place");
    }
  }
  return TubePath(std::move(points), mm_per_px);
}

TubePath::TubePath(std::vector<ImagePoint> points, double mm_per_px)
    : points_(std::move(points)), mm_per_px_(mm_per_px) {
  std::vector<double> x;
  std::vector<double> y;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) chords_px_.push_back(distance(points_[i - 1], points_[i]));
    x.push_back(points_[i].x);
    y.push_back(points_[i].y);
  }
  const std::vector<double> x_bends = naturalBends(x, chords_px_);
  const std::vector<double> y_bends = naturalBends(y, chords_px_);
  for (std::size_t i = 0; i < points_.size(); ++i) bends_.push_back({x_bends[i], y_bends[i]});
  lengths_mm_.push_back(0);
  for (std::size_t gap = 0; gap < chords_px_.size(); ++gap) {
    lengths_mm_.push_back(lengths_mm_.back() + lengthIn(gap, 1));
  }
}

ImagePoint TubePath::place(std::size_t gap, double t) const {
  const double h = chords_px_[gap];
  const double s = 1 - t;
  const auto one = [&](double from, double to, double from_bend, double to_bend) {
    return s * from + t * to + h * h / 6 * ((s * s * s - s) * from_bend + (t * t * t - t) * to_bend);
  };
  const ImagePoint& a = points_[gap];
  const ImagePoint& b = points_[gap + 1];
  return {one(a.x, b.x, bends_[gap].x, bends_[gap + 1].x), one(a.y, b.y, bends_[gap].y, bends_[gap + 1].y)};
}

ImagePoint TubePath::slope(std::size_t gap, double t) const {
  const double h = chords_px_[gap];
  const double s = 1 - t;
  const auto one = [&](double from, double to, double from_bend, double to_bend) {
    return to - from + h * h / 6 * ((1 - 3 * s * s) * from_bend + (3 * t * t - 1) * to_bend);
  };
  const ImagePoint& a = points_[gap];
  const ImagePoint& b = points_[gap + 1];
  return {one(a.x, b.x, bends_[gap].x, bends_[gap + 1].x), one(a.y, b.y, bends_[gap].y, bends_[gap + 1].y)};
}

double TubePath::lengthIn(std::size_t gap, double t) const {
  double sum = 0;
  for (int piece = 0; piece < kPieces; ++piece) {
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const ImagePoint along = slope(gap, t * (piece + kNodes[i]) / kPieces);
      sum += kWeights[i] * std::hypot(along.x, along.y);
    }
  }
  return sum * t / kPieces * mm_per_px_;
}

TubePath::Place TubePath::placeAt(double depth_mm) const {
  if (depth_mm <= 0) return {0, 0};
  if (depth_mm >= lengthMm()) return {chords_px_.size() - 1, 1};
  const auto next = std::upper_bound(lengths_mm_.begin(), lengths_mm_.end(), depth_mm);
  const auto gap = static_cast<std::size_t>(next - lengths_mm_.begin()) - 1;
  const double wanted_mm = depth_mm - lengths_mm_[gap];
  double low = 0;
  double high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (lengthIn(gap, middle) < wanted_mm ? low : high) = middle;
  }
  return {gap, (low + high) / 2};
}

TubePath::Place TubePath::placeNear(const ImagePoint& near) const {
  Place best{0, 0};
  double nearest = distance(points_.front(), near);
  for (std::size_t gap = 0; gap < chords_px_.size(); ++gap) {
    for (int i = 1; i <= kLooks; ++i) {
      const double t = static_cast<double>(i) / kLooks;
      const double away = distance(place(gap, t), near);
      if (away >= nearest) continue;
      nearest = away;
      best = {gap, t};
    }
  }
  // The distance has one minimum between the neighbors of the best place.
  double low = std::max(0.0, best.t - 1.0 / kLooks);
  double high = std::min(1.0, best.t + 1.0 / kLooks);
  for (int i = 0; i < kHalvings; ++i) {
    const double left = low + (high - low) / 3;
    const double right = high - (high - low) / 3;
    if (distance(place(best.gap, left), near) < distance(place(best.gap, right), near)) {
      high = right;
    } else {
      low = left;
    }
  }
  return {best.gap, (low + high) / 2};
}

ImagePoint TubePath::at(double depth_mm) const {
  const Place where = placeAt(depth_mm);
  return place(where.gap, where.t);
}

ImagePoint TubePath::direction(double depth_mm) const {
  const Place where = placeAt(depth_mm);
  const ImagePoint along = slope(where.gap, where.t);
  const double length = std::hypot(along.x, along.y);
  return length > 0 ? ImagePoint{along.x / length, along.y / length} : ImagePoint{1, 0};
}

double TubePath::depthNear(const ImagePoint& near) const {
  const Place where = placeNear(near);
  return lengths_mm_[where.gap] + lengthIn(where.gap, where.t);
}

double TubePath::depthOfPoint(std::size_t index) const { return lengths_mm_[index]; }

std::size_t TubePath::gapNear(const ImagePoint& near) const { return placeNear(near).gap; }

std::vector<ImagePoint> TubePath::outline(double step_mm) const {
  std::vector<ImagePoint> line = {points_.front()};
  for (std::size_t gap = 0; gap < chords_px_.size(); ++gap) {
    const double length_mm = lengths_mm_[gap + 1] - lengths_mm_[gap];
    const int pieces = std::max(1, static_cast<int>(std::ceil(length_mm / step_mm)));
    for (int i = 1; i <= pieces; ++i) line.push_back(place(gap, static_cast<double>(i) / pieces));
  }
  return line;
}

}  // namespace tactus::elicitation
