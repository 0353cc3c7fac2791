#include "core/analysis/check_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "core/analysis/coverage.h"
#include "core/analysis/sample_points.h"
#include "core/base/check.h"
#include "core/base/random.h"
#include "core/fuzzy/centroid.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/model_checks.h"

namespace tactus::analysis {
namespace {

fuzzy::CompiledModel compiled(const fuzzy::ForceModel& model) {
  auto made = fuzzy::compile(model);
  TACTUS_CHECK(made);
  return std::move(*made);
}

/// The model that such a reader believes to have read.
WrongReader reading(std::string_view mistake, const fuzzy::ForceModel& model) {
  return {mistake, [wrong = compiled(model)](std::span<const double> point) { return wrong.evaluate(point); }};
}

template <class Change>
fuzzy::ForceModel changed(fuzzy::ForceModel model, Change&& change) {
  for (fuzzy::Expert& expert : model.experts) {
    for (fuzzy::Rule& rule : expert.rules) change(rule);
  }
  return model;
}

/// Terms outside their universe are read as they are, because nothing is clamped.
fuzzy::ForceModel unclamped(fuzzy::ForceModel model) {
  for (fuzzy::Variable& input : model.inputs) {
    const double width = input.max - input.min;
    input.min = std::max(input.min - width, -fuzzy::kLargest);
    input.max = std::min(input.max + width, fuzzy::kLargest);
  }
  return model;
}

fuzzy::ForceModel equallyWeighted(fuzzy::ForceModel model) {
  for (fuzzy::Expert& expert : model.experts) expert.weight = 1;
  return model;
}

fuzzy::Evaluation countingAbstentions(const fuzzy::CompiledModel& model, std::span<const double> point) {
  double sum = 0;
  double weights = 0;
  bool fired = false;
  for (std::size_t e = 0; e < model.expertCount(); ++e) {
    const fuzzy::Evaluation one = model.evaluateExpert(e, point);
    sum += model.normalizedWeight(e) * one.force_n;
    weights += model.normalizedWeight(e);
    fired = fired || one.fired;
  }
  return {sum / weights, fired};
}

/// The product of the memberships in place of the least one.
class ProductReader {
 public:
  explicit ProductReader(const fuzzy::ForceModel& model) : model_(model), weights_(normalizedWeights(model)) {
    for (const fuzzy::Expert& expert : model.experts) experts_.push_back(readOf(expert));
  }

  fuzzy::Evaluation operator()(std::span<const double> point) const {
    double sum = 0;
    double weights = 0;
    for (std::size_t e = 0; e < experts_.size(); ++e) {
      const auto offset = weights_[e] > 0 ? offsetOf(experts_[e], point) : std::nullopt;
      if (!offset) continue;
      sum += weights_[e] * *offset;
      weights += weights_[e];
    }
    if (weights == 0) return {model_.default_force_n, false};
    return {model_.output.min + sum / weights, true};
  }

 private:
  struct Rule {
    std::size_t then = 0;
    double weight = 1;
    std::vector<std::pair<std::size_t, fuzzy::MembershipFunction>> conditions;  ///< with the place of the input
  };
  struct Expert {
    std::vector<fuzzy::MembershipFunction> words;
    std::vector<Rule> rules;
  };

  Expert readOf(const fuzzy::Expert& expert) const {
    const auto& terms = termsFor(expert, model_.output);
    Expert out;
    for (const fuzzy::Term& term : terms) out.words.push_back(fuzzy::MembershipFunction::of(term));
    for (const fuzzy::Rule& rule : expert.rules) {
      if (!fuzzy::takesPart(rule)) continue;
      Rule& read = out.rules.emplace_back();
      read.then = static_cast<std::size_t>(findTerm(terms, rule.then) - terms.data());
      read.weight = rule.weight;
      for (const fuzzy::Condition& condition : rule.conditions) {
        const auto input = std::find_if(model_.inputs.begin(), model_.inputs.end(),
                                        [&](const auto& one) { return one.id == condition.input; });
        const auto& term = *findTerm(termsFor(expert, *input), condition.term);
        read.conditions.emplace_back(input - model_.inputs.begin(), fuzzy::MembershipFunction::of(term));
      }
    }
    return out;
  }

  double strengthOf(const Rule& rule, std::span<const double> point) const {
    double strength = rule.weight;
    for (const auto& [i, membership] : rule.conditions) {
      strength *= membership(std::clamp(point[i], model_.inputs[i].min, model_.inputs[i].max));
      if (strength == 0) break;
    }
    return strength;
  }

  std::optional<double> offsetOf(const Expert& expert, std::span<const double> point) const {
    std::vector<double> strengths(expert.words.size(), 0);
    for (const Rule& rule : expert.rules)
      strengths[rule.then] = std::max(strengths[rule.then], strengthOf(rule, point));
    const double largest = *std::max_element(strengths.begin(), strengths.end());
    if (largest <= 0) return std::nullopt;
    std::vector<fuzzy::ActiveTerm> active;
    for (std::size_t t = 0; t < strengths.size(); ++t) {
      if (strengths[t] > 0) active.push_back({&expert.words[t], strengths[t], strengths[t] / largest});
    }
    return centroidOffset(active, model_.implication, model_.output.min, model_.output.max);
  }

