#include "core/analysis/wrong_readers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/fuzzy/centroid.h"
#include "core/fuzzy/model_checks.h"
#include "core/fuzzy/takes_part.h"

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
    for (const fuzzy::Expert& expert : model.experts) {
      Words& words = words_.emplace_back();
      for (const fuzzy::Term& term : termsFor(expert, model.output))
        words.push_back(fuzzy::MembershipFunction::of(term));
    }
  }

  fuzzy::Evaluation operator()(std::span<const double> point) const {
    double sum = 0;
    double weights = 0;
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      const auto offset = weights_[e] > 0 ? offsetOf(e, point) : std::nullopt;
      if (!offset) continue;
      sum += weights_[e] * *offset;
      weights += weights_[e];
    }
    if (weights == 0) return {model_.default_force_n, false};
    return {model_.output.min + sum / weights, true};
  }

 private:
  using Words = std::vector<fuzzy::MembershipFunction>;

  double strengthOf(const fuzzy::Expert& expert, const fuzzy::Rule& rule, std::span<const double> point) const {
    double strength = rule.weight;
    for (const fuzzy::Condition& condition : rule.conditions) {
      for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
        const fuzzy::Variable& input = model_.inputs[i];
        if (input.id != condition.input) continue;
        const auto& term = *findTerm(termsFor(expert, input), condition.term);
        strength *= fuzzy::MembershipFunction::of(term)(std::clamp(point[i], input.min, input.max));
      }
    }
    return strength;
  }

  std::optional<double> offsetOf(std::size_t e, std::span<const double> point) const {
    const fuzzy::Expert& expert = model_.experts[e];
    const auto& terms = termsFor(expert, model_.output);
    std::vector<double> strengths(terms.size(), 0);
    for (const fuzzy::Rule& rule : expert.rules) {
      if (!fuzzy::takesPart(rule)) continue;
      double& strength = strengths[static_cast<std::size_t>(findTerm(terms, rule.then) - terms.data())];
      strength = std::max(strength, strengthOf(expert, rule, point));
    }
    const double largest = *std::max_element(strengths.begin(), strengths.end());
    if (largest <= 0) return std::nullopt;
    std::vector<fuzzy::ActiveTerm> active;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (strengths[t] > 0) active.push_back({&words_[e][t], strengths[t], strengths[t] / largest});
    }
    return centroidOffset(active, model_.implication, model_.output.min, model_.output.max);
  }

  const fuzzy::ForceModel& model_;
  std::vector<double> weights_;
  std::vector<Words> words_;
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

}  // namespace tactus::analysis
