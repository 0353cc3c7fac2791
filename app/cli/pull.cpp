#include "core/analysis/pull/pull.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/opened_model.h"
#include "app/cli/pull_text.h"
#include "app/editing/edit.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/text.h"
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

/// Writes the model after a candidate. The checks keep their points and get the new forces.
base::Result<void> writeEdited(const PullOptions& options, const fuzzy::ForceModel& model,
                               const analysis::PullCandidate& candidate) {
  auto edit = editing::finished(applied(model, candidate.edits), candidateText(model, candidate));
  if (!edit) return tl::unexpected(edit.error());
  editing::refreshChecks(edit->model, edit->compiled);
  edit->model.created_utc = base::formatUtc(std::chrono::system_clock::now());
  edit->model.generator = kGenerator;
  if (auto& from = edit->model.provenance) from->notes += (from->notes.empty() ? "" : " ") + edit->label + ".";
  return model_io::writeModel(edit->model, options.out);
}

/// The experts other than the pulled one whose forces an edit of shared terms moves too.
std::vector<std::string> sharedNote(const fuzzy::ForceModel& model, std::optional<std::size_t> expert,
                                    const analysis::Pull& pull) {
  if (!expert || model.experts.size() == 1) return {};
  for (const auto& candidate : pull.candidates) {
    for (const auto& edit : candidate.edits) {
      if (editsRule(edit.gesture) || !edit.list.owner.empty()) continue;
      if (readersOf(model, edit.list).size() < 2) continue;
      return {"the experts share terms: an edit of them changes the forces of others than " +
              base::oneLine(model.experts[*expert].id)};
    }
  }
  return {};
}

}  // namespace

base::Result<Output> pull(const PullOptions& options) {
  if (auto ok = refuseTheSameFile(options); !ok) return tl::unexpected(ok.error());
  const auto opened = openedModel(options.model);
  if (!opened) return tl::unexpected(opened.error());
  const fuzzy::ForceModel& model = opened->model;
  analysis::PullSettings settings;
  const auto expert = expertOption(model, options.model, options.expert);
  if (!expert) return tl::unexpected(expert.error());
  settings.expert = *expert;
  for (const std::string& id : options.locked) {
    const auto variable = variableOption(model, "--lock", id);
    if (!variable) return tl::unexpected(variable.error());
    settings.locked.push_back(*variable);
  }
  const auto point = pointOption(model, "--at", options.at);
  if (!point) return tl::unexpected(point.error());
  const auto found = analysis::pull(model, *point, options.force_n, elicitation::justNoticeableDifference, settings);
  if (!found)
    return tl::unexpected(
        base::Error{found.error().code, {}, "--at " + found.error().place, found.error().found, found.error().wanted});

  std::vector<std::string> warnings = opened->warnings;
  for (auto& note : sharedNote(model, *expert, *found)) warnings.push_back(std::move(note));
  std::string text = options.json ? asJson(model, *found) : asText(model, *found, !*expert && model.experts.size() > 1);
  if (!options.apply) return Output{std::move(text), std::move(warnings)};
  if (*options.apply > found->candidates.size()) {
    const std::size_t count = found->candidates.size();
    return base::fail(ErrorCode::kValue, "--apply", std::to_string(*options.apply),
                      count == 0 ? "an edit, but there is none" : "a number from 1 to " + std::to_string(count));
  }
  const auto& chosen = found->candidates[*options.apply - 1];
  if (auto ok = writeEdited(options, model, chosen); !ok) return tl::unexpected(ok.error());
  if (!options.json) text = base::oneLine(options.out) + ": " + candidateText(model, chosen) + "\n";
  return Output{std::move(text), std::move(warnings)};
}

}  // namespace tactus::cli
