#include "app/bundle/table_bound.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <span>
#include <thread>

#include "core/fuzzy/takes_part.h"

namespace tactus::bundle {
namespace {

using fuzzy::MembershipFunction;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kParts = 64;  // of the universe of the output
constexpr double kInside = 1e-9;    // of a cell's width: from an edge on which the force may jump into the cell
constexpr std::size_t kMostBoxesOfCell = 4'000;
constexpr std::size_t kMostBoxes = 200'000'000;  // of all cells and experts
constexpr double kSharp = 1.02;                  // how close a bound comes to the error that was found

struct Range {
  double lo = 0;
  double hi = 0;

  Range& operator+=(const Range& other) {
    lo += other.lo;
    hi += other.hi;
    return *this;
  }
};

Range times(const Range& a, const Range& b) {
  const double p[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
  return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

void include(Range& range, double value) {
  range.lo = std::min(range.lo, value);
  range.hi = std::max(range.hi, value);
}

/// A membership and its derivative over an open interval.
struct Membership {
  Range value;
  Range slope;
  bool jumps = false;
};

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
  out.slope = {kInfinity, -kInfinity};
  if (rises) include(out.slope, 1 / (f.b - f.a));
  if (falls) include(out.slope, -1 / (f.d - f.c));
  if (rests || (!rises && !falls)) include(out.slope, 0);
  out.jumps = (f.a == f.b && lo < f.a && f.a < hi) || (f.c == f.d && lo < f.c && f.c < hi);
  return out;
}

/// A list of terms of one input, shared by the experts who have it.
struct Bank {
  std::size_t input = 0;
  const std::vector<fuzzy::Term>* list = nullptr;
  std::vector<MembershipFunction> terms;
};

/// The terms of the force, over equal parts of its universe.
struct OutputBank {
  const std::vector<fuzzy::Term>* list = nullptr;
  std::vector<std::array<double, kParts>> lowest, highest;  ///< membership within each part
  std::vector<std::size_t> first, last;                     ///< the parts in which it is above 0 at all; last excluded
};

struct RuleLook {
  double weight = 1;
  std::size_t then = 0;
  std::vector<std::pair<std::size_t, std::size_t>> conditions;  ///< bank, term
};

struct ExpertLook {
  double weight = 1;
  std::size_t output = 0;
  std::vector<RuleLook> rules;
};

/// The force over a box: where it lies, and its derivatives if they are bounded.
struct ForceRange {
  Range force_n;
  std::array<Range, fuzzy::kMostInputs> slopes{};
  bool smooth = true;  ///< every expert who counts fires everywhere in the box, and nothing jumps
  bool fires = false;  ///< somebody may
};

class ForceEnclosure {
 public:
  ForceEnclosure(const fuzzy::ForceModel& model) : model_(model) {
    const std::vector<double> weights = normalizedWeights(model);
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      if (weights[e] > 0) addExpert(model.experts[e], weights[e]);
    }
  }

  const std::vector<Bank>& banks() const { return banks_; }
  std::size_t experts() const { return experts_.size(); }

  /// Whether the rules that may fire in the cell are few is decided once per cell.
  struct Cell {
    std::vector<std::vector<const RuleLook*>> rules;  ///< of each expert
  };

  void lookAt(std::span<const double> lo, std::span<const double> hi, std::vector<std::vector<Membership>>& out) const {
    out.resize(banks_.size());
    for (std::size_t b = 0; b < banks_.size(); ++b) {
      out[b].clear();
      for (const auto& term : banks_[b].terms) out[b].push_back(over(term, lo[banks_[b].input], hi[banks_[b].input]));
    }
  }

  void cellOf(const std::vector<std::vector<Membership>>& memberships, Cell& cell) const {
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

  ForceRange enclose(const Cell& cell, const std::vector<std::vector<Membership>>& memberships) const {
    ForceRange out;
    out.force_n = {kInfinity, -kInfinity};
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

 private:
  /// One expert over a box.
  struct One {
    Range force_n;
    std::array<Range, fuzzy::kMostInputs> slopes{};
    bool may_fire = false;
    bool certain = false;
    bool smooth = true;
  };

  void addExpert(const fuzzy::Expert& expert, double weight) {
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

  std::size_t bankOf(std::size_t input, const std::vector<fuzzy::Term>& list) {
    for (std::size_t b = 0; b < banks_.size(); ++b) {
      if (banks_[b].input == input && (banks_[b].list == &list || *banks_[b].list == list)) return b;
    }
    Bank bank{input, &list, {}};
    for (const fuzzy::Term& term : list) bank.terms.push_back(MembershipFunction::of(term));
    banks_.push_back(std::move(bank));
    return banks_.size() - 1;
  }

  double partEnd(std::size_t part) const {
    const fuzzy::Variable& force = model_.output;
    return force.min + (force.max - force.min) * static_cast<double>(part) / kParts;
  }

  std::size_t outputBankOf(const std::vector<fuzzy::Term>& list) {
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

  /// The strength of one output term over a box.
  struct Strength {
    std::size_t term = 0;
    Range value;
    std::array<Range, fuzzy::kMostInputs> slopes{};
    bool smooth = true;
  };

  /// The terms that may fire, in `strengths`; how many.
  std::size_t strengthsOf(const std::vector<const RuleLook*>& rules,
                          const std::vector<std::vector<Membership>>& memberships,
                          std::span<Strength> strengths) const {
    std::size_t count = 0;
    const auto range_of = [&](const RuleLook& rule) {
      Range range{1, 1};
      for (const auto& [bank, term] : rule.conditions) {
        range.lo = std::min(range.lo, memberships[bank][term].value.lo);
        range.hi = std::min(range.hi, memberships[bank][term].value.hi);
      }
      return Range{range.lo * rule.weight, range.hi * rule.weight};
    };
    const auto strength_of = [&](std::size_t term) -> Strength& {
      for (std::size_t k = 0; k < count; ++k) {
        if (strengths[k].term == term) return strengths[k];
      }
      strengths[count] = {term, {0, 0}, {}, true};
      return strengths[count++];
    };
    for (const RuleLook* const rule : rules) {
      const Range range = range_of(*rule);
      if (range.hi <= 0) continue;
      Range& value = strength_of(rule->then).value;
      value = {std::max(value.lo, range.lo), std::max(value.hi, range.hi)};
    }
    std::array<bool, fuzzy::kMostTerms> begun{};
    for (const RuleLook* const rule : rules) {
      const Range range = range_of(*rule);
      if (range.hi <= 0) continue;
      Strength& strength = strength_of(rule->then);
      if (range.hi < strength.value.lo) continue;
      const auto k = static_cast<std::size_t>(&strength - strengths.data());
      for (const auto& [bank, term] : rule->conditions) {
        const Membership& membership = memberships[bank][term];
        strength.smooth = strength.smooth && !membership.jumps;
        // Another condition is always smaller.
        if (membership.value.lo * rule->weight > range.hi) continue;
        for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
          const Range slope = i == banks_[bank].input
                                  ? Range{membership.slope.lo * rule->weight, membership.slope.hi * rule->weight}
                                  : Range{0, 0};
          if (!begun[k]) {
            strength.slopes[i] = slope;
          } else {
            include(strength.slopes[i], slope.lo);
            include(strength.slopes[i], slope.hi);
          }
        }
        begun[k] = true;
      }
    }
    return count;
  }

  void encloseExpert(const ExpertLook& expert, const std::vector<const RuleLook*>& rules,
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

  /// The parts of the output that are looked at, and the heights of the set there: the two largest of the terms'.
  struct Heights {
    std::size_t first = kParts;
    std::size_t last = 0;
    std::array<double, kParts> lowest, highest, second_lowest, second_highest;
  };

  template <bool clip>
  static double height(double strength, double membership) {
    return clip ? std::min(strength, membership) : strength * membership;
  }

  template <bool clip>
  void encloseCentroid(const OutputBank& bank, std::span<const Strength> strengths, One& out) const {
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

  /// Where the centroid of a set between the two can lie, from the lower end of the universe: it is largest for the
  /// upper set beyond some point and the lower one before it. `area`: of the set, in parts.
  Range centroidOf(const Heights& set, Range& area) const {
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

  const fuzzy::ForceModel& model_;
  std::vector<Bank> banks_;
  std::vector<OutputBank> outputs_;
  std::vector<ExpertLook> experts_;
  static inline thread_local std::vector<Strength> scratch_;
};

/// A part of a cell. Corner c lies at the upper end of input i where bit i of c is set.
struct Box {
  std::array<double, fuzzy::kMostInputs> lo{};
  std::array<double, fuzzy::kMostInputs> hi{};
  std::vector<double> force_n;
  std::vector<double> table_n;
  double bound_n = 0;  ///< on the error in it
  bool jumps = false;
  std::size_t longest = 0;  ///< the input along which to split it
  double longest_share = 0;
};

/// Looks at the cells of one slab of the table.
class CellSearch {
 public:
  CellSearch(const fuzzy::CompiledModel& compiled, const ForceTable& table, const ForceEnclosure& enclosure,
             double wanted_n, std::size_t most_boxes)
      : compiled_(compiled),
        table_(table),
        enclosure_(enclosure),
        wanted_n_(wanted_n),
        enough_n_(wanted_n),
        most_boxes_(most_boxes) {
    for (const auto& line : table.lines) out_.finer.emplace_back(line.size() - 1, 1.0);
  }

  /// `cell`: the number of the lower line of each input. `inside`: its corners are taken within it, because the force
  /// may jump at its edge.
  void look(const std::vector<std::size_t>& cell, bool inside) {
    open_.clear();
    Box root = rootOf(cell, inside);
    findMemberships(root, cell.size());
    enclosure_.cellOf(memberships_, rules_);
    add(std::move(root), cell);
    // Once the work for all is spent, a cell gets a bound from one look. The worst box comes first.
    for (std::size_t left = boxes_ < most_boxes_ ? kMostBoxesOfCell : 0; !open_.empty(); --left) {
      const Box& worst = open_.front();
      if (worst.bound_n <= enough_n_ || left == 0 || worst.longest_share <= (worst.jumps ? kThin : 0)) {
        out_.bound_n = std::max(out_.bound_n, worst.bound_n);
        out_.jumps = out_.jumps || worst.jumps;
        if (worst.bound_n > wanted_n_ && !worst.jumps) wantFiner(worst, cell);
        return;
      }
      std::pop_heap(open_.begin(), open_.end(), isBetter);
      Box box = std::move(open_.back());
      open_.pop_back();
      split(std::move(box), cell);
    }
  }

  TableBound result() && { return std::move(out_); }

 private:
  static constexpr double kThin = 1.0 / 64;  ///< of a cell: a box beside a jump is not made thinner

  static bool isBetter(const Box& a, const Box& b) { return a.bound_n < b.bound_n; }

  void findMemberships(const Box& box, std::size_t inputs) {
    enclosure_.lookAt({box.lo.data(), inputs}, {box.hi.data(), inputs}, memberships_);
  }

  void wantFiner(const Box& worst, const std::vector<std::size_t>& cell) {
    findMemberships(worst, cell.size());
    const ForceRange range = enclosure_.enclose(rules_, memberships_);
    for (std::size_t i = 0; i < cell.size(); ++i) {
      if (range.slopes[i].lo == range.slopes[i].hi) continue;
      double& finer = out_.finer[i][cell[i]];
      finer = std::max(finer, worst.bound_n / wanted_n_);
    }
  }

  /// Bounds the error in the box, and keeps it for a closer look.
  void add(Box box, const std::vector<std::size_t>& cell) {
    ++boxes_;
    findMemberships(box, cell.size());
    const ForceRange range = enclosure_.enclose(rules_, memberships_);
    box.jumps = range.fires && !range.smooth;
    double off_n = 0;
    for (std::size_t c = 0; c < box.force_n.size(); ++c)
      off_n = std::max(off_n, std::abs(box.force_n[c] - box.table_n[c]));
    const auto [table_lo, table_hi] = std::minmax_element(box.table_n.begin(), box.table_n.end());
    box.bound_n = std::max(range.force_n.hi - *table_lo, *table_hi - range.force_n.lo);
    box.longest_share = 0;
    double rest_n = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const double width = box.hi[i] - box.lo[i];
      const double slope = range.slopes[i].hi - range.slopes[i].lo;
      double share = slope * width;
      if (box.jumps) share = isFlat(i) ? 0 : width / (table_.lines[i][cell[i] + 1] - table_.lines[i][cell[i]]);
      rest_n += slope * width / 4;
      if (share <= box.longest_share) continue;
      box.longest_share = share;
      box.longest = i;
    }
    if (!box.jumps) {
      box.bound_n = std::min(box.bound_n, off_n + rest_n);
      out_.found_n = std::max(out_.found_n, off_n);
      enough_n_ = std::max(enough_n_, kSharp * off_n);
    }
    open_.push_back(std::move(box));
    std::push_heap(open_.begin(), open_.end(), isBetter);
  }

  bool isFlat(std::size_t input) const {
    for (std::size_t b = 0; b < enclosure_.banks().size(); ++b) {
      if (enclosure_.banks()[b].input != input) continue;
      for (const Membership& one : memberships_[b]) {
        if (one.slope.lo != 0 || one.slope.hi != 0 || one.jumps) return false;
      }
    }
    return true;
  }

  Box rootOf(const std::vector<std::size_t>& cell, bool inside) const {
    const std::size_t inputs = cell.size();
    Box box;
    for (std::size_t i = 0; i < inputs; ++i) {
      box.lo[i] = table_.lines[i][cell[i]];
      box.hi[i] = table_.lines[i][cell[i] + 1];
    }
    std::array<double, fuzzy::kMostInputs> point{};
    for (std::size_t c = 0; c < (std::size_t{1} << inputs); ++c) {
      std::size_t node = 0;
      for (std::size_t i = 0; i < inputs; ++i) {
        const bool upper = (c >> i & 1U) != 0;
        node = node * table_.lines[i].size() + cell[i] + (upper ? 1 : 0);
        const double step = kInside * (box.hi[i] - box.lo[i]);
        point[i] = upper ? box.hi[i] - step : box.lo[i] + step;
      }
      box.table_n.push_back(table_.force_n[node]);
      if (!inside) {
        for (std::size_t i = 0; i < inputs; ++i) point[i] = (c >> i & 1U) != 0 ? box.hi[i] : box.lo[i];
      }
      box.force_n.push_back(forceAt(point, inputs));
    }
    return box;
  }

  double forceAt(const std::array<double, fuzzy::kMostInputs>& point, std::size_t inputs) const {
    return compiled_.evaluate({point.data(), inputs}).force_n;
  }

  void split(Box box, const std::vector<std::size_t>& cell) {
    const std::size_t input = box.longest;
    const double middle = box.lo[input] + (box.hi[input] - box.lo[input]) / 2;
    Box lower = box;
    lower.hi[input] = middle;
    box.lo[input] = middle;
    std::array<double, fuzzy::kMostInputs> point{};
    const std::size_t bit = std::size_t{1} << input;
    for (std::size_t c = 0; c < box.force_n.size(); ++c) {
      if ((c & bit) != 0) continue;
      for (std::size_t i = 0; i < cell.size(); ++i) point[i] = (c >> i & 1U) != 0 ? box.hi[i] : box.lo[i];
      const double force_n = forceAt(point, cell.size());
      const double table_n = (box.table_n[c] + box.table_n[c | bit]) / 2;
      lower.force_n[c | bit] = box.force_n[c] = force_n;
      lower.table_n[c | bit] = box.table_n[c] = table_n;
    }
    add(std::move(box), cell);
    add(std::move(lower), cell);
  }

  const fuzzy::CompiledModel& compiled_;
  const ForceTable& table_;
  const ForceEnclosure& enclosure_;
  double wanted_n_;
  double enough_n_;
  std::size_t most_boxes_;
  std::size_t boxes_ = 0;
  TableBound out_;
  std::vector<Box> open_;  ///< a heap, the worst first
  std::vector<std::vector<Membership>> memberships_;
  ForceEnclosure::Cell rules_;
};

/// What is known of the lines of one input.
struct AxisLook {
  std::vector<bool> skipped;  ///< a cell in which no membership changes: it is the edge of a neighbor
  bool jumps = false;         ///< at a line or between two
};

AxisLook lookAlong(const ForceEnclosure& enclosure, std::size_t input, const std::vector<double>& line) {
  AxisLook out;
  std::vector<bool> flat(line.size() - 1, true);
  std::vector<bool> jump_at(line.size(), false);
  for (const Bank& bank : enclosure.banks()) {
    if (bank.input != input) continue;
    for (const MembershipFunction& term : bank.terms) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Membership one = over(term, line[k], line[k + 1]);
        flat[k] = flat[k] && one.slope.lo == 0 && one.slope.hi == 0 && !one.jumps;
        out.jumps = out.jumps || one.jumps;
      }
      for (std::size_t k = 1; k + 1 < line.size() && !term.gaussian; ++k)
        jump_at[k] = jump_at[k] || fromTheLeft(term, line[k]) != fromTheRight(term, line[k]);
    }
  }
  out.jumps = out.jumps || std::find(jump_at.begin(), jump_at.end(), true) != jump_at.end();
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const bool beside = (k > 0 && !flat[k - 1]) || (k + 1 < flat.size() && !flat[k + 1]);
    out.skipped.push_back(flat[k] && beside && !jump_at[k] && !jump_at[k + 1]);
  }
  return out;
}

void merge(TableBound& all, const TableBound& one) {
  all.bound_n = std::max(all.bound_n, one.bound_n);
  all.found_n = std::max(all.found_n, one.found_n);
  all.jumps = all.jumps || one.jumps;
  for (std::size_t i = 0; i < all.finer.size(); ++i) {
    for (std::size_t k = 0; k < all.finer[i].size(); ++k) all.finer[i][k] = std::max(all.finer[i][k], one.finer[i][k]);
  }
}

}  // namespace

TableBound tableBound(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const ForceTable& table,
                      double wanted_n, const std::stop_token& stop) {
  const ForceEnclosure enclosure(model);
  std::vector<std::vector<std::size_t>> cells;  // of each input
  bool inside = false;
  std::size_t slabs_along = 0;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    const AxisLook axis = lookAlong(enclosure, i, table.lines[i]);
    inside = inside || axis.jumps;
    auto& own = cells.emplace_back();
    for (std::size_t k = 0; k < axis.skipped.size(); ++k) {
      if (!axis.skipped[k]) own.push_back(k);
    }
    if (own.size() > cells[slabs_along].size()) slabs_along = i;
  }
  TableBound out;
  for (const auto& line : table.lines) out.finer.emplace_back(line.size() - 1, 1.0);
  const std::size_t slabs = cells[slabs_along].size();
  const std::size_t most_boxes = kMostBoxes / std::max<std::size_t>(1, enclosure.experts() * slabs);
  // Each slab for itself, so that the result does not depend on how many are looked at at once.
  const auto slab = [&](std::size_t number) {
    CellSearch search(compiled, table, enclosure, wanted_n, most_boxes);
    auto own = cells;
    own[slabs_along] = {cells[slabs_along][number]};
    std::vector<std::size_t> index(own.size(), 0);
    std::vector<std::size_t> cell(own.size());
    for (bool more = true; more && !stop.stop_requested();) {
      for (std::size_t i = 0; i < own.size(); ++i) cell[i] = own[i][index[i]];
      search.look(cell, inside);
      more = false;
      for (std::size_t i = own.size(); i-- > 0 && !more;) {
        more = ++index[i] < own[i].size();
        if (!more) index[i] = 0;
      }
    }
    return std::move(search).result();
  };
  std::atomic<std::size_t> next = 0;
  std::vector<TableBound> found(slabs);
  const auto work = [&] {
    for (std::size_t number = next++; number < slabs; number = next++) found[number] = slab(number);
  };
  std::vector<std::future<void>> helpers;
  for (unsigned h = 1; h < std::max(1U, std::thread::hardware_concurrency()); ++h)
    helpers.push_back(std::async(std::launch::async, work));
  work();
  for (auto& helper : helpers) helper.get();
  for (const TableBound& one : found) merge(out, one);
  return out;
}

}  // namespace tactus::bundle
