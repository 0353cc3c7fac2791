#include "core/analysis/centroid_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/fuzzy/gaussian_pieces.h"

namespace tactus::analysis {
namespace {

double sampledCentroid(const fuzzy::CompiledModel& model, std::size_t expert, std::span<const double> strengths,
                       const Sampling& sampling) {
  const auto terms = model.outputTerms(expert);
  const double lo = model.outputMin();
  const double width = model.outputMax() - lo;
  const bool clip = model.implication() == fuzzy::Implication::kClip;
  const bool midpoint = sampling.rule == Sampling::Rule::kMidpoint;
  double area = 0;
  double moment = 0;
  for (std::size_t i = 0; i < sampling.count; ++i) {
    const double share = midpoint ? (static_cast<double>(i) + 0.5) / static_cast<double>(sampling.count)
                                  : static_cast<double>(i) / static_cast<double>(sampling.count - 1);
    const double x = lo + width * share;
    double height = 0;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (strengths[t] == 0) continue;
      const double membership = terms[t](x);
      height = std::max(height, clip ? std::min(strengths[t], membership) : strengths[t] * membership);
    }
    area += height;
    moment += height * x;
  }
  return moment / area;
}

}  // namespace

fuzzy::Evaluation evaluateSampled(const fuzzy::CompiledModel& model, std::span<const double> inputs,
                                  const Sampling& sampling, std::optional<std::size_t> expert) {
  const auto exact = expert ? model.evaluateExpert(*expert, inputs) : model.evaluate(inputs);
  if (!exact.fired) return exact;
  double weights = 0;
  double sum = 0;
  std::array<double, fuzzy::kMostTerms> strengths{};
  for (std::size_t e = expert.value_or(0); e < (expert ? *expert + 1 : model.expertCount()); ++e) {
    const double weight = expert ? 1 : model.normalizedWeight(e);
    if (weight == 0 || !model.strengths(e, inputs, strengths)) continue;
    weights += weight;
    sum += weight * sampledCentroid(model, e, strengths, sampling);
  }
  return {sum / weights, true};
}

namespace {

// Moments below this lose digits.
constexpr double kTiny = 1e-280;

/// Adds the moment of a line from height y0 at x0 to y1 at x1; the piece lies on one side of `about`.
void addPiece(double x0, double x1, double y0, double y1, double about, Moments& out) {
  if (x1 <= x0) return;
  const double moment = (x1 - x0) * ((x0 - about) * (2 * y0 + y1) + (x1 - about) * (y0 + 2 * y1)) / 6;
  (moment < 0 ? out.left : out.right) += std::abs(moment);
}

/// Adds a line from height y0 at x0 to y1 at x1, cut to [0, width] and at `about`.
void addLine(double x0, double x1, double y0, double y1, double about, double width, Moments& out) {
  if (x1 <= x0) return;
  const auto at = [&](double x) { return y0 + (y1 - y0) * ((x - x0) / (x1 - x0)); };
  const double from = std::clamp(x0, 0.0, width);
  const double to = std::clamp(x1, 0.0, width);
  const double middle = std::clamp(about, from, to);
  addPiece(from, middle, at(from), at(middle), about, out);
  addPiece(middle, to, at(middle), at(to), about, out);
}

/// Adds the part of a Gaussian, relative to `strength`, between x0 and x1, cut to [0, width] and at `about`. Sums of
/// positive masses, exact to rounding (gaussian_pieces.h).
void addTail(const BoundedTerm& term, double strength, double x0, double x1, double about, double width, Moments& out) {
  const fuzzy::CurvePiece curve{true, 0, 0, 0, term.b, term.sigma, -std::log(strength)};
  const double from = std::clamp(x0, 0.0, width);
  const double to = std::clamp(x1, 0.0, width);
  const double middle = std::clamp(about, from, to);
  const auto add = [&](double x, double mass) { (x < about ? out.left : out.right) += mass * std::abs(x - about); };
  fuzzy::visitGaussianMasses(curve, from, middle, add);
  fuzzy::visitGaussianMasses(curve, middle, to, add);
}

}  // namespace

Moments momentsOf(const BoundedTerm& term, double strength, double about, double width) {
  Moments out;
  if (term.gaussian()) {
    const double plateau = term.reachAt(strength);
    // Beyond this the tail is e^-60 of the highest point in the universe, far below rounding.
    const double nearest = std::max({plateau, -term.b, term.b - width});
    const double end = std::sqrt(nearest * nearest + 120 * term.sigma * term.sigma);
    addTail(term, strength, term.b - end, term.b - plateau, about, width, out);
    addLine(term.b - plateau, term.b + plateau, 1, 1, about, width, out);
    addTail(term, strength, term.b + plateau, term.b + end, about, width, out);
    if (out.left + out.right < kTiny)
      out.left = std::numeric_limits<double>::infinity();  // too far away to be computed: nothing is proved
    return out;
  }
  const double left = std::min(term.b, term.a + strength * (term.b - term.a));
  const double right = std::max(term.c, term.d - strength * (term.d - term.c));
  addLine(term.a, left, 0, 1, about, width, out);
  addLine(left, right, 1, 1, about, width, out);
  addLine(right, term.d, 1, 0, about, width, out);
  return out;
}

