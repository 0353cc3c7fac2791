#include "app/cli/pull_text.h"

#include <utility>
#include <vector>

#include "app/cli/model_arguments.h"
#include "app/cli/study_text.h"
#include "app/cli/terminal.h"
#include "app/editing/edit_history.h"
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

using analysis::PullCandidate;
using analysis::PullEdit;
using base::formatFixed;

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

}  // namespace

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

void writeSignOffs(base::JsonWriter& json, const std::vector<SignOff>& sign_offs) {
  json.key("sign_offs").beginArray();
  for (const SignOff& one : sign_offs) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("author").value(one.author);
    json.key("utc").value(one.utc).key("text").value(one.text).endObject();
  }
  json.endArray();
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
  const auto few = analysis::bestOfEachKind(pull.candidates);
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
