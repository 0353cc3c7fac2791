#include "core/contracts/force_cells.h"

#include <cmath>

#include "core/contracts/cell_tables.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::contracts {
namespace {

using fuzzy::MembershipFunction;

Condition conditionIn(const MembershipFunction& f, const Stretch& stretch, std::size_t variable) {
  Condition out;
  out.flank.variable = variable;
  if (stretch.low == stretch.high) {
    const double v = f(stretch.low);
    if (v == 0) return out;
    out.kind = v == 1 && !f.gaussian ? Condition::Kind::kFully : Condition::Kind::kFlank;
    out.flank.constant = {std::max(0.0, down(down(down(v)))), std::min(1.0, up(up(up(v))))};
    if (f.gaussian) {
      out.flank.kind = Flank::Kind::kGaussian;
      out.flank.foot = f.mean, out.flank.span = f.sigma;
      out.flank.constant = out.flank.at(stretch.low);
      out.flank.kind = Flank::Kind::kConstant;
    }
    return out;
  }
  const double x = stretch.low + (stretch.high - stretch.low) / 2;
  out.kind = Condition::Kind::kFlank;
  if (f.gaussian) {
    if (f(x) == 0) return {};
    out.flank.kind = Flank::Kind::kGaussian;
    out.flank.foot = f.mean, out.flank.span = f.sigma;
    return out;
  }
  if (x <= f.a || x >= f.d) return {};
  out.flank.kind = Flank::Kind::kLine;
  if (x < f.b) {
    out.flank.foot = f.a, out.flank.span = f.b - f.a;
  } else if (x > f.c) {
    out.flank.foot = f.d, out.flank.span = f.c - f.d;
  } else {
    out.kind = Condition::Kind::kFully;
  }
  return out;
}

/// Jumps as they are seen from within `range`: at its ends only those that the inside does not share.
void addVertices(const MembershipFunction& f, const Interval& range, std::vector<double>& vertices,
                 std::vector<double>& jumps) {
  if (f.gaussian) {
    const fuzzy::Support support = fuzzy::supportOf(f);
    vertices.insert(vertices.end(), {support.low, f.mean, support.high});
    return;
  }
  vertices.insert(vertices.end(), {f.a, f.b, f.c, f.d});
  if (f.a == f.b && f.a > range.low && f.a <= range.high) jumps.push_back(f.a);
  if (f.c == f.d && f.d >= range.low && f.d < range.high) jumps.push_back(f.d);
}

void sortOnce(std::vector<double>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

ForceSum::ForceSum(std::vector<Copy> copies, std::vector<Interval> ranges)
    : copies_(std::move(copies)),
      ranges_(std::move(ranges)),
      vertices_(ranges_.size()),
      jumps_(ranges_.size()),
      tables_(std::make_unique<Tables>()),
      scratch_(std::make_unique<Scratch>()) {
  tables_->terms.resize(ranges_.size());
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    const fuzzy::ForceModel& model = *copies_[c].model;
    const std::vector<double> weights = fuzzy::normalizedWeights(model);
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const fuzzy::Expert& expert = model.experts[e];
      if (!(weights[e] > 0)) continue;
      Tables::Expert out;
      out.copy = c;
      out.weight = weights[e];
      out.low = model.output.min, out.high = model.output.max;
      out.output = &termsFor(expert, model.output);
      const auto& output = termsFor(expert, model.output);
      out.sets = OutputSets::of(output, model.output.min, model.output.max, model.implication);
      out.reach.resize(output.size());
      for (std::size_t t = 0; t < output.size(); ++t) {
        const auto f = MembershipFunction::of(output[t]);
        const Interval whole = Interval(model.output.min, model.output.max);
        const Interval reach = f.gaussian ? whole : common(whole, Interval(f.a, f.d));
        if (out.sets) {
          out.reach[out.sets->placeOf(t)] = out.sets->reachOf(out.sets->placeOf(t));
        } else {
          out.reach[t] = reach - model.output.min;
        }
      }
      for (const fuzzy::Rule& rule : expert.rules) {
        if (!fuzzy::takesPart(rule)) continue;
        Tables::Rule one;
        one.weight = rule.weight;
        const auto then = static_cast<std::size_t>(findTerm(output, rule.then) - output.data());
        one.place = out.sets ? out.sets->placeOf(then) : then;
        for (const fuzzy::Condition& condition : rule.conditions) {
          std::size_t i = 0;
          while (model.inputs[i].id != condition.input) ++i;
          const std::size_t v = copies_[c].variables[i];
          const auto f = MembershipFunction::of(*findTerm(termsFor(expert, model.inputs[i]), condition.term));
          auto& known = tables_->terms[v];
          const auto same = std::find_if(known.begin(), known.end(), [&](const MembershipFunction& g) {
            return f.gaussian == g.gaussian && f.a == g.a && f.b == g.b && f.c == g.c && f.d == g.d &&
                   f.mean == g.mean && f.sigma == g.sigma;
          });
          one.conditions.emplace_back(v, static_cast<std::size_t>(same - known.begin()));
          if (same == known.end()) {
            known.push_back(f);
            addVertices(f, ranges_[v], vertices_[v], jumps_[v]);
          }
        }
        out.rules.push_back(std::move(one));
      }
      tables_->experts.push_back(std::move(out));
    }
  }
  for (std::size_t v = 0; v < ranges_.size(); ++v) {
    std::erase_if(vertices_[v], [&](double x) { return !(x > ranges_[v].low && x < ranges_[v].high); });
    sortOnce(vertices_[v]);
    sortOnce(jumps_[v]);
  }
  scratch_->conditions.resize(ranges_.size());
}

