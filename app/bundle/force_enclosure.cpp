#include "app/bundle/force_enclosure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fuzzy/force_model.h"

namespace tactus::bundle {
namespace {

using fuzzy::MembershipFunction;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

Range times(const Range& a, const Range& b) {
  const double p[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
  return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

Membership gaussianOver(const MembershipFunction& f, double lo, double hi) {
  const auto slope = [&](double x) { return -(x - f.mean) / (f.sigma * f.sigma) * f(x); };
  Membership out;
  out.value = {std::min(f(lo), f(hi)), std::max(f(lo), f(hi))};
  out.slope = {std::min(slope(lo), slope(hi)), std::max(slope(lo), slope(hi))};
  if (lo < f.mean && f.mean < hi) out.value.hi = 1;
  for (const double x : {f.mean - f.sigma, f.mean + f.sigma}) {
    if (lo < x && x < hi) include(out.slope, slope(x));
  }
  return out;
}

}  // namespace

double fromTheRight(const MembershipFunction& f, double x) {
  if (x < f.a || x >= f.d) return 0;
  if (x < f.b) return (x - f.a) / (f.b - f.a);
  return x <= f.c ? 1 : (f.d - x) / (f.d - f.c);
}

double fromTheLeft(const MembershipFunction& f, double x) {
  if (x <= f.a || x > f.d) return 0;
  if (x > f.c) return (f.d - x) / (f.d - f.c);
  return x >= f.b ? 1 : (x - f.a) / (f.b - f.a);
}

Membership over(const MembershipFunction& f, double lo, double hi) {
  if (f.gaussian) return gaussianOver(f, lo, hi);
  Membership out;
  const double left = fromTheRight(f, lo);
  const double right = fromTheLeft(f, hi);
  const bool top = std::max(lo, f.b) <= std::min(hi, f.c) && f.b < hi && f.c > lo;
  out.value = {std::min(left, right), top ? 1 : std::max(left, right)};
  const bool rises = f.a < f.b && std::max(lo, f.a) < std::min(hi, f.b);
  const bool falls = f.c < f.d && std::max(lo, f.c) < std::min(hi, f.d);
  const bool rests = lo < f.a || hi > f.d || std::max(lo, f.b) < std::min(hi, f.c);
  out.slope = {kUnbounded, -kUnbounded};
  if (rises) include(out.slope, 1 / (f.b - f.a));
  if (falls) include(out.slope, -1 / (f.d - f.c));
  if (rests || (!rises && !falls)) include(out.slope, 0);
  out.jumps = (f.a == f.b && lo < f.a && f.a < hi) || (f.c == f.d && lo < f.c && f.c < hi);
  return out;
}

namespace {

template <bool clip>
double height(double strength, double membership) {
  return clip ? std::min(strength, membership) : strength * membership;
}

}  // namespace

ForceEnclosure::ForceEnclosure(const fuzzy::ForceModel& model) : model_(model) {
  const std::vector<double> weights = normalizedWeights(model);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (weights[e] > 0) addExpert(model.experts[e], weights[e]);
  }
}

void ForceEnclosure::lookAt(std::span<const double> lo, std::span<const double> hi,
                            std::vector<std::vector<Membership>>& out) const {
  out.resize(banks_.size());
  for (std::size_t b = 0; b < banks_.size(); ++b) {
    out[b].clear();
    for (const auto& term : banks_[b].terms) out[b].push_back(over(term, lo[banks_[b].input], hi[banks_[b].input]));
  }
}

void ForceEnclosure::cellOf(const std::vector<std::vector<Membership>>& memberships, Cell& cell) const {
  cell.rules.resize(experts_.size());
  for (std::size_t e = 0; e < experts_.size(); ++e) {
    cell.rules[e].clear();
    for (const RuleLook& rule : experts_[e].rules) {
      const bool may_fire = std::all_of(rule.conditions.begin(), rule.conditions.end(), [&](const auto& condition) {
        return memberships[condition.first][condition.second].value.hi > 0;
      });
      if (may_fire) cell.rules[e].push_back(&rule);
    }
  }
}

ForceRange ForceEnclosure::enclose(const Cell& cell, const std::vector<std::vector<Membership>>& memberships) const {
  ForceRange out;
  out.force_n = {kUnbounded, -kUnbounded};
  bool some_certain = false;
  double weights = 0;
  Range mean{0, 0};
  for (std::size_t e = 0; e < experts_.size(); ++e) {
    if (cell.rules[e].empty()) continue;
    One one;
    encloseExpert(experts_[e], cell.rules[e], memberships, one);
    if (!one.may_fire) continue;
    out.fires = true;
    include(out.force_n, one.force_n.lo);
    include(out.force_n, one.force_n.hi);
    some_certain = some_certain || one.certain;
    out.smooth = out.smooth && one.certain && one.smooth;
    if (!out.smooth) continue;
    weights += experts_[e].weight;
    mean += {experts_[e].weight * one.force_n.lo, experts_[e].weight * one.force_n.hi};
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      out.slopes[i] += {experts_[e].weight * one.slopes[i].lo, experts_[e].weight * one.slopes[i].hi};
    }
  }
  if (!out.fires) out.force_n = {model_.default_force_n, model_.default_force_n};
  if (!some_certain) include(out.force_n, model_.default_force_n);
  if (!out.fires || !out.smooth) return out;
  out.force_n = {mean.lo / weights, mean.hi / weights};
  for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
    out.slopes[i].lo /= weights;
    out.slopes[i].hi /= weights;
  }
  return out;
}

