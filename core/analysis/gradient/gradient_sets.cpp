#include "core/analysis/gradient/gradient_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fuzzy/gaussian_pieces.h"

namespace tactus::analysis {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

}  // namespace

ImpliedSet ImpliedSet::of(const fuzzy::ActiveTerm& term, fuzzy::Implication implication, double largest) noexcept {
  const auto& f = *term.function;
  const bool scale = implication == fuzzy::Implication::kScale;
  const double s = scale ? 1 : term.strength;
  // Finite also below the normal range, so that 0 times it is 0.
  const double ramp_height = scale ? term.height : std::min(1 / largest, kLargest);
  if (!f.gaussian) return {fuzzy::ImpliedTrapezoid::of(f, s, term.height, ramp_height), 0};
  const double plateau = f.sigma * std::sqrt(-2 * std::log(s));
  return {{&f,
           term.height,
           ramp_height,
           {f.mean - fuzzy::kGaussianReach * f.sigma},
           {f.mean - plateau},
           {f.mean + plateau},
           {f.mean + fuzzy::kGaussianReach * f.sigma}},
          std::log(ramp_height)};
}

double ImpliedSet::at(const Position& x) const noexcept {
  const auto& f = *function;
  if (!f.gaussian) return ImpliedTrapezoid::at(x);
  if (x >= top_left && x <= top_right) return height;
  const double u = (x.high - f.mean) / f.sigma;
  return std::min(height, std::exp(log_ramp - 0.5 * u * u));
}

Line Line::of(std::size_t index, const ImpliedSet& set, const Position& x0, const Position& x1) noexcept {
  const auto& f = *set.function;
  const double y0 = set.at(x0);
  const double y1 = set.at(x1);
  const bool rises = x1 <= set.top_left;
  if (!rises && x0 < set.top_right) return {index, Part::kTop, y0, y1, 0, 1, 1, 0, 0};

  // A ramp hangs between its foot, where the term is 0, and its shoulder, where it is 1.
  const Position& foot = rises ? set.left : set.right;
  const Position shoulder{rises ? f.b : f.c};
  const double width = std::abs(rises ? f.b - f.a : f.d - f.c);
  const auto part = [width](const Position& from, const Position& to) { return std::abs(to.minus(from)) / width; };
  const bool whole = rises ? x0 == set.left && x1 == set.top_left : x0 == set.top_right && x1 == set.right;
  return {index,
          rises ? Part::kRise : Part::kFall,
          y0,
          y1,
          whole ? set.height : part(x0, x1) * set.ramp_height,
          part(foot, x0),
          part(foot, x1),
          part(shoulder, x0),
          part(shoulder, x1)};
}

GradientSums::GradientSums(std::span<const ImpliedSet> sets, fuzzy::Implication implication) noexcept
    : sets_(sets), scale_(implication == fuzzy::Implication::kScale) {
  std::fill_n(of_set_.begin(), sets.size(), std::array<Integral, 5>{});
}

void GradientSums::addLine(const Line& line, double x0, double width, double t0, double t1) noexcept {
  const auto between = [](double from, double to, double t) { return from + t * (to - from); };
  // Of a linear function over the piece: its mean, and the mean of its product with the way through the piece.
  struct Mean {
    double value, first;
  };
  const auto mean = [&](double from, double to) -> Mean {
    const double p0 = between(from, to, t0);
    const double p1 = between(from, to, t1);
    return {(p0 + p1) / 2, (p0 + 2 * p1) / 6};
  };
  const double share = t1 - t0;
  const double x = x0 + t0 * width;
  const double piece_width = share * width;

  const Mean height = mean(line.y0, line.y1);
  const double mass = piece_width * height.value;
  const double moment = mass * x + piece_width * piece_width * height.first;
  whole_.mass += mass;
  whole_.moment += moment;
  if (scale_ || line.part == Part::kTop) add(line.set, kStrength, mass, moment);
  if (line.part == Part::kTop) return;

  // dA/da = -(1 - membership) / (b - a) and dA/db = -membership / (b - a), with dy = (b - a) d(membership).
  const double climb = share * line.climb * (line.part == Part::kRise ? -1 : 1);
  const std::size_t outer = line.part == Part::kRise ? 0 : 3;
  const std::size_t inner = line.part == Part::kRise ? 1 : 2;
  const Mean rest = mean(line.rest0, line.rest1);
  const Mean membership = mean(line.share0, line.share1);
  add(line.set, outer, climb * rest.value, climb * (rest.value * x + rest.first * piece_width));
  add(line.set, inner, climb * membership.value, climb * (membership.value * x + membership.first * piece_width));
}

void GradientSums::addGaussianMass(std::size_t set, double x, double mass, double u) noexcept {
  const double sigma = sets_[set].function->sigma;
  whole_.mass += mass;
  whole_.moment += mass * x;
  if (scale_) add(set, kStrength, mass, mass * x);
  const double by_mean = mass * u / sigma;
  add(set, 0, by_mean, by_mean * x);
  add(set, 1, by_mean * u, by_mean * u * x);
}

void GradientSums::addEdge(std::size_t set, std::size_t outer, std::size_t inner, double x, double outer_from,
                           double inner_from) noexcept {
  const double height = sets_[set].height;
  const double top = height / sets_[set].ramp_height;
  const double sign = outer == 0 ? -1 : 1;
  const auto add_from = [&](std::size_t point, double from) {
    if (from >= height) return;
    const double membership = (from / sets_[set].ramp_height + top) / 2;
    const double mass = sign * (height - from) * (point == outer ? 1 - membership : membership);
    add(set, point, mass, mass * x);
  };
  add_from(outer, outer_from);
  add_from(inner, inner_from);
}

void GradientSums::addVerticalEdges(double lo, double hi, const Position& origin) noexcept {
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    const ImpliedSet& set = sets_[i];
    const auto& f = *set.function;
    if (f.gaussian) continue;
    // A moved vertex makes a ramp on its side of the edge, which counts where it is above the other sets.
    const auto highest_left = [&](const Position& x) {
      if (x.high <= lo) return kLargest;
      double highest = 0;
      for (const auto& other : sets_) {
        if (&other != &set) highest = std::max(highest, other.leftLimit(x));
      }
      return highest;
    };
    const auto highest_right = [&](const Position& x) {
      if (x.high >= hi) return kLargest;
      double highest = 0;
      for (const auto& other : sets_) {
        if (&other != &set) highest = std::max(highest, other.rightLimit(x));
      }
      return highest;
    };
    if (set.left == set.top_left && f.a >= lo && f.a <= hi)
      addEdge(i, 0, 1, set.left.minus(origin), highest_left(set.left), highest_right(set.left));
    if (set.right == set.top_right && f.d >= lo && f.d <= hi)
      addEdge(i, 3, 2, set.right.minus(origin), highest_right(set.right), highest_left(set.right));
  }
}

double GradientSums::finish(std::span<SetGradient> out) const noexcept {
  const double centroid = whole_.moment / whole_.mass;
  const auto derivative = [&](const Integral& sum) { return (sum.moment - centroid * sum.mass) / whole_.mass; };
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    for (std::size_t p = 0; p < 4; ++p) out[i].points[p] = derivative(of_set_[i][p]);
    out[i].log_strength = derivative(of_set_[i][kStrength]);
  }
  return centroid;
}

}  // namespace tactus::analysis
