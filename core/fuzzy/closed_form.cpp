// Polynomials for the area and the moment of ordered output terms.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/fuzzy/program.h"

namespace tactus::fuzzy {
namespace {

using Corners = MembershipFunction;

/// The term as the universe shows it. Nothing where the universe cuts a ramp: the cut is no trapezoid any more.
std::optional<Corners> cutToUniverse(Corners f, double lo, double hi) {
  if (f.gaussian) return std::nullopt;
  if (f.b <= lo) f.a = f.b = lo;
  if (f.c >= hi) f.c = f.d = hi;
  const bool inside = f.a >= lo && f.d <= hi && f.a <= f.b && f.b <= f.c && f.c <= f.d;
  return inside ? std::optional(f) : std::nullopt;
}

bool before(const Corners& f, const Corners& g) { return f.a <= g.a && f.b <= g.b && f.c <= g.c && f.d <= g.d; }

/// 0 where both tapers are the same but for rounding: the skew would be nothing but rounding errors.
double skewOf(double rise, double fall) {
  const double skew = (rise - fall) / 2;
  return std::abs(skew) <= 4e-16 * std::max(rise, fall) ? 0 : skew;
}

}  // namespace

std::optional<ClosedForm> closedForm(std::span<const MembershipFunction> terms, double lo, double hi,
                                     Implication implication, std::vector<std::uint16_t>& lane_of) {
  // Outside these widths the products of the polynomials could leave the range of double.
  if (terms.size() > kLanes || hi - lo > 1e60 || hi - lo < 1e-60) return std::nullopt;
  std::vector<Corners> sets;
  for (const auto& term : terms) {
    const auto cut = cutToUniverse(term, lo, hi);
    if (!cut) return std::nullopt;
    sets.push_back(*cut);
  }
  std::vector<std::size_t> order(sets.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const auto key = [](const Corners& f) { return std::tuple(f.a, f.b, f.c, f.d); };
    return key(sets[i]) < key(sets[j]);
  });

  ClosedForm form;
  form.count = sets.size();
  lane_of.assign(sets.size(), 0);
  const bool clip = implication == Implication::kClip;
  for (std::size_t lane = 0; lane < order.size(); ++lane) {
    const Corners& f = sets[order[lane]];
    lane_of[order[lane]] = static_cast<std::uint16_t>(lane);
    const double rise = f.b - f.a;
    const double fall = f.d - f.c;
    const double width = f.d - f.a;
    form.width.value[lane] = width;
    form.half_taper.value[lane] = (rise + fall) / 2;
    form.middle.value[lane] = (f.a - lo) + width / 2;
    form.skew.value[lane] = skewOf(rise, fall);
    form.half_width.value[lane] = width / 2;
    form.third_taper.value[lane] = (rise + fall) / 3;

    if (lane + 1 == order.size()) continue;
    const Corners& g = sets[order[lane + 1]];
    if (!before(f, g)) return std::nullopt;
    if (lane + 2 < order.size() && f.d > sets[order[lane + 2]].a) return std::nullopt;
    const double overlap = f.d - g.a;
    if (overlap <= 0) continue;
    const double next_rise = g.b - g.a;
    if (!clip && overlap > std::min(next_rise, fall)) return std::nullopt;
    form.overlap_width.value[lane] = overlap;
    form.overlap_half_taper.value[lane] = (next_rise + fall) / 2;
    form.overlap_middle.value[lane] = (g.a - lo) + overlap / 2;
    form.overlap_skew.value[lane] = skewOf(next_rise, fall);
    form.overlap_half_width.value[lane] = overlap / 2;
    form.overlap_third_taper.value[lane] = (next_rise + fall) / 3;
    form.overlap_peak.value[lane] = next_rise + fall > overlap ? overlap / (next_rise + fall) : 1;
    form.overlap_start.value[lane] = g.a - lo;
    form.inverse_fall.value[lane] = clip ? 0 : 1 / fall;
    form.inverse_rise.value[lane] = clip ? 0 : 1 / next_rise;
  }
  if (clip) return form;

  // Scaled: area and moment of the whole trapezoid, to be multiplied by the strength.
  for (std::size_t lane = 0; lane < form.count; ++lane) {
    const double area = form.width.value[lane] - form.half_taper.value[lane];
    const double moment = area * form.middle.value[lane] +
                          form.skew.value[lane] * (form.half_width.value[lane] - form.third_taper.value[lane]);
    form.width.value[lane] = area;
    form.middle.value[lane] = moment;
  }
  return form;
}

}  // namespace tactus::fuzzy