void ForceEnclosure::addExpert(const fuzzy::Expert& expert, double weight) {
  std::vector<std::size_t> bank_of;
  for (std::size_t i = 0; i < model_.inputs.size(); ++i)
    bank_of.push_back(bankOf(i, termsFor(expert, model_.inputs[i])));
  const auto& words = termsFor(expert, model_.output);
  ExpertLook look{weight, outputBankOf(words), {}};
  for (const fuzzy::Rule& rule : expert.rules) {
    if (!fuzzy::takesPart(rule)) continue;
    RuleLook one{rule.weight, static_cast<std::size_t>(findTerm(words, rule.then) - words.data()), {}};
    for (const fuzzy::Condition& condition : rule.conditions) {
      const auto input = std::find_if(model_.inputs.begin(), model_.inputs.end(),
                                      [&](const fuzzy::Variable& v) { return v.id == condition.input; });
      const auto& list = termsFor(expert, *input);
      one.conditions.emplace_back(bank_of[static_cast<std::size_t>(input - model_.inputs.begin())],
                                  static_cast<std::size_t>(findTerm(list, condition.term) - list.data()));
    }
    look.rules.push_back(std::move(one));
  }
  experts_.push_back(std::move(look));
}

std::size_t ForceEnclosure::bankOf(std::size_t input, const std::vector<fuzzy::Term>& list) {
  for (std::size_t b = 0; b < banks_.size(); ++b) {
    if (banks_[b].input == input && (banks_[b].list == &list || *banks_[b].list == list)) return b;
  }
  Bank bank{input, &list, {}};
  for (const fuzzy::Term& term : list) bank.terms.push_back(MembershipFunction::of(term));
  banks_.push_back(std::move(bank));
  return banks_.size() - 1;
}

double ForceEnclosure::partEnd(std::size_t part) const {
  const fuzzy::Variable& force = model_.output;
  return force.min + (force.max - force.min) * static_cast<double>(part) / kParts;
}

std::size_t ForceEnclosure::outputBankOf(const std::vector<fuzzy::Term>& list) {
  for (std::size_t b = 0; b < outputs_.size(); ++b) {
    if (outputs_[b].list == &list || *outputs_[b].list == list) return b;
  }
  OutputBank bank{&list, {}, {}, {}, {}};
  for (const fuzzy::Term& term : list) {
    const auto f = MembershipFunction::of(term);
    auto& lowest = bank.lowest.emplace_back();
    auto& highest = bank.highest.emplace_back();
    for (std::size_t part = 0; part < kParts; ++part) {
      const Range range = over(f, partEnd(part), partEnd(part + 1)).value;
      lowest[part] = range.lo;
      highest[part] = range.hi;
    }
    const auto above = [](double height) { return height > 0; };
    bank.first.push_back(
        static_cast<std::size_t>(std::find_if(highest.begin(), highest.end(), above) - highest.begin()));
    bank.last.push_back(
        kParts - static_cast<std::size_t>(std::find_if(highest.rbegin(), highest.rend(), above) - highest.rbegin()));
  }
  outputs_.push_back(std::move(bank));
  return outputs_.size() - 1;
}

