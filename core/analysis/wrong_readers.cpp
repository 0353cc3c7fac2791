#include "core/analysis/wrong_readers.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"

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
    input.min -= width;
    input.max += width;
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
    sum += model.weight(e) * one.force_n;
    weights += model.weight(e);
    fired = fired || one.fired;
  }
  return {sum / weights, fired};
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
