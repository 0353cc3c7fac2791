#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/opened_model.h"
#include "app/cli/pull_curve_text.h"
#include "app/cli/pull_reference.h"
#include "app/cli/pull_text.h"
#include "app/editing/edit.h"
#include "app/version.h"
#include "core/analysis/lint.h"
#include "core/base/clock.h"
#include "core/model_io/model_file.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;

base::Result<void> refuseTheSameFile(const PullOptions& options) {
  std::error_code none;
  if (options.out.empty() || !std::filesystem::equivalent(options.model, options.out, none)) return {};
  return base::inFile({ErrorCode::kValue, {}, "--out", "the model to pull", "another file for the edited model"},
                      options.out);
}

/// The findings of the lint that the edited model has and the model before had not.
std::vector<std::string> newFindings(const OpenedModel& before, const editing::Edit& after) {
  const auto findings = analysis::lint(before.model, before.compiled).findings;
  std::vector<std::string> out;
  for (const analysis::Finding& one : analysis::lint(after.model, after.compiled).findings) {
    const bool known = std::any_of(findings.begin(), findings.end(), [&](const analysis::Finding& other) {
      return other.kind == one.kind && other.expert == one.expert && other.where == one.where;
    });
    if (!known) out.push_back("new finding: " + (one.expert.empty() ? "" : one.expert + ": ") + one.text);
  }
  return out;
}

/// Writes the model after a candidate and returns what the lint newly finds in it. The checks keep their points and get
/// the new forces.
base::Result<std::vector<std::string>> writeEdited(const PullOptions& options, const OpenedModel& opened,
                                                   const analysis::PullCandidate& candidate, const std::string& text) {
  auto edit = editing::finished(applied(opened.model, candidate.edits), text);
  if (!edit) return tl::unexpected(edit.error());
  editing::refreshChecks(edit->model, edit->compiled);
  edit->model.created_utc = base::formatUtc(std::chrono::system_clock::now());
  edit->model.generator = kGenerator;
  if (auto& from = edit->model.provenance) from->notes += (from->notes.empty() ? "" : " ") + edit->label + ".";
  if (auto ok = model_io::writeModel(edit->model, options.out); !ok) return tl::unexpected(ok.error());
  return newFindings(opened, *edit);
}

/// What an answer of either kind comes to on the screen and in a file.
struct Answer {
  std::vector<analysis::PullCandidate> candidates;
  std::vector<std::string> texts;  ///< one for each
  std::string text;                ///< for standard output
  std::vector<std::string> warnings;
};

/// A model, a point of it, and what is asked.
struct Question {
  OpenedModel opened;
  std::vector<double> point;
  analysis::PullSettings settings;
};

base::Result<Question> questionOf(const PullOptions& options) {
  auto opened = openedModel(options.model);
  if (!opened) return tl::unexpected(opened.error());
  Question out{std::move(*opened), {}, {}};
  const fuzzy::ForceModel& model = out.opened.model;
  const auto expert = expertOption(model, options.model, options.expert);
  if (!expert) return tl::unexpected(expert.error());
  out.settings.expert = *expert;
  for (const std::string& id : options.locked) {
    const auto variable = variableOption(model, "--lock", id);
    if (!variable) return tl::unexpected(variable.error());
    out.settings.locked.push_back(*variable);
  }
  auto point = pointOption(model, "--at", options.at);
  if (!point) return tl::unexpected(point.error());
  out.point = std::move(*point);
  if (auto ok = analysis::checkPoint(model, out.point); !ok) {
    ok.error().place = "--at " + ok.error().place;
    return tl::unexpected(ok.error());
  }
  return out;
}

bool leavesRulesOut(const Question& question) {
  return !question.settings.expert && question.opened.model.experts.size() > 1;
}

