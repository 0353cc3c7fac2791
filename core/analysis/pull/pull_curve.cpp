#include "core/analysis/pull/pull_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/analysis/pull/candidate_judge.h"
#include "core/analysis/pull/elsewhere.h"
#include "core/analysis/pull/force_search.h"
#include "core/base/error.h"

namespace tactus::analysis {
namespace {

constexpr int kLooks = 61;
constexpr int kSections = 75;       // 0.618^75 of two looks is below the rounding of a delta
constexpr double kNothing = 1e-12;  // N: rounding of the forces

/// How far `force_n` is outside of [low_n, high_n].
double outside(double force_n, double low_n, double high_n) {
  return force_n < low_n ? low_n - force_n : force_n > high_n ? force_n - high_n : 0;
}

}  // namespace

ReferenceFit::ReferenceFit(const fuzzy::CompiledModel& compiled, const ReferenceCurve& reference,
                           const NoticeableDifference& noticeable) {
  const std::size_t count = reference.low_n.size();
  std::vector<double> force_n(count);
  std::vector<std::uint8_t> fired(count);
  evaluateColumns(compiled, reference.columns, force_n, fired);
  reference_.columns.resize(reference.columns.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (fired[k] == 0) {
      ++left_out_;
      continue;
    }
    for (std::size_t i = 0; i < reference.columns.size(); ++i) {
      reference_.columns[i].push_back(reference.columns[i][k]);
    }
    reference_.low_n.push_back(reference.low_n[k]);
    reference_.high_n.push_back(reference.high_n[k]);
    const double nearest_n = std::clamp(force_n[k], reference.low_n[k], reference.high_n[k]);
    noticeable_n_.push_back(noticeable(std::abs(nearest_n)));
  }
}

std::optional<ReferenceFit::Residual> ReferenceFit::of(const fuzzy::CompiledModel& model) const {
  std::vector<double> force_n(points());
  std::vector<std::uint8_t> fired(points());
  evaluateColumns(model, reference_.columns, force_n, fired);
  Residual sums;
  for (std::size_t k = 0; k < points(); ++k) {
    if (fired[k] == 0) return std::nullopt;
    const double off_n = outside(force_n[k], reference_.low_n[k], reference_.high_n[k]);
    sums.rms_n += off_n * off_n;
    sums.rms_noticeable += off_n / noticeable_n_[k] * (off_n / noticeable_n_[k]);
  }
  const auto count = static_cast<double>(points());
  return Residual{std::sqrt(sums.rms_n / count), std::sqrt(sums.rms_noticeable / count)};
}

std::optional<ReferenceFit::Residual> ReferenceFit::after(const fuzzy::ForceModel& model, const PullEdit& edit) const {
  const auto compiled = fuzzy::compile(applied(model, edit));
  return compiled ? of(*compiled) : std::nullopt;
}

std::optional<double> ReferenceFit::best(const fuzzy::ForceModel& model, PullEdit edit, const DeltaRange& range) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto left = [&](double delta) {
    edit.delta = delta;
    const auto residual = after(model, edit);
    return residual ? residual->rms_n : kNever;
  };
  const double now = left(0);
  if (left(range.low) == now && left(range.high) == now) return std::nullopt;
  std::array<double, kLooks> deltas;
  std::array<double, kLooks> residuals;
  const double step = (range.high - range.low) / (kLooks - 1);
  std::size_t least = 0;
  for (std::size_t k = 0; k < kLooks; ++k) {
    deltas[k] = k + 1 == kLooks ? range.high : range.low + step * static_cast<double>(k);
    residuals[k] = left(deltas[k]);
    const bool both_nothing = residuals[k] <= kNothing && residuals[least] <= kNothing;
    if (both_nothing ? std::abs(deltas[k]) < std::abs(deltas[least]) : residuals[k] < residuals[least]) least = k;
  }
  if (residuals[least] == kNever) return std::nullopt;
  if (residuals[least] <= kNothing) {  // a band: from here toward 0 until something is left
    double with = deltas[least];
    double without = std::abs(with) <= step ? 0 : with - std::copysign(step, with);
    for (int i = 0; i < kSections && with != without; ++i) {
      const double middle = (with + without) / 2;
      (left(middle) <= kNothing ? with : without) = middle;
    }
    return with;
  }
  constexpr double kGolden = 0.6180339887498949;
  double low = deltas[least == 0 ? 0 : least - 1];
  double high = deltas[least + 1 == kLooks ? least : least + 1];
  double first = high - kGolden * (high - low);
  double second = low + kGolden * (high - low);
  double at_first = left(first);
  double at_second = left(second);
  for (int i = 0; i < kSections && low < first && first < second && second < high; ++i) {
    if (at_first <= at_second) {
      high = second;
      second = std::exchange(first, second - kGolden * (second - low));
      at_second = std::exchange(at_first, left(first));
    } else {
      low = first;
      first = std::exchange(second, first + kGolden * (high - first));
      at_first = std::exchange(at_second, left(second));
    }
  }
  const double found = at_first <= at_second ? first : second;
  return std::min(at_first, at_second) <= residuals[least] ? found : deltas[least];
}

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
    for (SearchedGesture& one : gesturesOfList(model, list)) {
      if (isLocked(model, one.edit, settings)) continue;
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
  TACTUS_TRY(const auto compiled, fuzzy::compile(pulled));
  if (auto ok = checkPins(compiled, model, settings.pins); !ok) return tl::unexpected(ok.error());
  const ReferenceFit fit(compiled, reference, noticeable);
  if (fit.points() == 0) {
    return base::fail(base::ErrorCode::kData, "", "a reference without a point at which a rule fires", "at least one");
  }
  const CandidateJudge judge(pulled, compiled, {point.begin(), point.end()}, noticeable, settings);
  CurvePull out;
  out.left_out = fit.leftOut();
  const auto now = *fit.of(compiled);
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
