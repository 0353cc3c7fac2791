#include <algorithm>
#include <cmath>

#include "app/report/claims.h"
#include "core/base/statistics.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

/// One expert with the curve of Fig. 11, a value or a gap at every depth.
struct Candidate {
  const fuzzy::Expert& expert;
  ForceCurve curve;
};
using Candidates = std::vector<Candidate>;

Verdict emptyVerdict(std::string subject) {
  return {.subject = std::move(subject),
          .holds = std::nullopt,
          .basis = ClaimBasis::kByConstruction,
          .numbers = {},
          .reason = {}};
}

Verdict highestPeak(const ClaimContext& context) {
  Verdict verdict = emptyVerdict("all experts");
  std::vector<std::string> texts;
  std::optional<double> wanted_n, others_n;
  for (std::size_t i = 0; i < context.model.experts.size(); ++i) {
    const Profile profile = profileOf(context, i);
    if (profile.curve.empty()) continue;
    const std::vector<CurvePoint> peaks = peaksOf(profile.curve);
    texts.push_back(profile.subject + " " + peakText(context, peaks));
    std::optional<double>& best_n = profile.subject == context.highest_peak_expert ? wanted_n : others_n;
    best_n = std::max(best_n.value_or(0), *peaks.front().force_n);
  }
  if (!wanted_n || !others_n) {
    verdict.reason = context.highest_peak_expert + " and another expert are needed to compare.";
    return verdict;
  }
  verdict.holds = *wanted_n > *others_n + kTieN;
  verdict.numbers = "Peaks: " + base::joined(texts, ", ") + ". " + context.highest_peak_expert + " is " +
                    newtons(std::abs(*wanted_n - *others_n)) + (*wanted_n >= *others_n ? " above" : " below") +
                    " the highest of the others.";
  return verdict;
}

Verdict closeInEsophagus(const ClaimContext& context, const Candidates& candidates) {
  Verdict verdict = emptyVerdict("all experts");
  const Region& esophagus = regionOf(context.regions, "esophagus");
  std::vector<double> spreads_n, jnds_n;
  CurvePoint worst{esophagus.from_mm, 0.0};
  std::size_t close = 0;
  const std::size_t points = candidates.empty() ? 0 : candidates.front().curve.size();
  for (std::size_t i = 0; i < points; ++i) {
    const double depth_mm = candidates.front().curve[i].depth_mm;
    if (depth_mm < esophagus.from_mm || depth_mm > esophagus.to_mm) continue;
    std::vector<double> forces_n;
    for (const Candidate& candidate : candidates) {
      if (candidate.curve[i].force_n) forces_n.push_back(*candidate.curve[i].force_n);
    }
    if (forces_n.size() < 2) continue;
    const auto [low, high] = std::minmax_element(forces_n.begin(), forces_n.end());
    spreads_n.push_back(*high - *low);
    jnds_n.push_back(justNoticeableDifference(base::mean(forces_n)));
    close += spreads_n.back() <= jnds_n.back() ? 1 : 0;
    if (spreads_n.back() > *worst.force_n) worst = {depth_mm, spreads_n.back()};
  }
  if (spreads_n.empty()) {
    verdict.reason = "No two experts have a force there.";
    return verdict;
  }
  const double share = static_cast<double>(close) / static_cast<double>(spreads_n.size());
  verdict.holds = share >= kEnoughDepths && base::mean(spreads_n) <= base::mean(jnds_n);
  verdict.numbers = "From " + millimeters(esophagus.from_mm) + " to " + millimeters(esophagus.to_mm) +
                    " the experts differ by " + newtons(base::mean(spreads_n)) + " on average, at most " +
                    newtons(*worst.force_n) + " at " + millimeters(worst.depth_mm) +
                    "; a difference is felt from about " + newtons(base::mean(jnds_n)) + ". Too small to be felt at " +
                    percent(share) + " of the depths.";
  return verdict;
}

/// Pearson's correlation of two samples of equal size; nothing if one of them is constant.
std::optional<double> correlation(const std::vector<double>& first, const std::vector<double>& second) {
  const double mean_first = base::mean(first);
  const double mean_second = base::mean(second);
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double x = first[i] - mean_first;
    const double y = second[i] - mean_second;
    xx += x * x;
    yy += y * y;
    xy += x * y;
  }
  if (std::sqrt(std::min(xx, yy) / static_cast<double>(first.size())) < kTieN) return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

/// The mean force in a region; nothing where the expert's rules do not speak of it or none fires.
std::optional<double> regionMean(const Candidate& candidate, const Region& region) {
  if (!wasAsked(candidate.expert, region.id)) return std::nullopt;
  std::vector<double> forces_n;
  for (const CurvePoint& point : candidate.curve) {
    if (point.force_n && point.depth_mm >= region.from_mm && point.depth_mm <= region.to_mm) {
      forces_n.push_back(*point.force_n);
    }
  }
  if (forces_n.empty()) return std::nullopt;
  return base::mean(forces_n);
}

