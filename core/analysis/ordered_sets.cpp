#include "core/analysis/ordered_sets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace tactus::analysis {
namespace {

using fuzzy::MembershipFunction;

/// Of the universe. Narrower sets and ramps lose digits in differences of positions.
constexpr double kSmallestWidth = 1e-3;

/// A term as the universe shows it, and which of its vertices that is.
struct Cut {
  double a, b, c, d;
  std::array<double, 4> moves;
  std::size_t term;

  double rise() const { return b - a; }
  double fall() const { return d - c; }
  auto key() const { return std::tuple(a, b, c, d); }
};

std::optional<Cut> cutToUniverse(const MembershipFunction& f, double lo, double hi, std::size_t term) {
  if (f.gaussian) return std::nullopt;
  Cut cut{f.a, f.b, f.c, f.d, {1, 1, 1, 1}, term};
  // An edge on the border can move inwards only; what lies beyond it does not show.
  if (f.b <= lo) {
    cut.a = cut.b = lo;
    cut.moves[0] = 0;
    cut.moves[1] = f.a == lo ? 1 : 0;
  }
  if (f.c >= hi) {
    cut.c = cut.d = hi;
    cut.moves[2] = f.d == hi ? 1 : 0;
    cut.moves[3] = 0;
  }
  const bool inside = cut.a >= lo && cut.d <= hi && cut.a <= cut.b && cut.b <= cut.c && cut.c <= cut.d;
  return inside ? std::optional(cut) : std::nullopt;
}

bool isWide(const Cut& f, double smallest) {
  const auto fine = [smallest](double width) { return width == 0 || width >= smallest; };
  return f.d - f.a >= smallest && fine(f.rise()) && fine(f.fall());
}

/// Whether f and the later g are in order and no line of one coincides with a line of the other.
bool areApart(const Cut& f, const Cut& g) {
  const bool ordered = f.a <= g.a && f.b <= g.b && f.c <= g.c && f.d <= g.d;
  const bool same_rise = f.a == g.a && f.b == g.b;
  const bool same_fall = f.c == g.c && f.d == g.d;
  const bool back_to_back = f.c == f.d && g.a == g.b && f.d == g.a;
  return ordered && !same_rise && !same_fall && !back_to_back;
}

/// Height at which the fall of f and the rise of g cross.
double peakOf(const Cut& f, const Cut& g) {
  const double overlap = std::max(0.0, f.d - g.a);
  const double ramps = g.rise() + f.fall();
  return ramps > overlap ? overlap / ramps : overlap > 0 ? 1 : 0;
}

double membership(const Cut& f, double x) { return MembershipFunction{false, f.a, f.b, f.c, f.d, 0, 1}(x); }

/// The smallest strength with which `middle` is at least as high as the lower one of f and g wherever both are > 0;
/// they reach no higher than their peak there.
double coverOf(const Cut& f, const Cut& middle, const Cut& g, bool clip) {
  if (f.d <= g.a) return 0;
  const double peak = peakOf(f, g);
  const double least = std::min(membership(middle, g.a), membership(middle, f.d));
  if (clip) return least >= peak ? peak : 2;
  return least > 0 ? peak / least : 2;
}

/// With this ratio a set also covers one of equal strength.
constexpr double kJustBelowOne = 1 - std::numeric_limits<double>::epsilon();

/// Puts a position out of reach unless a condition holds: a branch could not be foreseen.
constexpr double kAway[2] = {std::numeric_limits<double>::infinity(), 0};

/// An integral and its first moment.
template <class Number>
struct Sum {
  Number mass, moment;
};

TwoRamps both(double x) { return TwoRamps{x, x}; }
double sum(TwoRamps x) { return x[0] + x[1]; }

}  // namespace

std::optional<OrderedSets> OrderedSets::of(std::span<const MembershipFunction> terms, std::span<const TermSlots> slots,
                                           double lo, double hi, fuzzy::Implication implication) {
  // Outside these widths the products of the polynomials could leave the range of double.
  const double width = hi - lo;
  if (terms.size() > kMostLanes || !(width > 1e-30 && width < 1e30)) return std::nullopt;
  std::vector<Cut> cuts;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto cut = cutToUniverse(terms[t], lo, hi, t);
    if (!cut || !isWide(*cut, kSmallestWidth * width)) return std::nullopt;
    cuts.push_back(*cut);
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& f, const Cut& g) { return f.key() < g.key(); });

  OrderedSets out;
  out.lo_ = lo;
  out.clip_ = implication == fuzzy::Implication::kClip;
  out.lane_of_.resize(terms.size());
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const Cut& f = cuts[k];
    Lane lane{
        {f.a, f.d}, {f.rise(), f.fall()}, {f.rise(), -f.fall()}, {-f.moves[0], f.moves[3]}, {-f.moves[1], f.moves[2]},
        {},         kSmallestStrength,    slots[f.term]};
    out.lane_of_[f.term] = k;
    for (std::size_t next = k + 1; next < cuts.size(); ++next) {
      const Cut& g = cuts[next];
      const double overlap = std::max(0.0, f.d - g.a);
      if (!areApart(f, g) || (overlap > 0 && next > k + 2)) return std::nullopt;
      if (next > k + 2) continue;
      // Scaled ramps keep their feet, so that two of them cross within their overlap whatever the strengths.
      if (!out.clip_ && overlap > std::min(g.rise(), f.fall())) return std::nullopt;
      lane.pairs[next - k - 1] = {overlap, peakOf(f, g), f.term < g.term ? 1 : kJustBelowOne};
    }
    if (k > 0 && k + 1 < cuts.size())
      lane.cover = std::max(lane.cover, coverOf(cuts[k - 1], f, cuts[k + 1], out.clip_));
    out.lanes_.push_back(lane);
  }
  out.lanes_.emplace_back();
  return out;
}