  const fuzzy::ForceModel& model_;
  std::vector<double> weights_;
  std::vector<Expert> experts_;
};

/// Where only experts of weight 0 have a rule, their force stands for a mean that there is not.
fuzzy::Evaluation letWeightlessFire(const fuzzy::CompiledModel& model, std::span<const double> point) {
  const auto right = model.evaluate(point);
  for (std::size_t e = 0; !right.fired && e < model.expertCount(); ++e) {
    const auto one = model.weight(e) == 0 ? model.evaluateExpert(e, point) : right;
    if (one.fired) return one;
  }
  return right;
}

}  // namespace

std::vector<WrongReader> wrongReaders(const fuzzy::ForceModel& model) {
  std::vector<WrongReader> readers;
  const auto some = [&model](auto&& holds) {
    return std::any_of(model.experts.begin(), model.experts.end(), [&](const fuzzy::Expert& expert) {
      return std::any_of(expert.rules.begin(), expert.rules.end(), holds);
    });
  };
  if (some([](const fuzzy::Rule& rule) { return rule.weight != 1; })) {
    readers.push_back(reading("rule weights taken as 1", changed(model, [](fuzzy::Rule& rule) { rule.weight = 1; })));
  }
  if (some([](const fuzzy::Rule& rule) { return !rule.enabled; })) {
    readers.push_back(reading("disabled rules read", changed(model, [](fuzzy::Rule& rule) { rule.enabled = true; })));
  }
  readers.push_back(reading("inputs not clamped", unclamped(model)));
  if (some([](const fuzzy::Rule& rule) { return rule.conditions.size() > 1; })) {
    readers.push_back({"memberships multiplied", ProductReader(model)});
  }
  if (std::any_of(model.experts.begin(), model.experts.end(), [](const auto& one) { return one.weight == 0; })) {
    readers.push_back({"experts of weight 0 fire", [all = compiled(model)](std::span<const double> point) {
                         return letWeightlessFire(all, point);
                       }});
  }
  if (model.experts.size() > 1) {
    readers.push_back({"abstentions counted", [all = compiled(model)](std::span<const double> point) {
                         return countingAbstentions(all, point);
                       }});
    readers.push_back(reading("experts weighted equally", equallyWeighted(model)));
  }
  if (model.default_force_n != 0) {
    fuzzy::ForceModel zero = model;
    zero.default_force_n = 0;
    readers.push_back(reading("default force taken as 0", zero));
  }
  return readers;
}

namespace {

using Point = std::vector<double>;
using Points = std::vector<Point>;

constexpr std::size_t kMostKinks = 900;
constexpr std::size_t kRandom = 1200;
constexpr std::size_t kMostHoles = 40;
constexpr std::size_t kMostRules = 600;
constexpr std::size_t kPerMistake = 3;

double within(double x, const fuzzy::Variable& variable) { return std::clamp(x, variable.min, variable.max); }

/// A value at which the term is 1, or as near to it as the universe lets.
double coreOf(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  const auto& p = term.points;
  if (term.shape == fuzzy::Shape::kTrapezoid)
    return within((within(p[1], variable) + within(p[2], variable)) / 2, variable);
  return within(term.shape == fuzzy::Shape::kTriangle ? p[1] : p[0], variable);
}

Point middleOf(const fuzzy::ForceModel& model) {
  Point point;
  for (const fuzzy::Variable& input : model.inputs) point.push_back((input.min + input.max) / 2);
  return point;
}

/// One for each rule, the disabled ones included: all of its conditions hold fully.
void addRules(const fuzzy::ForceModel& model, Points& points) {
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : model.experts) rules += expert.rules.size();
  const std::size_t stride = std::max<std::size_t>(1, rules / kMostRules);
  std::size_t number = 0;
  for (const fuzzy::Expert& expert : model.experts) {
    for (const fuzzy::Rule& rule : expert.rules) {
      if (number++ % stride != 0) continue;
      Point point = middleOf(model);
      for (std::size_t i = 0; i < model.inputs.size(); ++i) {
        for (const fuzzy::Condition& condition : rule.conditions) {
          if (condition.input != model.inputs[i].id) continue;
          const auto& terms = fuzzy::termsFor(expert, model.inputs[i]);
          point[i] = coreOf(*fuzzy::findTerm(terms, condition.term), model.inputs[i]);
        }
      }
      points.push_back(std::move(point));
    }
  }
}

/// Beyond each end of each universe, near and far, from some places inside.
void addOutside(const fuzzy::ForceModel& model, const Points& from, Points& points) {
  const std::size_t stride = std::max<std::size_t>(1, from.size() / 4);
  for (std::size_t start = 0; start < from.size(); start += stride) {
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const fuzzy::Variable& input = model.inputs[i];
      for (const double share : {-0.5, -0.02, 1.02, 1.5}) {
        Point point = from[start];
        point[i] = input.min + share * (input.max - input.min);
        points.push_back(std::move(point));
      }
    }
  }
}