std::size_t ForceEnclosure::strengthsOf(const std::vector<const RuleLook*>& rules,
                                        const std::vector<std::vector<Membership>>& memberships,
                                        std::span<Strength> strengths) const {
  std::size_t count = 0;
  const auto number_of = [&](std::size_t term) {
    for (std::size_t k = 0; k < count; ++k) {
      if (strengths[k].term == term) return k;
    }
    strengths[count] = {term, {0, 0}, {}, true};
    return count++;
  };
  struct Firing {
    const RuleLook* rule;
    Range range;
    std::size_t strength;  ///< the number of its own
  };
  static thread_local std::vector<Firing> firing;
  firing.clear();
  for (const RuleLook* const rule : rules) {
    Range range{1, 1};
    for (const auto& [bank, term] : rule->conditions) {
      const Range& value = memberships[bank][term].value;
      range = {std::min(range.lo, value.lo), std::min(range.hi, value.hi)};
    }
    range = {range.lo * rule->weight, range.hi * rule->weight};
    if (range.hi <= 0) continue;
    firing.push_back({rule, range, number_of(rule->then)});
    Range& value = strengths[firing.back().strength].value;
    value = {std::max(value.lo, range.lo), std::max(value.hi, range.hi)};
  }
  std::array<bool, fuzzy::kMostTerms> begun{};
  const std::size_t inputs = model_.inputs.size();
  for (const auto& [rule, range, k] : firing) {
    Strength& strength = strengths[k];
    if (range.hi < strength.value.lo) continue;
    for (const auto& [bank, term] : rule->conditions) {
      const Membership& membership = memberships[bank][term];
      strength.smooth = strength.smooth && !membership.jumps;
      // Another condition is always smaller.
      if (membership.value.lo * rule->weight > range.hi) continue;
      const std::size_t own = banks_[bank].input;
      const Range slope{membership.slope.lo * rule->weight, membership.slope.hi * rule->weight};
      for (std::size_t i = 0; i < inputs; ++i) {
        const Range one = i == own ? slope : Range{0, 0};
        if (!begun[k]) {
          strength.slopes[i] = one;
        } else {
          strength.slopes[i] = {std::min(strength.slopes[i].lo, one.lo), std::max(strength.slopes[i].hi, one.hi)};
        }
      }
      begun[k] = true;
    }
  }
  return count;
}

void ForceEnclosure::encloseExpert(const ExpertLook& expert, const std::vector<const RuleLook*>& rules,
                                   const std::vector<std::vector<Membership>>& memberships, One& out) const {
  std::vector<Strength>& all = scratch_;
  all.resize(fuzzy::kMostTerms);
  const std::span<Strength> strengths(all.data(), strengthsOf(rules, memberships, all));
  if (strengths.empty()) return;
  out.may_fire = true;
  out.certain = std::any_of(strengths.begin(), strengths.end(), [](const Strength& s) { return s.value.lo > 0; });
  out.smooth = std::all_of(strengths.begin(), strengths.end(), [](const Strength& s) { return s.smooth; });
  const OutputBank& bank = outputs_[expert.output];
  if (model_.implication == fuzzy::Implication::kClip) {
    encloseCentroid<true>(bank, strengths, out);
  } else {
    encloseCentroid<false>(bank, strengths, out);
  }
}

