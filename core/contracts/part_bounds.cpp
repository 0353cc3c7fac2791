// The bounds of a part: the flanks, the strengths that their order leaves, the centroids and their slopes.
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/contracts/cell_tables.h"

namespace tactus::contracts {
namespace {

constexpr double kHuge = 1e200;  // stands for a slope without a bound

}  // namespace

/// A point of the part in which its orders certainly hold. With lines alone the part is convex, so from there slopes
/// lead to every other point.
std::optional<std::array<double, kMostVariables>> ForceSum::pointIn(const Part& part) const {
  const Scratch& s = *scratch_;
  std::array<double, kMostVariables> point{};
  for (std::size_t v = 0; v < ranges_.size(); ++v) point[v] = part.box[v].middle();
  constexpr int kRounds = 12;
  for (int round = 0; round < kRounds; ++round) {
    bool holds = true;
    for (const auto& [a, b] : part.orders) {
      const Flank& low = s.flanks[a];
      const Flank& high = s.flanks[b];
      if (low.kind == Flank::Kind::kGaussian || high.kind == Flank::Kind::kGaussian) return std::nullopt;
      const Interval at_low = low.at(point[low.variable]);
      const Interval at_high = high.at(point[high.variable]);
      if (at_low.high <= at_high.low) continue;
      holds = false;
      // Both move to their middle, and a little beyond.
      const double between = (at_low.middle() + at_high.middle()) / 2;
      const double beyond = (at_low.middle() - at_high.middle()) / 16 + 1e-12;
      const auto move = [&](const Flank& flank, double value) {
        if (flank.kind != Flank::Kind::kLine) return;
        const Interval& side = part.box[flank.variable];
        point[flank.variable] = std::clamp(flank.foot + value / flank.weight * flank.span, side.low, side.high);
      };
      move(low, between - beyond);
      move(high, between + beyond);
    }
    if (holds) return point;
  }
  return std::nullopt;
}

/// The flanks in the part, the box that its orders leave, and which flank is at most which other one. False where the
/// orders hold nowhere.
bool ForceSum::takePart(Part& part) {
  Scratch& s = *scratch_;
  const std::size_t count = s.flanks.size();
  // The flanks, and the box that the orders leave.
  s.values.resize(count);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t a = 0; a < count; ++a) s.values[a] = s.flanks[a].over(part.box[s.flanks[a].variable]);
    for (const auto& [a, b] : part.orders) {
      if (s.values[a].low > s.values[b].high) return false;
      s.values[a].high = std::max(s.values[a].low, std::min(s.values[a].high, s.values[b].high));
      s.values[b].low = std::min(s.values[b].high, std::max(s.values[b].low, s.values[a].low));
    }
    if (part.orders.empty()) break;
    for (const auto& order : part.orders) {
      for (const std::size_t a : {order.first, order.second}) {
        Interval& side = part.box[s.flanks[a].variable];
        side = s.flanks[a].whereIn(s.values[a], side);
      }
    }
  }

  // Which flank is at most which other one.
  for (std::size_t a = 0; a < count; ++a) {
    s.at_most[a] = bit(a);
    for (std::size_t b = 0; b < count; ++b) {
      if (s.values[a].high <= s.values[b].low) s.at_most[a] |= bit(b);
    }
  }
  for (const auto& [a, b] : part.orders) s.at_most[a] |= bit(b);
  for (std::size_t middle = 0; middle < count && !part.orders.empty(); ++middle) {
    for (std::size_t a = 0; a < count; ++a) {
      if ((s.at_most[a] & bit(middle)) != 0) s.at_most[a] |= s.at_most[middle];
    }
  }
  for (std::size_t b = 0; b < count; ++b) {
    s.below[b] = 0;
    for (std::size_t a = 0; a < count; ++a) {
      const bool at_most = a != b && (s.at_most[a] & bit(b)) != 0;
      const bool equal = at_most && (s.at_most[b] & bit(a)) != 0;
      if (at_most && (!equal || a < b)) s.below[b] |= bit(a);
    }
  }
  return true;
}

