#include "app/cli/pull_curve_text.h"

#include "app/cli/pull_edit_text.h"
#include "app/cli/wrapped_text.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

using base::formatFixed;

constexpr std::size_t kMostShown = 3;

/// What stays in the way if no edit comes close.
std::optional<std::string> leftOver(const analysis::CurvePull& pull) {
  if (pull.close) return std::nullopt;
  if (pull.candidates.empty()) return "no edit of a term or rule gains a tenth of the distance";
  return "up to three edits still leave " + formatFixed(pull.candidates[0].residual_n, 3) + " N (root mean square)";
}

}  // namespace

std::string curveCandidateText(const fuzzy::ForceModel& model, const analysis::CurveCandidate& candidate) {
  return editsText(model, candidate.candidate.edits) + "; leaves " + formatFixed(candidate.residual_n, 3) + " N" +
         (candidate.same_curve == 0
              ? ""
              : "; as much as " + std::to_string(candidate.same_curve) +
                    (candidate.same_curve == 1 ? " other edit" : " other edits") + " here, different elsewhere") +
         contradictionText(candidate.candidate);
}

std::string asText(const CurveQuestion& question, const analysis::CurvePull& pull, const PullNotes& notes) {
  std::string sentence =
      "The force is " + formatFixed(pull.residual_n, 3) + " N (root mean square) from the reference.";
  if (const auto left = leftOver(pull)) sentence += " Out of reach: " + *left + ".";
  if (pull.candidates.empty() && pull.close) sentence += " Nothing has to change.";
  std::string text = wrapped(sentence, "", 0);
  std::size_t shown = 0;
  for (; shown < pull.candidates.size() && shown < kMostShown; ++shown) {
    const analysis::CurveCandidate& one = pull.candidates[shown];
    text += "\n" + wrapped(curveCandidateText(question.model, one), padded(std::to_string(shown + 1), 4), 4);
    text += wrapped(elsewhereText(one.candidate), "    ", 4) + findingsText(notes.findings(one.candidate));
  }
  if (pull.candidates.size() > shown)
    text += "\n" + std::to_string(pull.candidates.size() - shown) + " more with --json\n";
  if (question.rules_left_out) text += "\nA rule belongs to one expert: its edits are offered with --expert ID.\n";
  return text;
}

std::string asJson(const CurveQuestion& question, const analysis::CurvePull& pull, const PullNotes& notes) {
  base::JsonWriter json;
  json.beginObject().key("before_n");
  question.before_n ? json.value(*question.before_n) : json.null();
  json.key("target_n");
  question.target_n ? json.value(*question.target_n) : json.null();
  json.key("residual_n").value(pull.residual_n).key("reachable").null().key("blocker");
  const auto left = leftOver(pull);
  left ? json.value(*left) : json.null();
  writeSignOffs(json, notes.sign_offs);
  json.key("candidates").beginArray();
  for (const analysis::CurveCandidate& one : pull.candidates) {
    json.beginObject();
    writeMembers(json, question.model, one.candidate, notes.findings(one.candidate));
    json.key("residual_n").value(one.residual_n);
    json.key("text").value(curveCandidateText(question.model, one)).endObject();
  }
  return json.endArray().endObject().text();
}

}  // namespace tactus::cli