template <bool clip>
void ForceEnclosure::encloseCentroid(const OutputBank& bank, std::span<const Strength> strengths, One& out) const {
  Heights set;
  for (const Strength& s : strengths) {
    set.first = std::min(set.first, bank.first[s.term]);
    set.last = std::max(set.last, bank.last[s.term]);
  }
  for (auto* const heights : {&set.lowest, &set.highest, &set.second_lowest, &set.second_highest})
    std::fill(heights->begin() + static_cast<std::ptrdiff_t>(set.first),
              heights->begin() + static_cast<std::ptrdiff_t>(set.last), 0.0);
  for (const Strength& s : strengths) {
    const auto& lo = bank.lowest[s.term];
    const auto& hi = bank.highest[s.term];
    for (std::size_t p = bank.first[s.term]; p < bank.last[s.term]; ++p) {
      const double low = height<clip>(s.value.lo, lo[p]);
      const double high = height<clip>(s.value.hi, hi[p]);
      set.second_lowest[p] = std::max(set.second_lowest[p], std::min(set.lowest[p], low));
      set.lowest[p] = std::max(set.lowest[p], low);
      set.second_highest[p] = std::max(set.second_highest[p], std::min(set.highest[p], high));
      set.highest[p] = std::max(set.highest[p], high);
    }
  }
  Range area;
  const Range offset = centroidOf(set, area);
  out.force_n = {model_.output.min + offset.lo, model_.output.min + offset.hi};
  if (!out.certain || !out.smooth) return;
  if (!(area.lo > 0)) {
    out.smooth = false;
    return;
  }
  const double width = (model_.output.max - model_.output.min) / kParts;
  for (const Strength& s : strengths) {
    const auto rests = [](const Range& slope) { return slope.lo == 0 && slope.hi == 0; };
    if (std::all_of(s.slopes.begin(), s.slopes.begin() + static_cast<std::ptrdiff_t>(model_.inputs.size()), rests))
      continue;
    const auto& lo = bank.lowest[s.term];
    const auto& hi = bank.highest[s.term];
    Range moved{0, 0};
    for (std::size_t p = bank.first[s.term]; p < bank.last[s.term]; ++p) {
      const double low = height<clip>(s.value.lo, lo[p]);
      const double high = height<clip>(s.value.hi, hi[p]);
      const double others_low = low == set.lowest[p] ? set.second_lowest[p] : set.lowest[p];
      const double others_high = high == set.highest[p] ? set.second_highest[p] : set.highest[p];
      const bool may = (high >= others_low) & (!clip | (hi[p] > s.value.lo));
      const bool must = (low > others_high) & (!clip | (lo[p] > s.value.hi));
      const double most = may ? (clip ? 1 : hi[p]) : 0;
      const double least = must ? (clip ? 1 : lo[p]) : 0;
      const double left = width * static_cast<double>(p) - offset.hi;
      const double right = width * static_cast<double>(p + 1) - offset.lo;
      moved.lo += std::min(most * left, least * left);
      moved.hi += std::max(most * right, least * right);
    }
    const Range derivative{moved.lo / (moved.lo < 0 ? area.lo : area.hi),
                           moved.hi / (moved.hi > 0 ? area.lo : area.hi)};
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) out.slopes[i] += times(derivative, s.slopes[i]);
  }
}

Range ForceEnclosure::centroidOf(const Heights& set, Range& area) const {
  const double width = (model_.output.max - model_.output.min) / kParts;
  Range moment{0, 0};
  area = {0, 0};
  for (std::size_t p = set.first; p < set.last; ++p) {
    area += {set.lowest[p], set.highest[p]};
    moment += {set.lowest[p] * static_cast<double>(p), set.highest[p] * static_cast<double>(p + 1)};
  }
  // Each part before the centroid so far moves it on; the first that does not is the last to look at.
  Range at = moment;
  Range below = area;
  for (std::size_t p = set.first; p < set.last && static_cast<double>(p + 1) * below.hi < at.hi; ++p) {
    below.hi += set.lowest[p] - set.highest[p];
    at.hi += (set.lowest[p] - set.highest[p]) * static_cast<double>(p + 1);
  }
  for (std::size_t p = set.first; p < set.last && (static_cast<double>(p) * below.lo < at.lo || below.lo == 0); ++p) {
    below.lo += set.highest[p] - set.lowest[p];
    at.lo += (set.highest[p] - set.lowest[p]) * static_cast<double>(p);
  }
  const double margin = 1e-9;  // of a part, for rounding
  return {std::max(0.0, at.lo / below.lo - margin) * width,
          std::min(static_cast<double>(kParts), at.hi / below.hi + margin) * width};
}

}  // namespace tactus::bundle
