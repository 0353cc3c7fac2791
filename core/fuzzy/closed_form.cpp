#include "core/fuzzy/closed_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

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

/// The trapezoid between `left` and `right`. Where both tapers are the same but for the rounding of the vertices, it is
/// symmetric: a skew of an ulp moves the centroid by less than that.
Polynomial<double> clipped(double left, double right, double rise, double fall, double lo) {
  const double start = left - lo;
  const double width = right - left;
  const bool skewed = std::abs(rise - fall) > 4e-16 * std::max(std::abs(left), std::abs(right));
  const double skew = skewed ? (rise - fall) / 2 : 0;
  return {width, (rise + fall) / 2, start + width / 2, skew * (width / 2), skew * ((rise + fall) / 3)};
}

/// The whole trapezoid, to be multiplied by a strength.
Polynomial<double> scaled(const Polynomial<double>& f) {
  const double area = f.width - f.half_taper;
  return {area, 0, area * f.middle + (f.linear - f.cubic), 0, 0};
}

/// What f has in common with a later g; nothing where scaled sets would cross outside their ramps.
std::optional<Overlap<double>> overlapOf(const Corners& f, const Corners& g, double lo, Implication implication) {
  const double width = f.d - g.a;
  const double fall = f.d - f.c;
  const double rise = g.b - g.a;
  const double start = g.a - lo;
  const double peak = rise + fall > width ? width / (rise + fall) : 1;
  if (implication == Implication::kClip) return Overlap<double>{clipped(g.a, f.d, rise, fall, lo), peak, 0, 0, 0};
  if (width > std::min(rise, fall)) return std::nullopt;
  return Overlap<double>{{width, 0, 0, 0, 0}, peak, start, 1 / fall, 1 / rise};
}

void setLane(Polynomial<Lanes>& to, std::size_t lane, const Polynomial<double>& from) {
  to.width.value[lane] = from.width;
  to.half_taper.value[lane] = from.half_taper;
  to.middle.value[lane] = from.middle;
  to.linear.value[lane] = from.linear;
  to.cubic.value[lane] = from.cubic;
}

void setLane(Overlap<Lanes>& to, std::size_t lane, const Overlap<double>& from) {
  setLane(to.shape, lane, from.shape);
  to.peak.value[lane] = from.peak;
  to.start.value[lane] = from.start;
  to.inverse_fall.value[lane] = from.inverse_fall;
  to.inverse_rise.value[lane] = from.inverse_rise;
}

void setSideBySide(ClosedForm& form) {
  form.fits_side_by_side = form.terms.size() <= kLanes;
  for (std::size_t right = 0; form.fits_side_by_side && right < form.terms.size(); ++right) {
    setLane(form.side_by_side.terms, right, form.terms[right]);
    for (std::uint32_t p = form.first_pair[right]; p < form.first_pair[right + 1]; ++p) {
      form.fits_side_by_side = form.fits_side_by_side && form.pairs[p].left + 1U == right;
      setLane(form.side_by_side.overlaps, form.pairs[p].left, form.pairs[p].overlap);
    }
  }
}

}  // namespace

bool makeClosedForm(std::span<const MembershipFunction> terms, double lo, double hi, Implication implication,
                    ClosedForm& form) {
  // Outside these widths the products of the polynomials could leave the range of double.
  if (hi - lo > 1e60 || hi - lo < 1e-60) return false;
  std::array<Corners, kMostTerms> sets;
  std::array<std::uint16_t, kMostTerms> places{};
  const std::span<std::uint16_t> order = std::span(places).first(terms.size());
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto cut = cutToUniverse(terms[t], lo, hi);
    if (!cut) return false;
    sets[t] = *cut;
  }
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  std::sort(order.begin(), order.end(), [&sets](std::uint16_t i, std::uint16_t j) {
    const auto key = [&](std::uint16_t t) { return std::tuple(sets[t].a, sets[t].b, sets[t].c, sets[t].d, t); };
    return key(i) < key(j);
  });

  form.lane_of.resize(terms.size());
  form.terms.reserve(terms.size());
  form.pairs.reserve(terms.size());
  form.first_pair.reserve(terms.size() + 1);
  for (std::size_t right = 0; right < order.size(); ++right) {
    const Corners& g = sets[order[right]];
    form.lane_of[order[right]] = static_cast<std::uint16_t>(right);
    const auto whole = clipped(g.a, g.d, g.b - g.a, g.d - g.c, lo);
    form.terms.push_back(implication == Implication::kClip ? whole : scaled(whole));
    form.first_pair.push_back(static_cast<std::uint32_t>(form.pairs.size()));
    for (std::size_t left = 0; left < right; ++left) {
      const Corners& f = sets[order[left]];
      if (left + 1 == right && !before(f, g)) return false;
      if (f.d <= g.a) continue;
      const auto overlap = overlapOf(f, g, lo, implication);
      if (!overlap || (implication == Implication::kScale && left + 1 < right)) return false;
      form.pairs.push_back({*overlap, static_cast<std::uint16_t>(left)});
    }
  }
  form.first_pair.push_back(static_cast<std::uint32_t>(form.pairs.size()));
  setSideBySide(form);
  return true;
}

}  // namespace tactus::fuzzy