/// What shows of one set: integrals over the heights m of the term that show. Positions are measured from the first
/// active set.
struct OrderedSets::Shown {
  Sum<TwoRamps> one;     ///< of 1, on each ramp
  Sum<TwoRamps> height;  ///< of m
  Sum<double> top;       ///< the plateau, per unit of height
};

std::optional<double> OrderedSets::centroid(const Strengths& strength, std::uint64_t active,
                                            Gradients& out) const noexcept {
  return clip_ ? centroidOf<true>(strength, active, out) : centroidOf<false>(strength, active, out);
}

template <bool clip>
std::optional<double> OrderedSets::centroidOf(const Strengths& strength, std::uint64_t active,
                                              Gradients& out) const noexcept {
  const std::uint64_t end = std::uint64_t{1} << count();
  const double origin = lanes_[static_cast<std::size_t>(std::countr_zero(active))].foot[0];
  std::array<Shown, kMostLanes> sets;
  Sum<double> whole{0, 0};
  bool known = true;

  const Lane* before = &lanes_.back();
  const Pair* pair_before = &before->pairs[0];
  double s_before = 0;
  bool left_covered = false;
  Shown* set = sets.data();
  for (std::uint64_t left = active | end; left != end; ++set) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    left &= left - 1;
    const auto next = static_cast<std::size_t>(std::countr_zero(left));
    const Lane& lane = lanes_[k];
    const Lane& after = lanes_[next];
    const Pair& pair_after = lane.pairs[std::min<std::size_t>(next - k - 1, 2)];
    const double s = strength[k];
    const double s_after = strength[next];
    const TwoRamps foot = lane.foot - origin;
    const double top = clip ? s : 1;
    // Where the two neighbors do not reach each other any strength covers their overlap.
    if (s < lane.cover) known = known && s >= kSmallestStrength && (s_before == 0 || s_after == 0);

    // The ramps show from these heights on.
    TwoRamps from;
    if constexpr (clip) {
      from =
          TwoRamps{std::min(std::min(s_before, s), pair_before->peak), std::min(std::min(s_after, s), pair_after.peak)};
    } else {
      const auto crossing = [](double overlap, double lower, double fall, double upper, double rise) {
        return overlap > 0 ? overlap / (lower * rise + upper * fall) : 0;
      };
      from = TwoRamps{s_before * crossing(pair_before->overlap, s_before, before->width[1], s, lane.width[0]),
                      s_after * crossing(pair_after.overlap, s, lane.width[1], s_after, after.width[0])};
    }
    const TwoRamps zeroth = top - from;
    const TwoRamps first = zeroth * (top + from) * both(0.5);
    const TwoRamps second = zeroth * (top * (top + from) + from * from) * both(1.0 / 3);
    set->one = {zeroth, foot * zeroth + lane.inwards * first};
    set->height = {first, foot * first + lane.inwards * second};

    const TwoRamps shoulder = foot + top * lane.inwards;
    double left_end = shoulder[0];
    double right_end = shoulder[1];
    if constexpr (clip) {
      // A higher neighbor covers an end of the plateau; of equal ones the first in the model counts.
      const double neighbor_right = before->foot[1] - origin - s * before->width[1];
      const double neighbor_left = after.foot[0] - origin + s * after.width[0];
      const bool right_covered = s_after > s * pair_after.least_ratio;
      left_end = std::max(left_end, neighbor_right - kAway[left_covered]);
      right_end = std::min(right_end, neighbor_left + kAway[right_covered]);
      left_covered = !right_covered;
    }
    const double width = std::max(0.0, right_end - left_end);
    set->top = {width, width * (left_end + right_end) * 0.5};

    const double height = clip ? 1 : s;
    whole.mass += height * (sum(lane.width * set->height.mass) + top * set->top.mass);
    whole.moment += height * (sum(lane.width * set->height.moment) + top * set->top.moment);
    before = &lane;
    pair_before = &pair_after;
    s_before = s;
  }
  if (!known) return std::nullopt;

  const double inverse = 1 / whole.mass;
  const double centroid = whole.moment * inverse;
  const auto derivative = [&](const auto& sum) { return (sum.moment - centroid * sum.mass) * inverse; };
  set = sets.data();
  for (std::uint64_t left = active; left != 0; left &= left - 1, ++set) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left));
    const Lane& lane = lanes_[k];
    const double height = clip ? 1 : strength[k];
    const TwoRamps by_one = derivative(set->one);
    const TwoRamps by_height = derivative(set->height);
    const double by_top = derivative(set->top);
    // A ramp moves by 1 - m with its foot and by m with its shoulder.
    out[k] = {lane.moves_foot * (height * (by_one - by_height)), lane.moves_shoulder * (height * by_height),
              clip ? by_top : sum(lane.width * by_height) + by_top};
  }
  return origin - lo_ + centroid;
}

}  // namespace tactus::analysis
