#include "core/analysis/lint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/analysis/centroid_bound.h"
#include "core/analysis/directions.h"
#include "core/analysis/force_difference.h"
#include "core/analysis/force_probe.h"
#include "core/analysis/rule_table.h"
#include "core/analysis/sample_points.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using Cache = std::map<std::vector<BoundedTerm>, ForceBounds>;

std::optional<ForceBounds> boundsOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, Cache& cache) {
  const double lo = model.output.min;
  const double hi = model.output.max;
  const auto& terms = termsFor(expert, model.output);
  const auto strengths = largestStrengths(model, expert, resolveRules(model, expert));
  const bool clip = model.implication == fuzzy::Implication::kClip;
  std::vector<BoundedTerm> upright;
  std::vector<BoundedTerm> mirrored;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (strengths[t] == 0) continue;
    const auto f = fuzzy::MembershipFunction::of(terms[t]);
    const BoundedTerm term = BoundedTerm::of(f, clip ? strengths[t] : 1);
    upright.push_back(term.from(lo));
    mirrored.push_back(term.mirroredAt(hi));
  }
  if (upright.empty()) return std::nullopt;
  const auto [it, fresh] = cache.try_emplace(upright);
  if (fresh) {
    const double width = hi - lo;
    // One ulp of a position may be more than the margin where the universe is narrow and far from 0.
    const double margin =
        kRounding * width + 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lo), std::abs(hi));
    it->second = {std::max(lo, lo + lowerCentroidBound(upright, clip, width) - margin),
                  std::min(hi, hi - lowerCentroidBound(mirrored, clip, width) + margin)};
  }
  return it->second;
}

/// Smallest mean of values with weights: those in `always` count in any case, any of the others may.
struct Weighted {
  double value, weight;
  bool always;
};

double smallestMean(std::vector<Weighted> all) {
  double weights = 0;
  double sum = 0;
  for (const auto& item : all) {
    if (!item.always) continue;
    weights += item.weight;
    sum += item.weight * item.value;
  }
  std::sort(all.begin(), all.end(), [](const Weighted& x, const Weighted& y) { return x.value < y.value; });
  if (weights == 0) return all.front().value;
  for (const auto& item : all) {
    if (item.always || item.value >= sum / weights) continue;
    weights += item.weight;
    sum += item.weight * item.value;
  }
  return sum / weights;
}

}  // namespace

std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, std::size_t expert) {
  Cache cache;
  return boundsOf(model, model.experts[expert], cache);
}

std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, const std::vector<bool>& always_fires) {
  Cache cache;
  const std::vector<double> weights = normalizedWeights(model);
  std::vector<Weighted> low;
  std::vector<Weighted> high;
  const double lo = model.output.min;
  const double hi = model.output.max;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const double weight = weights[e];
    if (weight == 0) continue;
    const auto bounds = boundsOf(model, model.experts[e], cache);
    if (!bounds) continue;
    low.push_back({bounds->min_n - lo, weight, always_fires[e]});
    high.push_back({hi - bounds->max_n, weight, always_fires[e]});
  }
  if (low.empty()) return std::nullopt;
  const double margin =
      kRounding * (hi - lo) + 8 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lo), std::abs(hi));
  return ForceBounds{std::max(lo, lo + smallestMean(low) - margin), std::min(hi, hi - smallestMean(high) + margin)};
}

namespace {

/// One face of a hole: the last value of `input` inside and the first one outside.
struct Face {
  std::size_t input;
  double inside, outside;
};

/// First double that belongs to the range from below, and from above.
double lowest(const InputRange& range) { return range.low_included ? range.low : std::nextafter(range.low, HUGE_VAL); }
double highest(const InputRange& range) {
  return range.high_included ? range.high : std::nextafter(range.high, -HUGE_VAL);
}

std::vector<Face> facesOf(const fuzzy::ForceModel& model, const Hole& hole) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < hole.ranges.size(); ++i) {
    const double low = lowest(hole.ranges[i]);
    const double high = highest(hole.ranges[i]);
    if (low > model.inputs[i].min) faces.push_back({i, low, std::nextafter(low, -HUGE_VAL)});
    if (high < model.inputs[i].max) faces.push_back({i, high, std::nextafter(high, HUGE_VAL)});
  }
  return faces;
}

/// Jump in newtons between a point inside and one outside, or nothing where there is none to speak of.
using Jump =
    std::function<std::optional<double>(const std::vector<double>& inside, const std::vector<double>& outside)>;