namespace {

/// The cuts of a term at the heights up to its largest strength. Their ends, as the universe shows them, are piecewise
/// linear in a level that rises with the height: the height itself for a trapezoid, the reach from the mean with the
/// sign turned for a Gaussian.
class Cuts {
 public:
  Cuts(const BoundedTerm& term, double width) : term_(term), width_(width) {
    if (term.gaussian()) {
      const double top = -term.reachAt(term.strength);
      const double bottom = std::min(top, -fuzzy::kGaussianReach * term.sigma);
      corners_ = {bottom, std::clamp(-term.b, bottom, top), std::clamp(term.b - width, bottom, top), top};
    } else {
      corners_ = {0, term.strength, term.strength, term.strength};
      if (term.a < 0 && term.b > term.a) corners_[1] = std::min(term.strength, -term.a / (term.b - term.a));
      if (term.d > width && term.d > term.c)
        corners_[2] = std::min(term.strength, (term.d - width) / (term.d - term.c));
    }
    std::sort(corners_.begin(), corners_.end());
  }

  /// Levels between which the ends are linear, from the lowest to the highest.
  const std::array<double, 4>& corners() const { return corners_; }
  double heightAt(double level) const {
    if (!term_.gaussian()) return level;
    const double u = level / term_.sigma;
    return level == corners_.back() ? term_.strength : std::exp(-0.5 * u * u);
  }
  double left(double level) const {
    return std::max(0.0, term_.gaussian() ? term_.b + level : term_.a + level * (term_.b - term_.a));
  }
  double right(double level) const {
    return std::min(width_, term_.gaussian() ? term_.b - level : term_.d - level * (term_.d - term_.c));
  }

 private:
  const BoundedTerm& term_;
  double width_;
  std::array<double, 4> corners_;
};

/// The smallest weight of the right-hand side with which the term has no negative moment about `about` at any strength
/// in (0, largest], clip. The moment as a function of the strength is the integral of that of the cuts, whose sign
/// changes where a piecewise linear function does, so its minimum lies at a zero of that function, at one of its
/// corners or at the largest strength; the weight is found by Dinkelbach's iteration (1967) for the largest ratio.
double weightForClip(const BoundedTerm& term, double about, double width) {
  const Cuts cuts(term, width);
  const auto& corners = cuts.corners();

  double weight = 0;
  const auto consider = [&](double level) {
    const double strength = cuts.heightAt(level);
    if (strength > 0) weight = std::max(weight, momentsOf(term, strength, about, width).ratio());
  };
  // Strengths toward 0: the whole support, and of a Gaussian also the whole universe.
  const auto consider_cut = [&](double left, double right) {
    const double ratio =
        right > about ? std::max(0.0, about - left) / (right - about) : std::numeric_limits<double>::infinity();
    weight = std::max(weight, ratio * ratio);
  };
  consider_cut(cuts.left(corners[0]), cuts.right(corners[0]));
  if (term.gaussian()) consider_cut(0, width);
  for (const double corner : corners) consider(corner);
  for (int round = 0; round < 50 && weight <= 1; ++round) {
    const double before = weight;
    const double root = std::sqrt(weight);
    const auto sign = [&](double level) { return root * (cuts.right(level) - about) + (cuts.left(level) - about); };
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const double y0 = sign(corners[k - 1]);
      const double y1 = sign(corners[k]);
      if (y0 < 0 && y1 > 0) consider(corners[k - 1] + (corners[k] - corners[k - 1]) * (y0 / (y0 - y1)));
    }
    if (weight <= before * (1 + 1e-14)) break;
  }
  return weight;
}

}  // namespace

double lowerCentroidBound(const std::vector<BoundedTerm>& terms, bool clip, double width) {
  const auto proved = [&](double about) {
    double weights = 0;
    for (const auto& term : terms) {
      if (std::max(term.a, 0.0) >= about) continue;
      if (std::min(term.d, width) <= about) return false;  // also where it is too narrow to have a moment
      weights += clip ? weightForClip(term, about, width) : momentsOf(term, 1, about, width).ratio();
      if (weights > 1) return false;
    }
    return true;
  };
  double low = width;
  for (const auto& term : terms) low = std::min(low, std::max(term.a, 0.0));
  double high = width;
  // To an accuracy below the rounding that is taken off in the end.
  while (high - low > width * (kRounding / 4)) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (proved(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace tactus::analysis