/// The middle of each hole of the mean and of each expert, and both ends of each of its ranges.
void addHoles(const fuzzy::ForceModel& model, Points& points) {
  std::vector<std::size_t> every(model.experts.size());
  std::iota(every.begin(), every.end(), std::size_t{0});
  std::vector<std::vector<std::size_t>> groups = {every};
  std::vector<std::size_t> weighty;  // elsewhere the mean fires
  for (const std::size_t one : every) {
    if (model.experts[one].weight > 0) weighty.push_back(one);
  }
  if (weighty.size() < every.size()) groups.push_back(std::move(weighty));
  if (every.size() > 1) {
    for (const std::size_t one : every) groups.push_back({one});
  }
  for (const auto& group : groups) {
    const Coverage found = coverage(model, group);
    for (std::size_t h = 0; h < std::min(found.holes.size(), kMostHoles); ++h) {
      Point middle;
      for (const InputRange& range : found.holes[h].ranges) middle.push_back((range.low + range.high) / 2);
      points.push_back(middle);
      for (std::size_t i = 0; i < middle.size(); ++i) {
        if (found.holes[h].ranges[i].whole_universe) continue;
        for (const double end : {found.holes[h].ranges[i].low, found.holes[h].ranges[i].high}) {
          Point edge = middle;
          edge[i] = end;
          points.push_back(std::move(edge));
        }
      }
    }
  }
}

void addKinks(const fuzzy::ForceModel& model, Points& points) {
  const auto kinks = kinkPoints(model, kMostKinks);
  for (std::size_t i = 0; i < kinks.size(); ++i) points.push_back(kinks[i]);
}

void addRandom(const fuzzy::ForceModel& model, std::size_t count, Points& points) {
  base::Random random(1);
  for (std::size_t p = 0; p < count; ++p) {
    Point point;
    for (const fuzzy::Variable& input : model.inputs) point.push_back(random.uniform(input.min, input.max));
    points.push_back(std::move(point));
  }
}

/// The points among `candidates` at which each wrong reader is furthest off.
Points pointsOfMistakes(const fuzzy::ForceModel& model, const Points& candidates) {
  const auto compiled = fuzzy::compile(model);
  TACTUS_CHECK(compiled);
  Points out;
  for (const WrongReader& reader : wrongReaders(model)) {
    std::vector<std::pair<double, std::size_t>> off;
    for (std::size_t p = 0; p < candidates.size(); ++p) {
      const auto right = compiled->evaluate(candidates[p]);
      const auto wrong = reader.force(candidates[p]);
      const double difference = std::abs(right.force_n - wrong.force_n);
      if (difference > 0 || right.fired != wrong.fired) off.emplace_back(difference, p);
    }
    const auto end = off.begin() + static_cast<std::ptrdiff_t>(std::min(off.size(), kPerMistake));
    std::partial_sort(off.begin(), end, off.end(), std::greater<>());
    for (auto at = off.begin(); at != end; ++at) out.push_back(candidates[at->second]);
  }
  return out;
}

Points withoutTwins(Points points) {
  std::set<Point> seen;
  Points out;
  for (Point& point : points) {
    if (seen.insert(point).second) out.push_back(std::move(point));
  }
  return out;
}

/// Rules, holes and universes.
Points structured(const fuzzy::ForceModel& model) {
  Points points;
  addRules(model, points);
  Points starts = points;
  starts.push_back(middleOf(model));
  addOutside(model, starts, points);
  addHoles(model, points);
  return points;
}

}  // namespace

std::vector<std::vector<double>> checkPoints(const fuzzy::ForceModel& model) {
  Points points = structured(model);
  addKinks(model, points);
  addRandom(model, kRandom, points);
  points = withoutTwins(std::move(points));
  if (points.size() < kLeastChecks) addRandom(model, 2 * kLeastChecks, points);
  return withoutTwins(std::move(points));
}

std::vector<fuzzy::Check> checksAt(const fuzzy::ForceModel& model, const std::vector<std::vector<double>>& points) {
  const auto compiled = fuzzy::compile(model);
  TACTUS_CHECK(compiled);
  std::vector<fuzzy::Check> checks;
  for (const Point& point : points) {
    const auto force = compiled->evaluate(point);
    checks.push_back({point, force.force_n, force.fired});
  }
  return checks;
}

std::vector<fuzzy::Check> ownChecks(const fuzzy::ForceModel& model, std::size_t most) {
  Points points = pointsOfMistakes(model, checkPoints(model));
  const std::size_t kept = points.size();
  Points others = structured(model);
  // Evenly, where there are more than fit.
  const std::size_t room = most > kept ? most - kept : 0;
  const std::size_t stride = room > 0 ? std::max<std::size_t>(1, (others.size() + room - 1) / room) : others.size();
  for (std::size_t p = 0; p < others.size() && points.size() < most; p += stride) points.push_back(others[p]);
  return checksAt(model, withoutTwins(std::move(points)));
}

}  // namespace tactus::analysis