/// Notes a pair of flanks whose order is open, the one with the widest common range.
void ForceSum::noteUndecided(std::size_t a, std::size_t b, PartBounds& out) {
  Scratch& s = *scratch_;
  if ((s.at_most[a] & bit(b)) != 0 || (s.at_most[b] & bit(a)) != 0) return;
  const double both = std::min(s.values[a].high, s.values[b].high) - std::max(s.values[a].low, s.values[b].low);
  if (out.undecided && both <= s.undecided_by) return;
  s.undecided_by = both;
  out.undecided = Order{static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
}

/// Of each rule the flanks that may be its smallest, then of the rules those that may be the largest.
void ForceSum::chooseFlanks(const std::vector<Mask>& rules) {
  Scratch& s = *scratch_;
  s.chosen.clear();
  for (const Mask rule : rules) {
    Mask candidates = 0;
    for (Mask rest = rule; rest != 0; rest &= rest - 1) {
      const auto a = static_cast<std::size_t>(std::countr_zero(rest));
      if ((s.below[a] & rule) == 0) candidates |= bit(a);
    }
    if (std::find(s.chosen.begin(), s.chosen.end(), candidates) == s.chosen.end()) s.chosen.push_back(candidates);
  }
  const auto is_at_most = [&](Mask r, Mask q) {
    for (Mask rest = r; rest != 0; rest &= rest - 1) {
      if ((q & ~s.at_most[static_cast<std::size_t>(std::countr_zero(rest))]) == 0) return true;
    }
    return false;
  };
  for (std::size_t r = 0; r < s.chosen.size();) {
    bool superfluous = false;
    for (std::size_t q = 0; q < s.chosen.size() && !superfluous; ++q) {
      superfluous = q != r && is_at_most(s.chosen[r], s.chosen[q]) && (q < r || !is_at_most(s.chosen[q], s.chosen[r]));
    }
    if (superfluous) {
      s.chosen.erase(s.chosen.begin() + static_cast<std::ptrdiff_t>(r));
    } else {
      ++r;
    }
  }
}

/// The strength of one output term in the part, and at the point `middle`, from the flanks chosen.
void ForceSum::findStrength(std::size_t term, const Part& part, std::span<const double> middle, PartBounds& out) {
  Scratch& s = *scratch_;
  TermStrength& strength = s.strengths[term];
  Interval& at_center = s.at_center[term];
  Mask all = 0;
  for (const Mask rule : s.chosen) {
    Interval value(std::numeric_limits<double>::max());
    Interval center = value;
    for (Mask rest = rule; rest != 0; rest &= rest - 1) {
      const auto a = static_cast<std::size_t>(std::countr_zero(rest));
      const Flank& flank = s.flanks[a];
      value = {std::min(value.low, s.values[a].low), std::min(value.high, s.values[a].high)};
      const Interval now = flank.at(middle[flank.variable]);
      center = {std::min(center.low, now.low), std::min(center.high, now.high)};
    }
    strength.value = {std::max(strength.value.low, value.low), std::max(strength.value.high, value.high)};
    at_center = {std::max(at_center.low, center.low), std::max(at_center.high, center.high)};
    all |= rule;
  }
  at_center = common(strength.value, at_center);
  s.middles[term] = at_center.middle();
  if (std::popcount(all) == 1) s.single[term] = std::countr_zero(all);
  bool first = true;
  for (Mask rest = all; rest != 0; rest &= rest - 1) {
    const auto a = static_cast<std::size_t>(std::countr_zero(rest));
    const Flank& flank = s.flanks[a];
    const Interval slope = flank.slope(part.box[flank.variable]);
    for (std::size_t v = 0; v < ranges_.size(); ++v) {
      const Interval along = flank.kind != Flank::Kind::kConstant && v == flank.variable ? slope : Interval(0.0);
      strength.slope[v] = first ? along : hull(strength.slope[v], along);
    }
    first = false;
    for (Mask others = rest & (rest - 1); others != 0; others &= others - 1)
      noteUndecided(a, static_cast<std::size_t>(std::countr_zero(others)), out);
  }
}

/// Which of two neighboring output terms is the weaker one.
void ForceSum::findSmaller(std::size_t terms, PartBounds& out) {
  Scratch& s = *scratch_;
  for (std::size_t t = 0; t + 1 < terms; ++t) {
    s.smaller[t] = Smaller::kUnknown;
    const Interval& left = s.strengths[t].value;
    const Interval& right = s.strengths[t + 1].value;
    if (left.high <= right.low) {
      s.smaller[t] = Smaller::kLeft;
    } else if (right.high <= left.low) {
      s.smaller[t] = Smaller::kRight;
    } else if (s.single[t] >= 0 && s.single[t + 1] >= 0) {
      const auto a = static_cast<std::size_t>(s.single[t]);
      const auto b = static_cast<std::size_t>(s.single[t + 1]);
      if ((s.at_most[a] & bit(b)) != 0) {
        s.smaller[t] = Smaller::kLeft;
      } else if ((s.at_most[b] & bit(a)) != 0) {
        s.smaller[t] = Smaller::kRight;
      } else {
        noteUndecided(a, b, out);
      }
    }
  }
}

/// Adds the force of one expert, whose strengths were found, and its slopes. `centered`: its force at the middle, if
/// that is a point of the part.
void ForceSum::addForce(std::size_t firing, bool middle_is_inner, PartBounds& out, Interval& centered) {
  Scratch& s = *scratch_;
  const Scratch::Firing& one = s.firing[firing];
  const std::size_t terms = one.rules.size();
  const std::size_t variables = ranges_.size();
  std::optional<Interval> reached;
  for (std::size_t t = 0; t < terms; ++t) {
    if (!one.rules[t].empty()) reached = reached ? hull(*reached, one.expert->reach[t]) : one.expert->reach[t];
  }
  const Interval reach = *reached;
  const auto add = [&](const Interval& force, const Interval& at_middle) {
    out.value = out.value + one.share * (force + one.expert->low);
    if (one.expert->copy == 0) out.first = out.first + one.share * (force + one.expert->low);
    centered = centered + one.share * (at_middle + one.expert->low);
  };
  if (!one.expert->sets) {
    out.bounded = false;
    for (std::size_t t = 0; t < terms; ++t) {
      for (std::size_t v = 0; v < variables; ++v) {
        if (!s.strengths[t].slope[v].isZero()) out.slope[v] = {-kHuge, kHuge};
      }
    }
    add(reach, reach);
    return;
  }
  const OutputSets& sets = *one.expert->sets;
  const std::span<const TermStrength> strengths(s.strengths.data(), terms);
  const std::span<const Smaller> smaller(s.smaller.data(), terms);
  const std::span<const double> middles(s.middles.data(), terms);

  // The area grows with every strength, so its bounds are those of the corners.
  std::array<double, fuzzy::kMostTerms> corner;
  std::array<Smaller, fuzzy::kMostTerms> none;
  none.fill(Smaller::kUnknown);
  for (std::size_t t = 0; t < terms; ++t) corner[t] = strengths[t].value.low;
  const double least = sets.sumsAt({corner.data(), terms}, none, 0).area.low;
  for (std::size_t t = 0; t < terms; ++t) corner[t] = strengths[t].value.high;
  const double most = sets.sumsAt({corner.data(), terms}, none, 0).area.high;
  const bool safe = least > 0;
  const Interval area(safe ? least : 0, most);

  const auto rough = sets.sumsAt(middles, smaller, 0);
  const double about = rough.area.middle() > 0
                           ? std::clamp(rough.moment.middle() / rough.area.middle(), reach.low, reach.high)
                           : reach.middle();
  Interval beside = reach - about;
  OutputSets::Sums sums;
  std::array<Interval, fuzzy::kMostTerms> rates;
  if (safe) {
    // The moment at the middle strengths, and what it changes by up to the others.
    sums = sets.sumsAt(middles, smaller, about);
    Interval moment = sums.moment;
    for (std::size_t t = 0; t < terms; ++t) {
      if (strengths[t].value.high == 0) continue;
      rates[t] = sets.rate(t, strengths, smaller, about, 0.0);
      moment = moment + rates[t] * (strengths[t].value - middles[t]);
    }
    beside = common(beside, moment / area);
  }
  const Interval force = beside + about;

  for (std::size_t t = 0; t < terms; ++t) {
    if (strengths[t].value.high == 0) continue;
    const auto& slopes = strengths[t].slope;
    const bool varies = std::any_of(slopes.begin(), slopes.end(), [](const Interval& x) { return !x.isZero(); });
    if (!varies) continue;
    const Interval rate = sets.rate(t, strengths, smaller, about, beside);
    for (std::size_t v = 0; v < variables; ++v) {
      if (!slopes[v].isZero()) s.slope[v] = s.slope[v] + rate * slopes[v];
    }
  }
  for (std::size_t v = 0; v < variables; ++v) {
    Interval slope = std::exchange(s.slope[v], Interval());
    if (slope.isZero()) continue;
    if (!safe) {
      // The area may vanish: the sign alone is known.
      out.bounded = false;
      slope = {slope.low < 0 ? -kHuge : 0.0, slope.high > 0 ? kHuge : 0.0};
    }
    out.slope[v] = out.slope[v] + one.share * (safe ? slope / area : slope);
  }

  Interval at_middle = force;
  if (safe && middle_is_inner) {
    Interval moment = sums.moment;
    for (std::size_t t = 0; t < terms; ++t) {
      if (strengths[t].value.high > 0) moment = moment + rates[t] * (s.at_center[t] - middles[t]);
    }
    // The strengths are known to some digits, and so is the area.
    const Interval size(sums.area.low * (1 - 0x1p-40), sums.area.high * (1 + 0x1p-40));
    if (size.low > 0) at_middle = common(force, moment / size + about);
  }
  add(force, at_middle);
}

std::optional<PartBounds> ForceSum::bounds(Part& part) {
  if (!takePart(part)) return std::nullopt;
  Scratch& s = *scratch_;
  PartBounds out;
  out.value = s.constant;
  Interval centered = s.constant;  // of the sum at the middle
  const std::optional<std::array<double, kMostVariables>> inner = pointIn(part);
  std::array<double, kMostVariables> middle{};
  for (std::size_t v = 0; v < ranges_.size(); ++v) middle[v] = inner ? (*inner)[v] : part.box[v].middle();
  for (std::size_t a = 0; a < s.flanks.size(); ++a) {
    const bool widest = s.flanks[a].kind != Flank::Kind::kConstant && s.values[a].width() > out.widest_by;
    if (widest) out.widest_by = s.values[a].width(), out.widest = s.flanks[a].variable;
  }
  for (std::size_t f = 0; f < s.firing.size(); ++f) {
    const Scratch::Firing& one = s.firing[f];
    if (one.cancels) {
      // What is not computed is anywhere in its universe.
      if (one.expert->copy == 0) out.first = out.first + one.share * Interval(one.expert->low, one.expert->high);
      continue;
    }
    for (std::size_t t = 0; t < one.rules.size(); ++t) {
      s.strengths[t] = {};
      s.at_center[t] = 0.0;
      s.middles[t] = 0;
      s.single[t] = -1;
      if (one.rules[t].empty()) continue;
      chooseFlanks(one.rules[t]);
      findStrength(t, part, middle, out);
    }
    findSmaller(one.rules.size(), out);
    addForce(f, inner.has_value(), out, centered);
  }
  if (out.bounded && inner) {
    for (std::size_t v = 0; v < ranges_.size(); ++v) {
      if (!out.slope[v].isZero()) centered = centered + out.slope[v] * (part.box[v] - middle[v]);
    }
    out.value = common(out.value, centered);
  }
  return out;
}

}  // namespace tactus::contracts