ForceSum::~ForceSum() = default;

bool ForceSum::jumpsAt(std::size_t variable, double vertex) const noexcept {
  return std::binary_search(jumps_[variable].begin(), jumps_[variable].end(), vertex);
}

std::vector<Stretch> ForceSum::stretches(std::size_t variable) const {
  std::vector<Stretch> out;
  double from = ranges_[variable].low;
  out.push_back({from, from});
  if (from == ranges_[variable].high) return out;
  for (const double vertex : vertices_[variable]) {
    out.push_back({from, vertex});
    out.push_back({vertex, vertex});
    from = vertex;
  }
  out.push_back({from, ranges_[variable].high});
  out.push_back({ranges_[variable].high, ranges_[variable].high});
  return out;
}

/// A cell in which none of the experts number `first` to `last` fires. Variable after variable the rules are narrowed
/// down to those that a stretch leaves; what one without further conditions covers is not divided any more.
std::optional<std::vector<Stretch>> ForceSum::silentCellOf(std::size_t first, std::size_t last) const {
  std::vector<const Tables::Rule*> all;
  for (std::size_t e = first; e < last; ++e) {
    for (const Tables::Rule& rule : tables_->experts[e].rules) all.push_back(&rule);
  }
  std::vector<Stretch> cell;
  const auto search = [&](const auto& self, const std::vector<const Tables::Rule*>& rules) -> bool {
    const std::size_t v = cell.size();
    const auto is_done = [&](const Tables::Rule* rule) {
      return std::all_of(rule->conditions.begin(), rule->conditions.end(), [&](const auto& c) { return c.first < v; });
    };
    if (std::any_of(rules.begin(), rules.end(), is_done)) return false;
    if (v == ranges_.size()) return true;
    if (rules.empty()) {
      for (std::size_t rest = v; rest < ranges_.size(); ++rest) cell.push_back(stretches(rest).front());
      return true;
    }
    for (const Stretch& stretch : stretches(v)) {
      std::vector<const Tables::Rule*> left;
      for (const Tables::Rule* const rule : rules) {
        const bool never = std::any_of(rule->conditions.begin(), rule->conditions.end(), [&](const auto& c) {
          return c.first == v && conditionIn(tables_->terms[v][c.second], stretch, v).kind == Condition::Kind::kNever;
        });
        if (!never) left.push_back(rule);
      }
      cell.push_back(stretch);
      if (self(self, left)) return true;
      cell.pop_back();
    }
    return false;
  };
  return search(search, all) ? std::optional(cell) : std::nullopt;
}

bool ForceSum::allFireEverywhere() const {
  for (std::size_t e = 0; e < tables_->experts.size(); ++e) {
    if (silentCellOf(e, e + 1)) return false;
  }
  return true;
}

std::optional<std::vector<Stretch>> ForceSum::silentCell() const {
  std::size_t last = 0;
  while (last < tables_->experts.size() && tables_->experts[last].copy == 0) ++last;
  return silentCellOf(0, last);
}