Verdict similarProfiles(const ClaimContext& context, const Candidates& candidates) {
  // With two regions any two profiles correlate perfectly.
  constexpr std::size_t kFewestRegions = 3;
  Verdict verdict = emptyVerdict("all experts");
  std::vector<std::string> texts;
  bool similar = true;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t k = i + 1; k < candidates.size(); ++k) {
      std::vector<double> first, second;
      for (const Region& region : context.regions) {
        const auto a = regionMean(candidates[i], region);
        const auto b = regionMean(candidates[k], region);
        if (!a || !b) continue;
        first.push_back(*a);
        second.push_back(*b);
      }
      if (first.size() < kFewestRegions) continue;
      const auto r = correlation(first, second);
      similar = similar && r && *r >= kSimilarCorrelation;
      texts.push_back(candidates[i].expert.id + " and " + candidates[k].expert.id + ' ' +
                      (r ? base::formatFixed(*r, 2) : std::string("none (constant)")) + " (" +
                      std::to_string(first.size()) + " regions)");
    }
  }
  if (texts.empty()) {
    verdict.reason = "No two experts were asked about three regions in common.";
    return verdict;
  }
  verdict.holds = similar;
  verdict.numbers = "Correlation of " + base::joined(texts, ", ") + ".";
  return verdict;
}

Verdict meanOfExperts(const ClaimContext& context, const Candidates& candidates) {
  Verdict verdict = emptyVerdict("mean");
  double worst_n = 0;
  const ForceCurve mean = context.curve(kFig11, std::nullopt);
  std::vector<double> weight;
  for (const Candidate& candidate : candidates) weight.push_back(candidate.expert.weight);
  weight = fuzzy::normalizedWeights(weight);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double sum_n = 0;
    double weights = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      const auto& force_n = candidates[c].curve[i].force_n;
      if (!force_n) continue;
      sum_n += weight[c] * *force_n;
      weights += weight[c];
    }
    if (mean[i].force_n && weights > 0) worst_n = std::max(worst_n, std::abs(*mean[i].force_n - sum_n / weights));
  }
  // Rounding in a weighted mean of a few forces below 10 N stays far below this.
  constexpr double kRoundingN = 1e-12;
  verdict.holds = worst_n <= kRoundingN;
  verdict.numbers = "Largest difference between the averaged model and the mean of the experts' forces: " +
                    (worst_n <= kRoundingN ? std::string("below 1e-12 N") : newtons(worst_n)) + ".";
  return verdict;
}

/// Tries a statement about all experts. If it fails with the published expert and holds without, the reason says so.
template <class Statement>
Verdict tryOnAll(const ClaimContext& context, const Candidates& all, Statement statement) {
  Verdict verdict = statement(context, all);
  if (!verdict.holds || *verdict.holds) return verdict;
  Candidates others;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i != context.published_expert) others.push_back(all[i]);
  }
  const Verdict without = statement(context, others);
  if (without.holds && *without.holds) {
    verdict.reason = context.model.experts[context.published_expert].id +
                     " contradicts it: without this expert, whose rules are published, it holds.";
  }
  return verdict;
}

}  // namespace

std::vector<Claim> claimsOfAgreement(const ClaimContext& context) {
  Candidates candidates;
  for (std::size_t i = 0; i < context.model.experts.size(); ++i) {
    candidates.push_back({context.model.experts[i], context.curve(kFig11, i)});
  }
  return {{"11c",
           "The peak of " + context.highest_peak_expert + " is the highest.",
           "Yes if its largest force is above that of every other expert.",
           {highestPeak(context)}},
          {"11d",
           "Once the esophagus is entered the forces of all experts are close.",
           "Yes if the largest difference between experts stays below what a hand can feel, sqrt(0.04² + (0.12 F)²) N, "
           "on average and at " +
               percent(kEnoughDepths) + " of the depths.",
           {tryOnAll(context, candidates, closeInEsophagus)}},
          {"11e",
           "Profiles and trends of the experts are similar.",
           "Yes if the mean forces by region of every two experts correlate with at least " +
               base::formatFixed(kSimilarCorrelation, 1) + ", over the regions that both were asked about.",
           {tryOnAll(context, candidates, similarProfiles)}},
          {"11f",
           "The final curve is the average of the experts' forces (Eq. 2).",
           "Yes if both agree up to rounding.",
           {meanOfExperts(context, candidates)}}};
}

}  // namespace tactus::report
