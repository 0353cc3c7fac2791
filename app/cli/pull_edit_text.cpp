#include "app/cli/pull_edit_text.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/cli/model_words.h"
#include "app/cli/wrapped_text.h"
#include "core/analysis/pull/pull_edit.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

using analysis::Gesture;
using analysis::PullCandidate;
using analysis::PullEdit;
using base::formatFixed;

const std::string& idAt(const fuzzy::ForceModel& model, const PullEdit& edit, std::size_t place) {
  const auto& terms = analysis::termsOf(model, edit.list);
  if (edit.gesture == Gesture::kVertex) return terms[place].id;
  return terms[analysis::partitionOrder(analysis::variableAt(model, edit.list.variable), terms)->at(place)].id;
}

bool ofTerm(Gesture gesture) {
  return gesture == Gesture::kMove || gesture == Gesture::kWiden || gesture == Gesture::kVertex;
}

/// `laryngopharynx/esophagus` for a ramp, `laryngopharynx` for a term.
std::string gapOf(const fuzzy::ForceModel& model, const PullEdit& edit) {
  const std::string& first = idAt(model, edit, edit.place);
  return ofTerm(edit.gesture) ? first : first + "/" + idAt(model, edit, edit.place + 1);
}

std::string ruleText(const fuzzy::ForceModel& model, const PullEdit& edit) {
  const std::size_t expert = analysis::expertIndex(model, edit.expert);
  const fuzzy::Rule& rule = model.experts[expert].rules[edit.rule];
  const auto& words = termsFor(model.experts[expert], model.output);
  const auto word = [&](const std::string& id) { return labelOf(findTerm(words, id), id); };
  const std::string title = base::oneLine(edit.expert) + ", rule " + std::to_string(edit.rule + 1) + " (" +
                            conditionsOf(model, expert, edit.rule) + "): ";
  if (edit.gesture == Gesture::kWord) return title + word(edit.then) + " instead of " + word(rule.then);
  if (edit.gesture == Gesture::kOff) return title + "off";
  return title + "weight " + formatFixed(rule.weight + edit.delta, 3) + " instead of " + formatFixed(rule.weight, 3);
}

std::string rampText(const fuzzy::Variable& variable, const analysis::Ramps& before, const PullEdit& edit) {
  const analysis::Ramps after = moved(before, edit.gesture, edit.place, edit.delta);
  const std::size_t r = edit.place;
  const auto number = [](double x) { return formatFixed(x, 3); };
  if (edit.gesture == Gesture::kBegin)
    return "the transition begins at " + number(after.p[r]) + " instead of " + withUnit(before.p[r], variable);
  if (edit.gesture == Gesture::kEnd)
    return "the transition ends at " + number(after.q[r]) + " instead of " + withUnit(before.q[r], variable);
  return "the transition runs from " + number(after.p[r]) + " to " + number(after.q[r]) + " instead of " +
         number(before.p[r]) + " to " + withUnit(before.q[r], variable);
}

std::string lowerOrHigher(double delta) { return delta < 0 ? " lower" : " higher"; }

void writeEdit(base::JsonWriter& json, const fuzzy::ForceModel& model, const PullEdit& edit) {
  const auto text = [&](bool there, const std::string& value) { there ? json.value(value) : json.null(); };
  const bool rule = analysis::editsRule(edit.gesture);
  json.key("gesture").value(name(edit.gesture)).key("variable");
  text(!rule, rule ? "" : analysis::variableAt(model, edit.list.variable).id);
  json.key("gap");
  text(!rule, rule ? "" : gapOf(model, edit));
  json.key("rule");
  rule ? json.value(edit.rule + 1) : json.null();
  json.key("then");
  text(!edit.then.empty(), edit.then);
  json.key("delta").value(edit.delta);
}

