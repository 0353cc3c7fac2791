#include <algorithm>
#include <chrono>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/opened_model.h"
#include "app/cli/output_file.h"
#include "app/cli/pull_curve_text.h"
#include "app/cli/pull_findings.h"
#include "app/cli/pull_reference.h"
#include "app/cli/pull_sign_offs.h"
#include "app/cli/pull_text.h"
#include "app/editing/edit.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/model_io/model_file.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;

/// The word for all rules in `--lock`, unless a variable is called so.
constexpr std::string_view kRules = "rules";

/// The text of the model after a candidate. The checks keep their points and get the new forces.
base::Result<std::string> editedText(const PullOptions& options, const OpenedModel& opened,
                                     const analysis::PullCandidate& candidate, const std::string& text) {
  auto edit = editing::finished(applied(opened.model, candidate.edits), text);
  if (!edit) return tl::unexpected(edit.error());
  editing::refreshChecks(edit->model, edit->compiled);
  edit->model.created_utc = base::formatUtc(std::chrono::system_clock::now());
  edit->model.generator = kGenerator;
  if (auto& from = edit->model.provenance) from->notes += (from->notes.empty() ? "" : " ") + edit->label + ".";
  return model_io::modelText(edit->model, options.out);
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
  std::unique_ptr<NewFindings> findings = {};  ///< of edits of `opened`, which does not move any more
  std::vector<SignOff> sign_offs = {};
};

/// The point of `--pin`: the inputs that it names, and the others as in `point`.
base::Result<std::vector<double>> pinOption(const fuzzy::ForceModel& model, const std::string& text,
                                            std::vector<double> point) {
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, ',');) {
    const auto input = inputOption(model, "--pin", entry);
    if (!input) return tl::unexpected(input.error());
    point[input->first] = input->second;
  }
  return point;
}

base::Result<Question> questionOf(const PullOptions& options) {
  auto opened = openedModel(options.model);
  if (!opened) return tl::unexpected(opened.error());
  Question out{std::move(*opened), {}, {}};
  const fuzzy::ForceModel& model = out.opened.model;
  const auto expert = expertOption(model, options.model, options.expert);
  if (!expert) return tl::unexpected(expert.error());
  out.settings.expert = *expert;
  for (const std::string& id : options.locked) {
    auto variable = variableOption(model, "--lock", id);
    if (variable) {
      out.settings.locked.push_back(*variable);
    } else if (id == kRules) {
      out.settings.lock_rules = true;
    } else {
      variable.error().wanted += ", or " + std::string(kRules);
      return tl::unexpected(variable.error());
    }
  }
  auto point = pointOption(model, "--at", options.at);
  if (!point) return tl::unexpected(point.error());
  out.point = std::move(*point);
  if (auto ok = analysis::checkPoint(model, out.point); !ok) {
    ok.error().place = "--at " + ok.error().place;
    return tl::unexpected(ok.error());
  }
  for (const std::string& pin : options.pins) {
    auto pinned = pinOption(model, pin, out.point);
    if (!pinned) return tl::unexpected(pinned.error());
    if (auto ok = analysis::checkPoint(model, *pinned); !ok) {
      ok.error().place = "--pin " + ok.error().place;
      return tl::unexpected(ok.error());
    }
    out.settings.pins.push_back(std::move(*pinned));
  }
  return out;
}

PullNotes notesOf(const Question& question) {
  return {[&question](const analysis::PullCandidate& one) { return question.findings->after(one); },
          question.sign_offs};
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
  const PullNotes notes = notesOf(question);
  out.text = options.json ? asJson(model, *found, notes) : asText(model, *found, leavesRulesOut(question), notes);
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
  const PullNotes notes = notesOf(question);
  out.text = options.json ? asJson(asked, *found, notes) : asText(asked, *found, notes);
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
  if (auto ok = requireOutput(options.out, {options.model, options.curve, options.study}); !ok)
    return tl::unexpected(ok.error());
  auto question = questionOf(options);
  if (!question) return tl::unexpected(question.error());
  if (!options.study.empty()) {
    auto sign_offs = signOffsOn(question->opened.model, options.study);
    if (!sign_offs) return tl::unexpected(sign_offs.error());
    question->sign_offs = std::move(*sign_offs);
  }
  question->findings = std::make_unique<NewFindings>(question->opened);
  auto answer = options.curve.empty() ? pointAnswer(options, *question) : curveAnswer(options, *question);
  if (!answer) return tl::unexpected(answer.error());

  std::vector<std::string> warnings = question->opened.warnings;
  warnings.insert(warnings.end(), answer->warnings.begin(), answer->warnings.end());
  for (const SignOff& one : question->sign_offs) {
    warnings.push_back("every edit contradicts a sign-off: " + one.author + ", " + one.utc + ": " + one.text);
  }
  if (auto note = sharedNote(*question, *answer)) warnings.push_back(std::move(*note));
  if (!options.apply) return Output{std::move(answer->text), std::move(warnings)};
  const std::size_t count = answer->candidates.size();
  if (*options.apply > count) {
    return base::fail(ErrorCode::kValue, "--apply", std::to_string(*options.apply),
                      count == 0 ? "an edit, but there is none" : "a number from 1 to " + std::to_string(count));
  }
  const std::string& text = answer->texts[*options.apply - 1];
  const auto& chosen = answer->candidates[*options.apply - 1];
  const auto edited = editedText(options, question->opened, chosen, text);
  if (!edited) return tl::unexpected(edited.error());
  for (const std::string& finding : question->findings->after(chosen)) warnings.push_back("new finding: " + finding);
  return written(
      options.out, *edited,
      {options.json ? std::move(answer->text) : base::oneLine(options.out) + ": " + text + "\n", std::move(warnings)},
      options.json);
}

}  // namespace tactus::cli
