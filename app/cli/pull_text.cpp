#include "app/cli/pull_text.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "app/cli/model_arguments.h"
#include "app/cli/study_text.h"
#include "app/cli/terminal.h"
#include "app/editing/edit_history.h"
#include "core/analysis/pull/pull_edit.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"
#include "core/store/model_versions.h"

namespace tactus::cli {
namespace {

/// `model` without what does not change its force.
fuzzy::ForceModel forceAlone(fuzzy::ForceModel model) {
  model.created_utc.clear();
  model.generator.clear();
  model.provenance.reset();
  model.checks.clear();
  return model;
}

}  // namespace

base::Result<std::vector<SignOff>> signOffsOn(fuzzy::ForceModel model, const std::string& path) {
  TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly}));
  const auto versions = store::modelVersions(file);
  if (!versions) return base::inFile(versions.error(), path);
  model = forceAlone(std::move(model));
  const std::string start = std::string(name(editing::EventKind::kSignOff)) + ": ";
  std::vector<SignOff> out;
  for (const study::ModelVersion& version : *versions) {
    if (!version.label.starts_with(start)) continue;
    const auto whole = store::modelVersion(file, version.id);
    if (!whole) return base::inFile(whole.error(), path);
    TACTUS_TRY(auto signed_off,
               model_io::parseModel(whole->text, path + ": model version " + study::toText(version.id)));
    if (forceAlone(std::move(signed_off.model)) != model) continue;
    out.push_back({version.author, version.label.substr(start.size()), utcText(version.utc_ms)});
  }
  return out;
}

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

namespace {

using analysis::PullBlocker;
using analysis::PullCandidate;
using base::formatFixed;

constexpr std::size_t kShown = 3;

/// The best of each kind, by their places in the list; without a plausible one the first.
std::vector<std::size_t> shown(const analysis::Pull& pull) {
  std::vector<std::size_t> out;
  std::set<analysis::PullKind> kinds;
  for (std::size_t k = 0; k < pull.candidates.size() && out.size() < kShown; ++k) {
    const PullCandidate& one = pull.candidates[k];
    if (!one.folded && kinds.insert(one.kind).second) out.push_back(k);
  }
  if (out.empty() && !pull.candidates.empty()) out.push_back(0);
  return out;
}

}  // namespace

void writeSignOffs(base::JsonWriter& json, const std::vector<SignOff>& sign_offs) {
  json.key("sign_offs").beginArray();
  for (const SignOff& one : sign_offs) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("author").value(one.author);
    json.key("utc").value(one.utc).key("text").value(one.text).endObject();
  }
  json.endArray();
}

std::string candidateText(const fuzzy::ForceModel& model, const PullCandidate& candidate) {
  return editsText(model, candidate.edits) +
         (candidate.exact ? "" : "; comes only to " + formatFixed(candidate.force_n, 3) + " N") +
         contradictionText(candidate);
}

std::string blockerText(const fuzzy::ForceModel& model, const analysis::Pull& pull) {
  const PullBlocker& blocker = *pull.blocker;
  if (blocker.kind == PullBlocker::Kind::kLock && blocker.variable > model.inputs.size())
    return "the rules are locked, and without the lock one edit is enough";
  if (blocker.kind == PullBlocker::Kind::kPin) return "the pinned points stay, and without the pins one edit is enough";
  const fuzzy::Variable& variable = analysis::variableAt(model, blocker.variable);
  const std::string term = labelOf(findTerm(variable.terms, blocker.term), blocker.term);
  switch (blocker.kind) {
    case PullBlocker::Kind::kNoRule: return "no rule fires here";
    case PullBlocker::Kind::kLock:
      return base::oneLine(variable.id) + " is locked, and without the lock one edit is enough";
    case PullBlocker::Kind::kCentroid:
      return "the centroid of " + term + ": no word alone goes " +
             (pull.target_n < blocker.limit_n ? "below " : "above ") + formatFixed(blocker.limit_n, 3) + " N";
    case PullBlocker::Kind::kOrder: return "beyond the nearest edit " + term + " would have no core";
    case PullBlocker::Kind::kRamp:
      return "beyond the nearest edit the transition above " + term + " would have no width";
    case PullBlocker::Kind::kUniverse:
      return "the nearest edit ends where the universe of " + base::oneLine(variable.id) + " ends";
    case PullBlocker::Kind::kTurn: return "the force turns back at the nearest edit";
    case PullBlocker::Kind::kPin:
    case PullBlocker::Kind::kRules: break;
  }
  return "one rule is not enough, the words of the other rules hold the force";
}

std::string asText(const fuzzy::ForceModel& model, const analysis::Pull& pull, bool rules_left_out,
                   const PullNotes& notes) {
  const std::string wanted = formatFixed(pull.target_n, 3) + " N";
  if (!pull.before_n) return "No rule fires here, so no edit of what is there gives " + wanted + ".\n";
  std::string sentence = formatFixed(*pull.before_n, 3) + " N here, wanted " + wanted +
                         ". Within reach: " + formatFixed(pull.reachable->min_n, 3) + " to " +
                         formatFixed(pull.reachable->max_n, 3) + " N.";
  if (pull.blocker) {
    sentence += " No single edit gives " + wanted + ": " + blockerText(model, pull) + ".";
    if (!pull.candidates.empty()) sentence += " The nearest:";
  } else if (pull.candidates.empty()) {
    sentence += " Nothing has to change.";
  }
  std::string text = wrapped(sentence, "", 0);
  const auto few = shown(pull);
  for (const std::size_t k : few) {
    const PullCandidate& one = pull.candidates[k];
    text += "\n" + wrapped(candidateText(model, one), padded(std::to_string(k + 1), 4), 4);
    text += wrapped(elsewhereText(one), "    ", 4) + findingsText(notes.findings(one));
  }
  if (pull.candidates.size() > few.size())
    text += "\n" + std::to_string(pull.candidates.size() - few.size()) + " more with --json\n";
  if (rules_left_out) text += "\nA rule belongs to one expert: its edits are offered with --expert ID.\n";
  return text;
}

std::string asJson(const fuzzy::ForceModel& model, const analysis::Pull& pull, const PullNotes& notes) {
  base::JsonWriter json;
  json.beginObject().key("before_n").value(pull.before_n).key("target_n").value(pull.target_n).key("reachable");
  if (pull.reachable) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("min_n").value(pull.reachable->min_n);
    json.key("max_n").value(pull.reachable->max_n).endObject();
  } else {
    json.null();
  }
  json.key("blocker");
  pull.blocker ? json.value(blockerText(model, pull)) : json.null();
  writeSignOffs(json, notes.sign_offs);
  json.key("candidates").beginArray();
  for (const PullCandidate& one : pull.candidates) {
    json.beginObject();
    writeMembers(json, model, one, notes.findings(one));
    json.key("text").value(candidateText(model, one)).endObject();
  }
  return json.endArray().endObject().text();
}

}  // namespace tactus::cli