std::optional<BoundaryJump> largestJump(const ForceProbe& probe, const Hole& hole, std::size_t samples,
                                        const Jump& jump) {
  std::optional<BoundaryJump> largest;
  for (const Face& face : facesOf(probe.model(), hole)) {
    if (!probe.affords()) break;
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < hole.ranges.size(); ++i) {
      values.push_back(i == face.input ? std::vector<double>{face.inside}
                                       : probe.values(i, lowest(hole.ranges[i]), highest(hole.ranges[i])));
    }
    const SamplePoints points(std::move(values), samples);
    const auto look = [&](const SamplePoints::Choice& choice) -> std::optional<double> {
      if (!probe.affords()) return std::nullopt;
      const auto inside = points.at(choice);
      auto outside = inside;
      outside[face.input] = face.outside;
      const auto newtons = jump(inside, outside);
      if (newtons && (!largest || *newtons > largest->newtons)) largest = BoundaryJump{*newtons, outside, inside};
      return newtons;
    };
    std::optional<double> best;
    SamplePoints::Choice where;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto choice = points.choice(p);
      const auto newtons = look(choice);
      if (newtons && (!best || *newtons > *best)) best = newtons, where = choice;
    }
    if (best) points.climb(where, *best, look);
  }
  return largest;
}

}  // namespace

std::optional<BoundaryJump> jumpToDefault(ForceProbe& probe, const Hole& hole, std::optional<std::size_t> expert,
                                          std::size_t samples) {
  return largestJump(probe, hole, samples, [&](const auto& /*inside*/, const auto& outside) -> std::optional<double> {
    const auto beside = expert ? probe.expert(*expert, outside) : probe.mean(outside);
    if (!beside.fired) return std::nullopt;
    return std::abs(beside.force_n - probe.model().default_force_n);
  });
}

std::optional<BoundaryJump> jumpOfMean(ForceProbe& probe, const Hole& hole, std::size_t expert, std::size_t samples) {
  return largestJump(probe, hole, samples, [&](const auto& inside, const auto& outside) -> std::optional<double> {
    if (!probe.expert(expert, outside).fired) return std::nullopt;
    const auto without = probe.mean(inside);
    if (!without.fired) return std::nullopt;
    return std::abs(probe.mean(outside).force_n - without.force_n);
  });
}

namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Variable;
using Kind = Finding::Kind;

// Rules looked at for the newtons of all findings together: below a second also where there are many.
constexpr std::size_t kAllowance = 100'000'000;
// Each expert's share of the search for holes is at least this, enough for some hundreds of boxes.
constexpr std::size_t kSmallestSearch = 100'000;
// Settings of the other inputs at each place, and as many again beside the best one.
constexpr std::size_t kMostSettings = 100;
// Jumps below this share of the output's universe are rounding.
constexpr double kNoJump = 1e-12;

class Linter {
 public:
  Linter(const ForceModel& model, const fuzzy::CompiledModel& compiled, const std::stop_token& stop)
      : model_(model), stop_(stop), probe_(model, compiled, kAllowance, stop), always_fires_(model.experts.size()) {}

  Lint run() {
    findHoles();
    addHoles();
    for (std::size_t e = 0; e < model_.experts.size() && !stop_.stop_requested(); ++e) {
      const auto rules = resolveRules(model_, model_.experts[e]);
      addConflicts(model_.experts[e], rules);
      addRedundantRules(model_.experts[e], rules);
      addUnreachableRules(model_.experts[e], rules);
      addTerms(model_.experts[e], rules);
    }
    for (std::size_t i = 0; i < model_.inputs.size() && !stop_.stop_requested(); ++i) addDirections(i);
    out_.newtons_complete = probe_.affords();
    if (stop_.stop_requested()) return std::move(out_);
    out_.reachable = reachableRange(model_, probe_.compiled(), stop_);
    out_.bounds = forceBounds(model_, always_fires_);
    return std::move(out_);
  }

 private:
  /// Appends a finding; `says` is its sentence from the place in words.
  template <class Says>
  Finding& add(Kind kind, const std::string& who, FindingPlace where, const Says& says,
               std::optional<double> newtons = std::nullopt, std::vector<std::size_t> rules = {}) {
    std::string place = describe(where, model_);
    std::string text = says(place);
    return out_.findings.emplace_back(
        Finding{kind, who, std::move(where), std::move(place), std::move(text), newtons, {}, {}, std::move(rules)});
  }
  /// A sentence that ends with the place.
  static auto before(std::string start) {
    return [start = std::move(start)](const std::string& place) { return start + place; };
  }
  /// A sentence that says everything itself.
  static auto whole(std::string sentence) {
    return [sentence = std::move(sentence)](const std::string& /*place*/) { return sentence; };
  }

  template <class Change>
  static void setPoints(Finding& finding, const std::optional<Change>& change) {
    if (!change) return;
    finding.newtons = change->newtons;
    std::tie(finding.from, finding.to) = pointsOf(*change);
  }
  static auto pointsOf(const BoundaryJump& jump) { return std::pair{jump.outside, jump.inside}; }
  static auto pointsOf(const ForceChange& change) { return std::pair{change.from, change.to}; }