base::Result<Answer> pointAnswer(const PullOptions& options, const Question& question) {
  const fuzzy::ForceModel& model = question.opened.model;
  auto found =
      analysis::pull(model, question.point, *options.force_n, elicitation::justNoticeableDifference, question.settings);
  if (!found) return tl::unexpected(found.error());
  Answer out;
  out.text = options.json ? asJson(model, *found) : asText(model, *found, leavesRulesOut(question));
  for (const auto& one : found->candidates) out.texts.push_back(candidateText(model, one));
  out.candidates = std::move(found->candidates);
  return out;
}

base::Result<Answer> curveAnswer(const PullOptions& options, const Question& question) {
  const fuzzy::ForceModel& model = question.opened.model;
  auto reference = readReference(options.curve, model, question.point);
  if (!reference) return tl::unexpected(reference.error());
  const auto found = analysis::pullToCurve(model, question.point, reference->curve,
                                           elicitation::justNoticeableDifference, question.settings);
  if (!found) return base::inFile(found.error(), options.curve);
  const auto& compiled = question.opened.compiled;
  const auto now = question.settings.expert ? compiled.evaluateExpert(*question.settings.expert, question.point)
                                            : compiled.evaluate(question.point);
  const CurveQuestion asked{model, now.fired ? std::optional(now.force_n) : std::nullopt, options.force_n,
                            leavesRulesOut(question)};
  Answer out;
  out.warnings = std::move(reference->warnings);
  if (found->left_out > 0) {
    out.warnings.push_back(options.curve + ": " + std::to_string(found->left_out) +
                           " points at which no rule fires are left out");
  }
  out.text = options.json ? asJson(asked, *found) : asText(asked, *found);
  for (const auto& one : found->candidates) {
    out.candidates.push_back(one.candidate);
    out.texts.push_back(curveCandidateText(model, one));
  }
  return out;
}

/// Other experts than the pulled one whose forces an edit of shared terms moves too.
std::optional<std::string> sharedNote(const Question& question, const Answer& answer) {
  const fuzzy::ForceModel& model = question.opened.model;
  if (!question.settings.expert || model.experts.size() == 1) return std::nullopt;
  for (const auto& candidate : answer.candidates) {
    for (const auto& edit : candidate.edits) {
      if (editsRule(edit.gesture) || !edit.list.owner.empty() || readersOf(model, edit.list).size() < 2) continue;
      return "the experts share terms: an edit of them changes the forces of others than " +
             model.experts[*question.settings.expert].id;
    }
  }
  return std::nullopt;
}

}  // namespace

base::Result<Output> pull(const PullOptions& options) {
  if (auto ok = refuseTheSameFile(options); !ok) return tl::unexpected(ok.error());
  const auto question = questionOf(options);
  if (!question) return tl::unexpected(question.error());
  auto answer = options.curve.empty() ? pointAnswer(options, *question) : curveAnswer(options, *question);
  if (!answer) return tl::unexpected(answer.error());

  std::vector<std::string> warnings = question->opened.warnings;
  warnings.insert(warnings.end(), answer->warnings.begin(), answer->warnings.end());
  if (auto note = sharedNote(*question, *answer)) warnings.push_back(std::move(*note));
  if (!options.apply) return Output{std::move(answer->text), std::move(warnings)};
  const std::size_t count = answer->candidates.size();
  if (*options.apply > count) {
    return base::fail(ErrorCode::kValue, "--apply", std::to_string(*options.apply),
                      count == 0 ? "an edit, but there is none" : "a number from 1 to " + std::to_string(count));
  }
  const std::string& text = answer->texts[*options.apply - 1];
  const auto& chosen = answer->candidates[*options.apply - 1];
  const auto findings = writeEdited(options, question->opened, chosen, text);
  if (!findings) return tl::unexpected(findings.error());
  warnings.insert(warnings.end(), findings->begin(), findings->end());
  return Output{options.json ? std::move(answer->text) : base::oneLine(options.out) + ": " + text + "\n",
                std::move(warnings)};
}

}  // namespace tactus::cli