/// The experts whose rules get another word or are taken away, each once.
std::vector<std::string> contradicted(const PullCandidate& candidate) {
  std::vector<std::string> out;
  for (const PullEdit& edit : candidate.edits) {
    const bool is_answer = edit.gesture == Gesture::kWord || edit.gesture == Gesture::kOff;
    if (is_answer && std::find(out.begin(), out.end(), edit.expert) == out.end()) out.push_back(edit.expert);
  }
  return out;
}

}  // namespace

std::string editText(const fuzzy::ForceModel& model, const PullEdit& edit) {
  if (analysis::editsRule(edit.gesture)) return ruleText(model, edit);
  const fuzzy::Variable& variable = analysis::variableAt(model, edit.list.variable);
  const auto& terms = analysis::termsOf(model, edit.list);
  const auto label = [&](std::size_t place) {
    const std::string& id = idAt(model, edit, place);
    return labelOf(findTerm(terms, id), id);
  };
  std::string title =
      variableLabel(variable) + (edit.list.owner.empty() ? "" : " of " + base::oneLine(edit.list.owner));
  title += ", " + label(edit.place) + (ofTerm(edit.gesture) ? "" : "/" + label(edit.place + 1)) + ": ";
  const std::string size = withUnit(std::abs(edit.delta), variable);
  if (edit.gesture == Gesture::kMove) return title + "the whole term " + size + lowerOrHigher(edit.delta);
  if (edit.gesture == Gesture::kWiden)
    return title + size + (edit.delta < 0 ? " narrower" : " wider") + " on each side";
  if (edit.gesture == Gesture::kVertex) {
    const double now = terms[edit.place].points[edit.vertex];
    return title + "vertex " + std::to_string(edit.vertex + 1) + " at " + formatFixed(now + edit.delta, 3) +
           " instead of " + withUnit(now, variable);
  }
  return title + rampText(variable, *analysis::rampsOf(variable, terms), edit);
}

std::string editsText(const fuzzy::ForceModel& model, std::span<const PullEdit> edits) {
  std::vector<std::string> parts;
  fuzzy::ForceModel before = model;
  for (const PullEdit& edit : edits) {
    parts.push_back(editText(before, edit));
    before = applied(std::move(before), edit);
  }
  return base::joined(parts, "; and ");
}

std::string elsewhereText(const PullCandidate& candidate) {
  return "elsewhere it moves the force by " + formatFixed(candidate.elsewhere.k, 3) +
         " just-noticeable differences, at most " + formatFixed(candidate.elsewhere.largest_n, 3) + " N" +
         (candidate.folded ? "; not plausible" : "");
}

std::string contradictionText(const PullCandidate& candidate) {
  const auto experts = contradicted(candidate);
  return experts.empty() ? "" : "; contradicts " + base::oneLine(base::joined(experts, "'s and ")) + "'s answer";
}

std::string findingsText(const std::vector<std::string>& findings) {
  std::string text;
  for (const std::string& finding : findings) text += wrapped("new finding: " + finding, "    ", 4);
  return text;
}

void writeMembers(base::JsonWriter& json, const fuzzy::ForceModel& model, const PullCandidate& candidate,
                  const std::vector<std::string>& findings) {
  json.key("kind").value(name(candidate.kind));
  writeEdit(json, model, candidate.edits[0]);
  if (candidate.edits.size() > 1) {
    json.key("more").beginArray();
    for (const PullEdit& edit : std::span(candidate.edits).subspan(1)) {
      json.beginObject();
      writeEdit(json, model, edit);
      json.endObject();
    }
    json.endArray();
  }
  const analysis::Elsewhere& elsewhere = candidate.elsewhere;
  json.key("force_n").value(candidate.force_n).key("k").value(elsewhere.k).key("k_curve").value(elsewhere.k_curve);
  json.key("k_box").value(elsewhere.k_box).key("largest_n").value(elsewhere.largest_n);
  json.key("folded").value(candidate.folded);
  json.key("contradicts").values(contradicted(candidate)).key("new_findings").values(findings);
}

}  // namespace tactus::cli
