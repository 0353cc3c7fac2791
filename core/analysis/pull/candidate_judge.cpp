#include "core/analysis/pull/candidate_judge.h"

#include <cmath>
#include <utility>

#include "core/analysis/pull/plausible.h"

namespace tactus::analysis {
namespace {

constexpr double kSameTarget = 1e-9;  // of the range of the output

}  // namespace

CandidateJudge::CandidateJudge(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                               const std::vector<double>& point, const NoticeableDifference& noticeable,
                               const PullSettings& settings)
    : model_(model),
      point_(point),
      curve_input_(analysis::curveInput(model, settings.curve_input)),
      elsewhere_(model, compiled, point, curve_input_, settings.box_points, noticeable) {}

double CandidateJudge::same() const noexcept { return kSameTarget * (model_.output.max - model_.output.min); }

std::optional<PullCandidate> CandidateJudge::judged(std::vector<PullEdit> edits, std::optional<double> target_n) const {
  PullCandidate out;
  fuzzy::ForceModel after = model_;
  for (const PullEdit& edit : edits) {
    fuzzy::ForceModel next = applied(after, edit);
    out.folded = out.folded || !isPlausible(after, next, edit);
    after = std::move(next);
  }
  const auto compiled = fuzzy::compile(after);
  if (!compiled) return std::nullopt;
  const auto force = compiled->evaluate(point_);
  out.elsewhere = elsewhere_.of(*compiled);
  if (!force.fired || out.elsewhere.opens_hole) return std::nullopt;
  out.kind = kindOf(model_, edits[0], curve_input_);
  out.force_n = force.force_n;
  out.exact = target_n && std::abs(force.force_n - *target_n) <= same();
  out.edits = std::move(edits);
  return out;
}

}  // namespace tactus::analysis
