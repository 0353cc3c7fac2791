#include "app/cli/pull_text.h"

#include <set>
#include <vector>

#include "app/cli/model_words.h"
#include "app/cli/pull_edit_text.h"
#include "app/cli/wrapped_text.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::cli {
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
    case PullBlocker::Kind::kNoRule:
      return "no rule fires here";
    case PullBlocker::Kind::kLock:
      return base::oneLine(variable.id) + " is locked, and without the lock one edit is enough";
    case PullBlocker::Kind::kCentroid:
      return "the centroid of " + term + ": no word alone goes " +
             (pull.target_n < blocker.limit_n ? "below " : "above ") + formatFixed(blocker.limit_n, 3) + " N";
    case PullBlocker::Kind::kOrder:
      return "beyond the nearest edit " + term + " would have no core";
    case PullBlocker::Kind::kRamp:
      return "beyond the nearest edit the transition above " + term + " would have no width";
    case PullBlocker::Kind::kUniverse:
      return "the nearest edit ends where the universe of " + base::oneLine(variable.id) + " ends";
    case PullBlocker::Kind::kTurn:
      return "the force turns back at the nearest edit";
    case PullBlocker::Kind::kPin:
    case PullBlocker::Kind::kRules:
      break;
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
  json.beginObject().key("before_n");
  pull.before_n ? json.value(*pull.before_n) : json.null();
  json.key("target_n").value(pull.target_n).key("reachable");
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
