// The centroid of ordered output terms in layers: above each height a set is one interval, so areas and moments are
// polynomials in the strengths. Neighbors share their whole overlap, as in core/fuzzy/closed_form.h.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/contracts/force_cells.h"

namespace tactus::contracts {

using fuzzy::MembershipFunction;

OutputSets::Layers OutputSets::layersOf(double a, double b, double c, double d, double low) {
  const Interval rise = Interval(b) - a;
  const Interval fall = Interval(d) - c;
  Layers out;
  out.width = Interval(d) - a;
  out.taper = rise + fall;
  out.middle = (Interval(a) + d) * 0.5 - low;
  out.skew = (rise - fall) * 0.5;
  return out;
}

std::optional<OutputSets> OutputSets::of(std::span<const fuzzy::Term> terms, double low, double high,
                                         fuzzy::Implication implication) {
  OutputSets out;
  out.clip_ = implication == fuzzy::Implication::kClip;
  std::vector<MembershipFunction> sets;
  for (const fuzzy::Term& term : terms) {
    MembershipFunction f = MembershipFunction::of(term);
    if (f.gaussian) return std::nullopt;
    if (f.b <= low) f.a = f.b = low;
    if (f.c >= high) f.c = f.d = high;
    if (!(f.a >= low && f.d <= high && f.a <= f.b && f.b <= f.c && f.c <= f.d)) return std::nullopt;
    sets.push_back(f);
  }
  std::vector<std::size_t> order(sets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t t) { return std::tuple(sets[t].a, sets[t].b, sets[t].c, sets[t].d, t); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  out.place_.resize(sets.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const MembershipFunction& f = sets[order[k]];
    out.place_[order[k]] = k;
    out.own_.push_back(layersOf(f.a, f.b, f.c, f.d, low));
    if (k + 2 < order.size() && f.d > sets[order[k + 2]].a) return std::nullopt;
    if (k + 1 == order.size()) break;
    const MembershipFunction& g = sets[order[k + 1]];
    if (!(f.b <= g.b && f.c <= g.c && f.d <= g.d)) return std::nullopt;
    Layers shared;
    if (f.d > g.a) {
      const double rise = g.b - g.a;
      const double fall = f.d - f.c;
      shared = layersOf(g.a, g.b, f.c, f.d, low);
      shared.wide = f.d - g.a;
      shared.rise = rise;
      shared.fall = fall;
      if (!out.clip_ && shared.wide > std::min(rise, fall)) return std::nullopt;
      if (rise + fall > shared.wide) shared.top = shared.wide / (rise + fall);
    }
    out.overlap_.push_back(shared);
  }
  // A layer of a term, less what its left neighbor shares, ends between two lines; so does its middle.
  for (std::size_t k = 0; k < order.size(); ++k) {
    const MembershipFunction& f = sets[order[k]];
    const double before = k > 0 ? sets[order[k - 1]].d : low;
    const double after = k + 1 < order.size() ? sets[order[k + 1]].a : high;
    const double most =
        std::max(std::max(f.a, std::min(before, f.d)) + f.d, std::max(f.b, std::min(before, f.c)) + f.c);
    const double least = std::min(f.a + std::min(f.d, std::max(after, f.a)), f.b + std::min(f.c, std::max(after, f.b)));
    out.reach_.push_back(Interval(down(least), up(most)) * 0.5 - low);
  }
  return out;
}

/// Adds the layers up to `strength`, `sign` 1 or -1.
void OutputSets::add(Sums& sums, const Layers& layers, double strength, double about, double sign) {
  const Interval s = strength;
  const Interval middle = layers.middle - about;
  const Interval area = s * (layers.width - s * layers.taper * 0.5);
  const Interval moment = s * (layers.width * middle + s * ((layers.width * layers.skew - layers.taper * middle) * 0.5 -
                                                            s * layers.taper * layers.skew * (Interval(1) / 3)));
  sums.area = sign > 0 ? sums.area + area : sums.area - area;
  sums.moment = sign > 0 ? sums.moment + moment : sums.moment - moment;
}

/// Takes off the triangle under the falling ramp of term k at `left` and the rising one of the next at `right`.
void OutputSets::addScaledOverlap(Sums& sums, std::size_t k, double left, double right, double about) const {
  const Layers& o = overlap_[k];
  if (left <= 0 || right <= 0) return;
  const Interval p = Interval(left) / o.fall;
  const Interval q = Interval(right) / o.rise;
  const Interval share = p / (p + q);
  const Interval area = q * share * o.wide * o.wide * 0.5;
  const Interval start = o.middle - Interval(o.wide) * 0.5 - about;
  sums.area = sums.area - area;
  sums.moment = sums.moment - area * (start + (share + 1.0) * o.wide * (Interval(1) / 3));
}

OutputSets::Sums OutputSets::sumsAt(std::span<const double> strengths, std::span<const Smaller> smaller,
                                    double about) const {
  Sums sums;
  if (!clip_) {
    for (std::size_t k = 0; k < own_.size(); ++k) {
      if (strengths[k] == 0) continue;
      Sums whole;
      add(whole, own_[k], 1, about, 1);
      sums.area = sums.area + whole.area * strengths[k];
      sums.moment = sums.moment + whole.moment * strengths[k];
      if (k + 1 < own_.size() && overlap_[k].wide > 0) addScaledOverlap(sums, k, strengths[k], strengths[k + 1], about);
    }
    return sums;
  }
  for (std::size_t k = 0; k < own_.size(); ++k) {
    if (strengths[k] > 0) add(sums, own_[k], strengths[k], about, 1);
    if (k + 1 == own_.size() || !(overlap_[k].wide > 0)) continue;
    const double least = smaller[k] == Smaller::kLeft    ? strengths[k]
                         : smaller[k] == Smaller::kRight ? strengths[k + 1]
                                                         : std::min(strengths[k], strengths[k + 1]);
    if (least > 0) add(sums, overlap_[k], std::min(least, overlap_[k].top), about, -1);
  }
  return sums;
}

Interval OutputSets::clippedRate(std::size_t k, const Interval& s, bool with_left, bool with_right, double about,
                                 const Interval& beside) const {
  Sum sum;
  const auto add_layers = [&](const Layers& l, bool first) {
    const Interval middle = l.middle - about;
    const Sum one{l.width * middle, l.width * l.skew - l.taper * middle, l.taper * l.skew, l.width, l.taper};
    if (first) {
      sum = one;
      return;
    }
    sum = {sum.constant - one.constant, sum.linear - one.linear, sum.square - one.square, sum.width - one.width,
           sum.taper - one.taper};
  };
  add_layers(own_[k], true);
  if (with_left) add_layers(overlap_[k - 1], false);
  if (with_right) add_layers(overlap_[k], false);
  return sum.constant + s * (sum.linear - s * sum.square) - beside * (sum.width - s * sum.taper);
}

Interval OutputSets::scaledRate(std::size_t k, std::span<const TermStrength> strengths, double about,
                                const Interval& beside) const {
  Sums whole;
  add(whole, own_[k], 1, about, 1);
  Interval rate = whole.moment - beside * whole.area;
  // The share of the left ramp in the sum of both slopes, between 0 and 1.
  const auto share_of = [&](std::size_t left) {
    const Layers& o = overlap_[left];
    const Interval p = strengths[left].value / o.fall;
    const Interval q = strengths[left + 1].value / o.rise;
    const double least = p.low + q.high;
    const double most = p.high + q.low;
    return common(Interval(0, 1),
                  Interval(least > 0 ? down(down(p.low / least)) : 0, most > 0 ? up(up(p.high / most)) : 1));
  };
  const Interval third = Interval(1) / 3;
  if (k + 1 < own_.size() && overlap_[k].wide > 0 && strengths[k + 1].value.high > 0) {
    const Layers& o = overlap_[k];
    const Interval share = share_of(k);
    const Interval rest = common(Interval(0, 1), Interval(1) - share);
    const Interval start = o.middle - Interval(o.wide) * 0.5 - about - beside;
    rate = rate - rest * rest * (start + (share * 2.0 + 1.0) * o.wide * third) * o.wide * o.wide * 0.5 / o.fall;
  }
  if (k > 0 && overlap_[k - 1].wide > 0 && strengths[k - 1].value.high > 0) {
    const Layers& o = overlap_[k - 1];
    const Interval share = share_of(k - 1);
    const Interval start = o.middle - Interval(o.wide) * 0.5 - about - beside;
    rate = rate - share * share * (start + share * 2.0 * o.wide * third) * o.wide * o.wide * 0.5 / o.rise;
  }
  return rate;
}

Interval OutputSets::rate(std::size_t k, std::span<const TermStrength> strengths, std::span<const Smaller> smaller,
                          double about, const Interval& beside) const {
  if (!clip_) return scaledRate(k, strengths, about, beside);
  const Interval& s = strengths[k].value;
  // Whether the overlap with a neighbor ends at this strength: yes, no, or both are possible.
  const auto cases = [&](const Layers& shared, Smaller order, Smaller own, const TermStrength& other) {
    std::pair<bool, bool> out{false, true};  // with, without
    if (!(shared.wide > 0) || other.value.high <= 0 || s.low >= shared.top) return out;
    if (order != own && order != Smaller::kUnknown) return out;
    out.first = true;
    out.second = order == Smaller::kUnknown || s.high > shared.top;
    return out;
  };
  std::pair<bool, bool> left{false, true}, right{false, true};
  if (k > 0) left = cases(overlap_[k - 1], smaller[k - 1], Smaller::kRight, strengths[k - 1]);
  if (k + 1 < own_.size()) right = cases(overlap_[k], smaller[k], Smaller::kLeft, strengths[k + 1]);
  std::optional<Interval> out;
  for (const bool with_left : {false, true}) {
    if (!(with_left ? left.first : left.second)) continue;
    for (const bool with_right : {false, true}) {
      if (!(with_right ? right.first : right.second)) continue;
      const Interval one = clippedRate(k, s, with_left, with_right, about, beside);
      out = out ? hull(*out, one) : one;
    }
  }
  return *out;
}

}  // namespace tactus::contracts