  void findHoles() {
    std::vector<std::size_t> weighty;
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      if (model_.experts[e].weight > 0) weighty.push_back(e);
    }
    const auto look = [&](std::span<const std::size_t> experts, std::size_t allowance) {
      Coverage found = coverage(model_, experts, allowance);
      out_.coverage_complete = out_.coverage_complete && found.complete;
      hole_count_ += found.holes.size();
      return found;
    };
    common_ = look(weighty, kCoverageAllowance).holes;
    for (std::size_t e = 0; e < model_.experts.size() && !stop_.stop_requested(); ++e) {
      Coverage found = look(std::span(&e, 1), std::max(kSmallestSearch, kCoverageAllowance / model_.experts.size()));
      always_fires_[e] = found.complete && found.holes.empty() && !hasGaussianInputs(model_.experts[e]);
      own_.push_back(std::move(found.holes));
    }
  }

  /// Far from its mean a Gaussian is 0 in double precision, so what it alone covers is not sure to fire.
  bool hasGaussianInputs(const Expert& expert) const {
    return std::any_of(model_.inputs.begin(), model_.inputs.end(), [&](const Variable& input) {
      const auto& terms = termsFor(expert, input);
      return std::any_of(terms.begin(), terms.end(), [](const auto& t) { return t.shape == fuzzy::Shape::kGaussian; });
    });
  }

  /// Settings that each of `places` may look at, each for the cost of a few averaged forces.
  std::size_t settings(std::size_t places) const {
    const std::size_t share = kAllowance / (1 + 16 * places * probe_.costOfMean());
    return std::clamp<std::size_t>(share, 1, kMostSettings);
  }

  void addHoles() {
    const std::size_t samples = settings(hole_count_);
    for (const auto& hole : common_) {
      setPoints(add(Kind::kHole, "", hole, before("every expert abstains: ")),
                jumpToDefault(probe_, hole, std::nullopt, samples));
    }
    for (std::size_t e = 0; e < own_.size(); ++e) {
      const auto& who = model_.experts[e];
      for (const auto& hole : own_[e]) {
        setPoints(add(Kind::kHole, who.id, hole, before("no rule fires: ")), jumpToDefault(probe_, hole, e, samples));
        if (who.weight == 0) continue;
        const auto jump = jumpOfMean(probe_, hole, e, samples);
        if (!jump || jump->newtons <= kNoJump * (model_.output.max - model_.output.min)) continue;
        setPoints(
            add(Kind::kAbstentionJump, who.id, hole, before("the mean jumps where this expert starts to abstain: ")),
            jump);
      }
    }
  }

  const fuzzy::Term& consequent(const Expert& expert, std::size_t rule) const {
    return *findTerm(termsFor(expert, model_.output), expert.rules[rule].then);
  }

  void addConflicts(const Expert& expert, const std::vector<ResolvedRule>& rules) {
    const auto force_alone = [&](std::size_t rule) -> std::optional<double> {
      const auto it = std::lower_bound(rules.begin(), rules.end(), rule,
                                       [](const ResolvedRule& r, std::size_t index) { return r.index < index; });
      const double strength = largestStrength(model_, expert, *it);
      if (strength == 0) return std::nullopt;
      return forceOfTerm(model_, consequent(expert, rule), strength);
    };
    for (const auto& [rule, other] : conflicts(rules)) {
      const auto one = force_alone(other);
      const auto two = force_alone(rule);
      const auto& said = expert.rules;
      add(Kind::kConflict, expert.id, ConditionPlace{said[rule].conditions},
          [&said, rule = rule, other = other](const std::string& key) {
            return "two rules for " + key + ": " + said[other].then + " and " + said[rule].then;
          },
          one && two ? std::optional(std::abs(*one - *two)) : std::nullopt, {other, rule});
    }
  }

  void addRedundantRules(const Expert& expert, const std::vector<ResolvedRule>& rules) {
    for (const auto& [rule, other] : redundantRules(rules, model_.inputs.size())) {
      const auto& said = expert.rules;
      add(Kind::kRedundantRule, expert.id, ConditionPlace{said[rule].conditions},
          [&said, rule = rule, other = other](const std::string& key) {
            return "the rule for " + key + " can be removed: " + describe(said[other].conditions) + " already gives " +
                   said[rule].then;
          },
          0.0, {rule});
    }
  }

  void addUnreachableRules(const Expert& expert, const std::vector<ResolvedRule>& rules) {
    for (const auto& rule : rules) {
      if (largestStrength(model_, expert, rule) > 0) continue;
      add(Kind::kUnreachableRule, expert.id, ConditionPlace{expert.rules[rule.index].conditions},
          before("no input inside the universes makes it fire: "), std::nullopt, {rule.index});
    }
  }

  void addTerms(const Expert& expert, const std::vector<ResolvedRule>& rules) {
    std::set<std::pair<std::string, std::string>> used;
    for (const auto& rule : expert.rules) {
      if (!rule.enabled) continue;
      for (const auto& condition : rule.conditions) used.emplace(condition.input, condition.term);
    }
    for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
      const Variable& input = model_.inputs[i];
      for (const auto& term : termsFor(expert, input)) {
        const TermPlace where{i, term.id};
        if (!used.contains({input.id, term.id})) {
          add(Kind::kUnusedTerm, expert.id, where, whole("no rule mentions " + input.id + " is " + term.id));
        }
        if (fuzzy::MembershipFunction::of(term)(peakPosition(term, input.min, input.max)) > 0) continue;
        add(Kind::kUnreachableTerm, expert.id, where, before("the term lies outside the universe: "));
      }
    }
    const auto strengths = largestStrengths(model_, expert, rules);
    const auto& terms = termsFor(expert, model_.output);
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (strengths[t] > 0) continue;
      add(Kind::kUnreachableTerm, expert.id, TermPlace{model_.inputs.size(), terms[t].id},
          whole("no rule that can fire concludes " + model_.output.id + " is " + terms[t].id));
    }
  }

  /// In ascending order, each once.
  static std::vector<std::size_t> rulesOf(const std::vector<NeighborStep>& steps) {
    std::set<std::size_t> rules;
    for (const auto& step : steps) rules.insert({step.before, step.after});
    return {rules.begin(), rules.end()};
  }

  void addDirections(std::size_t input_index) {
    const Variable& input = model_.inputs[input_index];
    int votes = 0;
    std::size_t steps = 0;
    std::vector<ExpertDirection> directions;
    for (const auto& expert : model_.experts) {
      directions.push_back(direction(model_, expert, input_index));
      votes += static_cast<int>(directions.back().prevailing);
      steps += directions.back().steps_against.size();
    }
    const bool disagree = std::any_of(directions.begin(), directions.end(),
                                      [&](const auto& d) { return static_cast<int>(d.prevailing) * votes < 0; });
    std::vector<std::optional<ForceChange>> differences(model_.experts.size());
    if (disagree) differences = differencesAlong(probe_, input_index, settings(model_.inputs.size()));
    for (std::size_t e = 0; e < directions.size(); ++e) {
      const auto& [prevailing, steps_with, steps_against] = directions[e];
      const std::string& who = model_.experts[e].id;
      for (const auto& step : steps_against) {
        setPoints(add(Kind::kDirectionChange, who, StepPlace{e, step},
                      before("against the direction of most steps over " + input.id + ": "), std::nullopt,
                      {step.before, step.after}),
                  changeAlong(probe_, e, step, settings(steps)));
      }
      const bool falls = prevailing == Direction::kFalls;
      if (static_cast<int>(prevailing) * votes < 0) {
        setPoints(add(Kind::kDisagreement, who, InputPlace{input_index},
                      whole(std::string("the force ") + (falls ? "falls" : "rises") + " with " + input.id +
                            ", for most experts it " + (falls ? "rises" : "falls")),
                      std::nullopt, rulesOf(steps_with)),
                  differences[e]);
      }
    }
  }

  const ForceModel& model_;
  std::stop_token stop_;
  ForceProbe probe_;
  Lint out_;
  std::vector<Hole> common_;            ///< where every expert abstains
  std::vector<std::vector<Hole>> own_;  ///< one list per expert
  std::vector<bool> always_fires_;
  std::size_t hole_count_ = 0;
};

}  // namespace

std::string_view name(Kind kind) noexcept {
  switch (kind) {
    case Kind::kHole: return "hole";
    case Kind::kAbstentionJump: return "abstention_jump";
    case Kind::kForceStep: return "force_step";
    case Kind::kRegionWithoutRule: return "region_without_rule";
    case Kind::kMissingItem: return "missing_item";
    case Kind::kConflict: return "conflict";
    case Kind::kExpertsApart: return "experts_apart";
    case Kind::kAgainstDeclaration: return "against_declaration";
    case Kind::kLevelJump: return "level_jump";
    case Kind::kDirectionChange: return "direction_change";
    case Kind::kDisagreement: return "disagreement";
    case Kind::kRedundantRule: return "redundant_rule";
    case Kind::kUnreachableRule: return "unreachable_rule";
    case Kind::kUnreachableTerm: return "unreachable_term";
    case Kind::kUnusedTerm: return "unused_term";
  }
  return "";
}

Lint lint(const ForceModel& model, const fuzzy::CompiledModel& compiled, const std::stop_token& stop) {
  return Linter(model, compiled, stop).run();
}

}  // namespace tactus::analysis