bool ForceSum::enter(std::span<const Stretch> cell) {
  Scratch& s = *scratch_;
  for (std::size_t v = 0; v < ranges_.size(); ++v) {
    const bool same = v < cell_.size() && cell_[v].low == cell[v].low && cell_[v].high == cell[v].high;
    if (same && !s.conditions[v].empty()) continue;
    s.conditions[v].clear();
    for (const auto& f : tables_->terms[v]) s.conditions[v].push_back(conditionIn(f, cell[v], v));
  }
  cell_.assign(cell.begin(), cell.end());

  s.flanks.clear();
  s.firing.clear();
  firing_.assign(tables_->experts.size(), false);
  bool few = true;
  const auto number_of = [&](const Flank& flank) {
    const auto same = std::find(s.flanks.begin(), s.flanks.end(), flank);
    const auto number = static_cast<std::size_t>(same - s.flanks.begin());
    if (same == s.flanks.end()) s.flanks.push_back(flank);
    few = few && number < kMostFlanks;
    return few ? number : 0;
  };
  std::vector<Interval> weights(copies_.size());
  for (std::size_t e = 0; e < tables_->experts.size(); ++e) {
    const Tables::Expert& expert = tables_->experts[e];
    Scratch::Firing one;
    one.expert = &expert;
    one.rules.resize(expert.reach.size());
    for (const Tables::Rule& rule : expert.rules) {
      Mask mask = 0;
      bool never = false;
      for (const auto& [v, term] : rule.conditions) {
        const Condition& condition = s.conditions[v][term];
        never = never || condition.kind == Condition::Kind::kNever;
        if (never) break;
        if (condition.kind != Condition::Kind::kFlank) continue;
        Flank flank = condition.flank;
        flank.weight = rule.weight;
        if (flank.kind == Flank::Kind::kConstant) flank.constant = flank.constant * rule.weight;
        mask |= bit(number_of(flank));
      }
      if (never) continue;
      if (mask == 0) {
        Flank flank;
        flank.constant = rule.weight;
        mask = bit(number_of(flank));
      }
      auto& rules = one.rules[rule.place];
      if (std::find(rules.begin(), rules.end(), mask) == rules.end()) rules.push_back(mask);
      firing_[e] = true;
    }
    if (!firing_[e]) continue;
    weights[expert.copy] = weights[expert.copy].high > 0 ? weights[expert.copy] + expert.weight : expert.weight;
    s.firing.push_back(std::move(one));
  }
  s.constant = 0.0;
  force_everywhere_ = true;
  for (std::size_t c = 0; c < copies_.size(); ++c) {
    if (weights[c].high > 0) continue;
    force_everywhere_ = false;
    s.constant = s.constant + copies_[c].model->default_force_n * copies_[c].sign;
  }
  for (Scratch::Firing& one : s.firing)
    one.share = Interval(one.expert->weight) / weights[one.expert->copy] * copies_[one.expert->copy].sign;
  cancelEqual();
  return few;
}

/// Experts of two copies with opposite signs that say the same in this cell add nothing to the sum.
void ForceSum::cancelEqual() {
  auto& firing = scratch_->firing;
  const auto are_opposite = [&](const Scratch::Firing& a, const Scratch::Firing& b) {
    const fuzzy::ForceModel& first = *copies_[a.expert->copy].model;
    const fuzzy::ForceModel& second = *copies_[b.expert->copy].model;
    return copies_[a.expert->copy].sign == -copies_[b.expert->copy].sign && a.share.low == -b.share.high &&
           a.share.high == -b.share.low && a.expert->low == b.expert->low && a.expert->high == b.expert->high &&
           first.implication == second.implication && a.rules == b.rules && *a.expert->output == *b.expert->output;
  };
  for (std::size_t i = 0; i < firing.size(); ++i) {
    for (std::size_t j = i + 1; j < firing.size() && !firing[i].cancels; ++j) {
      if (firing[j].cancels || !are_opposite(firing[i], firing[j])) continue;
      firing[i].cancels = firing[j].cancels = true;
    }
  }
}

Part ForceSum::whole() const {
  Part part;
  for (std::size_t v = 0; v < ranges_.size(); ++v) part.box[v] = {cell_[v].low, cell_[v].high};
  return part;
}

}  // namespace tactus::contracts
