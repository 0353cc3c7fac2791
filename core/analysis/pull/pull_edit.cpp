#include "core/analysis/pull/pull_edit.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/analysis/pull/ramps.h"
#include "core/base/check.h"

namespace tactus::analysis {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Term;

std::vector<Term>& changeableTerms(ForceModel& model, const PulledList& list) {
  fuzzy::Variable& variable = list.variable < model.inputs.size() ? model.inputs[list.variable] : model.output;
  if (list.owner.empty()) return variable.terms;
  for (auto& own : model.experts[expertIndex(model, list.owner)].overrides) {
    if (own.variable == variable.id) return own.terms;
  }
  TACTUS_CHECK(false);
  return variable.terms;
}

}  // namespace

std::string_view name(Gesture gesture) noexcept {
  constexpr std::array<std::string_view, 10> kNames = {"p",     "q",      "shift", "width", "move",
                                                       "widen", "vertex", "word",  "off",   "weight"};
  return kNames[static_cast<std::size_t>(gesture)];
}

std::size_t expertIndex(const ForceModel& model, std::string_view id) {
  const auto it = std::find_if(model.experts.begin(), model.experts.end(), [&](const Expert& e) { return e.id == id; });
  TACTUS_CHECK(it != model.experts.end());
  return static_cast<std::size_t>(it - model.experts.begin());
}

const std::vector<Term>& termsOf(const ForceModel& model, const PulledList& list) {
  const fuzzy::Variable& variable = variableAt(model, list.variable);
  return list.owner.empty() ? variable.terms : termsFor(model.experts[expertIndex(model, list.owner)], variable);
}

std::vector<std::size_t> readersOf(const ForceModel& model, const PulledList& list) {
  if (!list.owner.empty()) return {expertIndex(model, list.owner)};
  std::vector<std::size_t> readers;
  const fuzzy::Variable& variable = variableAt(model, list.variable);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (&termsFor(model.experts[e], variable) == &variable.terms) readers.push_back(e);
  }
  return readers;
}

PullEdit ruleEdit(Gesture gesture, const std::string& expert, std::size_t rule, double delta, const std::string& then) {
  PullEdit edit;
  edit.gesture = gesture;
  edit.expert = expert;
  edit.rule = rule;
  edit.delta = delta;
  edit.then = then;
  return edit;
}

PullEdit termEdit(Gesture gesture, const PulledList& list, std::size_t place, std::size_t vertex) {
  PullEdit edit;
  edit.gesture = gesture;
  edit.list = list;
  edit.place = place;
  edit.vertex = vertex;
  return edit;
}

ForceModel applied(ForceModel model, const PullEdit& edit) {
  if (editsRule(edit.gesture)) {
    fuzzy::Rule& rule = model.experts[expertIndex(model, edit.expert)].rules[edit.rule];
    if (edit.gesture == Gesture::kWord) rule.then = edit.then;
    if (edit.gesture == Gesture::kOff) rule.enabled = false;
    if (edit.gesture == Gesture::kWeight) rule.weight = std::clamp(rule.weight + edit.delta, 0.0, 1.0);
    return model;
  }
  std::vector<Term>& terms = changeableTerms(model, edit.list);
  if (edit.gesture == Gesture::kVertex) {
    terms[edit.place].points[edit.vertex] += edit.delta;
    return model;
  }
  const auto before = rampsOf(variableAt(model, edit.list.variable), terms);
  TACTUS_CHECK(before);
  writeRamps(*before, moved(*before, edit.gesture, edit.place, edit.delta), terms);
  return model;
}

}  // namespace tactus::analysis
