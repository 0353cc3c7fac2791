#include "core/analysis/pull/pull_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/pull/candidate_judge.h"
#include "core/analysis/pull/gesture_search.h"
#include "core/analysis/pull/plausible.h"
#include "core/analysis/pull/reference_fit.h"
#include "core/analysis/pull/rule_search.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

constexpr std::size_t kMostSteps = 3;
constexpr double kGain = 0.1;         // of the rest, for each step
constexpr double kClose = 0.25;       // noticeable differences
constexpr double kSameCurveN = 1e-6;  // residuals that a table of forces does not tell apart

/// The edits of one step, each with its best delta, that gain enough.
std::vector<PullEdit> worthwhile(const ForceModel& model, const ReferenceFit& fit, const PullSettings& settings,
                                 double residual_n) {
  std::vector<PullEdit> out;
  const auto take = [&](const PullEdit& edit) {
    const auto residual = fit.after(model, edit);
    if (residual && residual->rms_n <= (1 - kGain) * residual_n) out.push_back(edit);
  };
  for (const PulledList& list : listsOf(model, model.experts.size() > 1)) {
    if (std::find(settings.locked.begin(), settings.locked.end(), list.variable) != settings.locked.end()) continue;
    for (SearchedGesture& one : gesturesOfList(model, list)) {
      const auto delta = fit.best(model, one.edit, one.range);
      if (!delta || *delta == 0) continue;
      one.edit.delta = *delta;
      take(one.edit);
    }
  }
  if (model.experts.size() == 1 && !settings.lock_rules) {
    for (const PullEdit& edit : ruleEdits(model, 0)) take(edit);
  }
  return out;
}

long long step(double residual_n) { return std::llround(residual_n / kSameCurveN); }

bool better(const CurveCandidate& one, const CurveCandidate& other) {
  if (one.candidate.folded != other.candidate.folded) return other.candidate.folded;
  if (step(one.residual_n) != step(other.residual_n)) return one.residual_n < other.residual_n;
  return one.candidate.elsewhere.k_box < other.candidate.elsewhere.k_box;
}

/// The candidates of `earlier` with one edit more.
std::vector<CurveCandidate> nextStep(const ForceModel& model, const ReferenceFit& fit, const CandidateJudge& judge,
                                     const PullSettings& settings, const std::vector<PullEdit>& earlier,
                                     double residual_n) {
  const ForceModel now = applied(model, earlier);
  std::vector<CurveCandidate> out;
  for (PullEdit& edit : worthwhile(now, fit, settings, residual_n)) {
    const double left_n = fit.after(now, edit)->rms_n;
    std::vector<PullEdit> edits = earlier;
    edits.push_back(std::move(edit));
    if (auto candidate = judge.judged(std::move(edits), std::nullopt)) {
      candidate->exact = left_n <= judge.same();
      out.push_back({std::move(*candidate), left_n, 0});
    }
  }
  std::stable_sort(out.begin(), out.end(), better);
  return out;
}

}  // namespace

base::Result<CurvePull> pullToCurve(const ForceModel& model, std::span<const double> point,
                                    const ReferenceCurve& reference, const NoticeableDifference& noticeable,
                                    const PullSettings& settings) {
  if (auto ok = checkPoint(model, point); !ok) return tl::unexpected(ok.error());
  const ForceModel pulled = modelOf(model, settings.expert);
  const auto compiled = fuzzy::compile(pulled);
  if (!compiled) return tl::unexpected(compiled.error());
  if (auto ok = checkPins(*compiled, model, settings.pins); !ok) return tl::unexpected(ok.error());
  const ReferenceFit fit(*compiled, reference, noticeable);
  if (fit.points() == 0) {
    return base::fail(base::ErrorCode::kData, "", "a reference without a point at which a rule fires", "at least one");
  }
  const CandidateJudge judge(pulled, *compiled, {point.begin(), point.end()}, noticeable, settings);
  CurvePull out;
  out.left_out = fit.leftOut();
  const auto now = *fit.of(*compiled);
  out.residual_n = now.rms_n;
  out.close = now.rms_noticeable < kClose;
  if (now.rms_n <= judge.same()) return out;

  out.candidates = nextStep(pulled, fit, judge, settings, {}, now.rms_n);
  for (CurveCandidate& one : out.candidates) {
    if (reference.low_n != reference.high_n) break;  // a band leaves room for different curves
    one.same_curve = static_cast<std::size_t>(std::count_if(
        out.candidates.begin(), out.candidates.end(),
        [&](const CurveCandidate& other) { return &other != &one && step(other.residual_n) == step(one.residual_n); }));
  }
  if (out.candidates.empty() || out.candidates[0].candidate.folded) return out;
  CurveCandidate best = out.candidates[0];
  const auto isClose = [&] {
    const auto after = fuzzy::compile(applied(pulled, best.candidate.edits));
    return fit.of(*after)->rms_noticeable < kClose;
  };
  out.close = isClose();
  while (!out.close && best.candidate.edits.size() < kMostSteps) {
    auto next = nextStep(pulled, fit, judge, settings, best.candidate.edits, best.residual_n);
    if (next.empty() || next[0].candidate.folded) break;
    best = std::move(next[0]);
    out.close = isClose();
  }
  if (best.candidate.edits.size() > 1) out.candidates.insert(out.candidates.begin(), std::move(best));
  return out;
}

}  // namespace tactus::analysis
