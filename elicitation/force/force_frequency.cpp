#include "elicitation/force/force_frequency.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/check.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_frequency_fit.h"
#include "elicitation/force/force_term_parts.h"

namespace tactus::elicitation {
namespace {

FrequencyStep stepOf(const VoteStep& counts) {
  FrequencyStep step{counts.force_n, std::accumulate(counts.votes.begin(), counts.votes.end(), 0), {}};
  if (step.votes == 0) return step;
  for (const int votes : counts.votes) step.shares.push_back(static_cast<double>(votes) / step.votes);
  return step;
}

double rmsError(const fuzzy::Variable& output, std::span<const FrequencyPoint> points, const ForceTerms& fitted) {
  double squares = 0;
  double answers = 0;
  for (const auto& point : points) {
    answers += point.weight;
    for (std::size_t k = 0; k < output.terms.size(); ++k) {
      const auto* term = fuzzy::findTerm(fitted.output.terms, output.terms[k].id);
      const double membership = term == nullptr ? 0 : fuzzy::MembershipFunction::of(*term)(point.force_n);
      squares += point.weight * std::pow(membership - point.shares[k], 2);
    }
  }
  return std::sqrt(squares / (answers * static_cast<double>(output.terms.size())));
}

bool isChosen(std::span<const FrequencyPoint> points, std::size_t term) {
  return std::any_of(points.begin(), points.end(),
                     [term](const FrequencyPoint& point) { return point.shares[term] > 0; });
}

/// The ramps up to the highest term that was chosen from the fit, those above it a step wide each.
std::vector<TermRamp> allRamps(std::vector<FrequencyPoint> points, const ForceEnd& end, std::size_t highest,
                               std::size_t terms) {
  for (auto& point : points) point.shares.resize(highest + 1);
  auto ramps = fitRamps(points, 0, end.last_n);
  double begin_n = end.last_n;
  for (std::size_t k = highest + 1; k < terms; ++k) {
    const double next_n = end.stepsAbove(k - highest);
    ramps.push_back({begin_n, next_n});
    begin_n = next_n;
  }
  return ramps;
}

}  // namespace

base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                            std::optional<double> end_n) {
  const auto end = forceEnd(steps, end_n);
  if (!end) return tl::unexpected(end.error());
  FrequencyTerms out;
  static_cast<ForceTerms&>(out) = emptyForceTerms(output, *end);
  std::vector<FrequencyPoint> points;
  for (const auto& one : steps) {
    TACTUS_CHECK(one.votes.size() == output.terms.size());
    out.steps.push_back(stepOf(one));
    const auto& step = out.steps.back();
    if (step.votes > 0 && out.steps.size() <= end->steps) {
      points.push_back({step.force_n, static_cast<double>(step.votes), step.shares});
    }
  }

  const std::size_t terms = output.terms.size();
  std::size_t highest = terms - 1;
  while (!isChosen(points, highest)) --highest;
  const auto ramps = allRamps(points, *end, highest, terms);
  if (highest + 1 < terms) endAbove(out, *end, terms - 1 - highest, ramps.back().end_n);
  placeBetween(output, ramps, out);
  for (std::size_t k = 0; k < terms; ++k) {
    if (isChosen(points, k)) continue;
    const auto* term = fuzzy::findTerm(out.output.terms, output.terms[k].id);
    if (term != nullptr) addInterpolated(out, *term, *end, (term->points[1] + term->points[2]) / 2);
  }
  out.rms_error = rmsError(output, points, out);
  return out;
}

}  // namespace tactus::elicitation
