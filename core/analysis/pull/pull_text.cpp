#include "core/analysis/pull/pull_text.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/analysis/pull/pull_edit.h"
#include "core/analysis/reasons.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::analysis {
namespace {

using base::formatFixed;

const std::string& idAt(const fuzzy::ForceModel& model, const PullEdit& edit, std::size_t place) {
  const auto& terms = termsOf(model, edit.list);
  if (edit.gesture == Gesture::kVertex) return terms[place].id;
  return terms[partitionOrder(variableAt(model, edit.list.variable), terms)->at(place)].id;
}

bool ofTerm(Gesture gesture) {
  return gesture == Gesture::kMove || gesture == Gesture::kWiden || gesture == Gesture::kVertex;
}

std::string ruleText(const fuzzy::ForceModel& model, const PullEdit& edit) {
  const std::size_t expert = expertIndex(model, edit.expert);
  const fuzzy::Rule& rule = model.experts[expert].rules[edit.rule];
  const auto& words = termsFor(model.experts[expert], model.output);
  const auto word = [&](const std::string& id) { return labelOf(findTerm(words, id), id); };
  const std::string title = base::oneLine(edit.expert) + ", rule " + std::to_string(edit.rule + 1) + " (" +
                            conditionsOf(model, expert, edit.rule) + "): ";
  if (edit.gesture == Gesture::kWord) return title + word(edit.then) + " instead of " + word(rule.then);
  if (edit.gesture == Gesture::kOff) return title + "off";
  return title + "weight " + formatFixed(rule.weight + edit.delta, 3) + " instead of " + formatFixed(rule.weight, 3);
}

std::string rampText(const fuzzy::Variable& variable, const Ramps& before, const PullEdit& edit) {
  const Ramps after = moved(before, edit.gesture, edit.place, edit.delta);
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

constexpr std::size_t kShown = 3;

}  // namespace

std::string gapOf(const fuzzy::ForceModel& model, const PullEdit& edit) {
  const std::string& first = idAt(model, edit, edit.place);
  return ofTerm(edit.gesture) ? first : first + "/" + idAt(model, edit, edit.place + 1);
}

std::vector<std::string> contradicted(const PullCandidate& candidate) {
  std::vector<std::string> out;
  for (const PullEdit& edit : candidate.edits) {
    const bool is_answer = edit.gesture == Gesture::kWord || edit.gesture == Gesture::kOff;
    if (is_answer && std::find(out.begin(), out.end(), edit.expert) == out.end()) out.push_back(edit.expert);
  }
  return out;
}

std::string editText(const fuzzy::ForceModel& model, const PullEdit& edit) {
  if (editsRule(edit.gesture)) return ruleText(model, edit);
  const fuzzy::Variable& variable = variableAt(model, edit.list.variable);
  const auto& terms = termsOf(model, edit.list);
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
  return title + rampText(variable, *rampsOf(variable, terms), edit);
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

std::string outcomeText(const fuzzy::ForceModel& model, const PullCandidate& candidate) {
  return editsText(model, candidate.edits) +
         (candidate.exact ? "" : "; comes only to " + formatFixed(candidate.force_n, 3) + " N");
}

std::string candidateText(const fuzzy::ForceModel& model, const PullCandidate& candidate) {
  return outcomeText(model, candidate) + contradictionText(candidate);
}

std::string outcomeText(const fuzzy::ForceModel& model, const CurveCandidate& candidate) {
  return editsText(model, candidate.candidate.edits) + "; leaves " + formatFixed(candidate.residual_n, 3) + " N" +
         (candidate.same_curve == 0
              ? ""
              : "; as much as " + std::to_string(candidate.same_curve) +
                    (candidate.same_curve == 1 ? " other edit" : " other edits") + " here, different elsewhere");
}

std::string candidateText(const fuzzy::ForceModel& model, const CurveCandidate& candidate) {
  return outcomeText(model, candidate) + contradictionText(candidate.candidate);
}

std::string blockerText(const CurvePull& pull) {
  if (pull.close) return {};
  if (pull.candidates.empty()) return "no edit of a term or rule gains a tenth of the distance";
  return "up to three edits still leave " + formatFixed(pull.candidates[0].residual_n, 3) + " N (root mean square)";
}

std::string blockerText(const fuzzy::ForceModel& model, const Pull& pull) {
  const PullBlocker& blocker = *pull.blocker;
  if (blocker.kind == PullBlocker::Kind::kLock && blocker.variable > model.inputs.size())
    return "the rules are locked, and without the lock one edit is enough";
  if (blocker.kind == PullBlocker::Kind::kPin) return "the pinned points stay, and without the pins one edit is enough";
  const fuzzy::Variable& variable = variableAt(model, blocker.variable);
  const std::string term = labelOf(findTerm(variable.terms, blocker.term), blocker.term);
  switch (blocker.kind) {
    case PullBlocker::Kind::kNoRule: return "no rule fires here";
    case PullBlocker::Kind::kLock:
      return variableLabel(variable) + " is locked, and without the lock one edit is enough";
    case PullBlocker::Kind::kCentroid:
      return "the centroid of " + term + ": no word alone goes " +
             (pull.target_n < blocker.limit_n ? "below " : "above ") + formatFixed(blocker.limit_n, 3) + " N";
    case PullBlocker::Kind::kOrder: return "beyond the nearest edit " + term + " would have no core";
    case PullBlocker::Kind::kRamp:
      return "beyond the nearest edit the transition above " + term + " would have no width";
    case PullBlocker::Kind::kUniverse:
      return "the nearest edit ends where the universe of " + variableLabel(variable) + " ends";
    case PullBlocker::Kind::kTurn: return "the force turns back at the nearest edit";
    case PullBlocker::Kind::kPin:
    case PullBlocker::Kind::kRules: break;
  }
  return "one rule is not enough, the words of the other rules hold the force";
}

std::vector<std::size_t> bestOfEachKind(std::span<const PullCandidate> candidates) {
  std::vector<std::size_t> out;
  std::set<PullKind> kinds;
  for (std::size_t k = 0; k < candidates.size() && out.size() < kShown; ++k) {
    const PullCandidate& one = candidates[k];
    if (!one.folded && kinds.insert(one.kind).second) out.push_back(k);
  }
  if (out.empty() && !candidates.empty()) out.push_back(0);
  return out;
}

NewFindings::NewFindings(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled,
                         const std::stop_token& stop)
    : known_(lint(before, compiled, stop).findings) {}

std::vector<std::string> NewFindings::of(const fuzzy::ForceModel& after, const std::stop_token& stop) const {
  const auto compiled = fuzzy::compile(after);
  if (!compiled) return {};  // no such candidate is offered
  std::vector<std::string> out;
  for (const Finding& one : lint(after, *compiled, stop).findings) {
    const bool is_known = std::any_of(known_.begin(), known_.end(), [&](const Finding& other) {
      return other.kind == one.kind && other.expert == one.expert && other.where == one.where;
    });
    if (!is_known) out.push_back((one.expert.empty() ? "" : one.expert + ": ") + one.text);
  }
  return out;
}

}  // namespace tactus::analysis
