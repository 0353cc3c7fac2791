#include "elicitation/force/force_terms_from.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/study/ordered_probit.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_frequency.h"
#include "elicitation/force/force_term_parts.h"
#include "elicitation/force/force_thresholds.h"

namespace tactus::elicitation {
namespace {

using study::ForceJudgement;
using study::TermAtForce;

bool counts(double force_n, const ForceEnd& end) { return force_n <= end.last_n + kSameForceN; }

std::vector<TermAtForce> votesOf(std::span<const VoteStep> steps, const ForceEnd& end) {
  std::vector<TermAtForce> out;
  for (const auto& step : steps) {
    if (!counts(step.force_n, end)) continue;
    for (std::size_t term = 0; term < step.votes.size(); ++term) {
      if (step.votes[term] > 0) out.push_back({step.force_n, term, static_cast<double>(step.votes[term])});
    }
  }
  return out;
}

/// "Not felt" and "beyond practice" are no votes, but they say on which side of all thresholds the force is.
void addOutside(std::span<const ForceJudgement> judgements, std::string_view series, const ForceEnd& end,
                std::size_t terms, std::vector<TermAtForce>& out) {
  std::set<std::string_view> with_term;
  for (const auto& one : judgements) {
    if (one.series == series && one.kind == ForceJudgement::Kind::kTerm && counts(one.force_n, end)) {
      with_term.insert(one.participant);
    }
  }
  for (const auto& one : judgements) {
    if (one.series != series || !counts(one.force_n, end) || !with_term.contains(one.participant)) continue;
    if (one.kind == ForceJudgement::Kind::kNotFelt) out.push_back({one.force_n, 0});
    if (one.kind == ForceJudgement::Kind::kBeyondPractice) out.push_back({one.force_n, terms - 1});
  }
}

/// The fitted thresholds, ascending and not more than half a step outside the judged forces. Returns how many were
/// outside.
std::size_t setThresholds(const study::TermThresholds& fit, std::span<const TermAtForce> answers, double half_n,
                          ProbitTerms& out) {
  const auto [low, high] = std::minmax_element(answers.begin(), answers.end(),
                                               [](const auto& a, const auto& b) { return a.force_n < b.force_n; });
  const double first_n = std::max(0.0, low->force_n - half_n);
  const double last_n = high->force_n + half_n;
  const std::size_t lowest = std::min_element(answers.begin(), answers.end(), [](const auto& a, const auto& b) {
                               return a.term < b.term;
                             })->term;
  std::size_t outside = 0;
  double before_n = first_n;
  for (std::size_t k = 0; k < fit.threshold_n.size(); ++k) {
    const double found_n = fit.threshold_n[k].value_or(k < lowest ? first_n : last_n);
    if (!fit.threshold_n[k] || found_n < first_n || found_n > last_n) ++outside;
    before_n = std::clamp(toMicronewton(found_n), before_n, last_n);
    out.threshold_n.push_back(before_n);
  }
  return outside;
}

std::string midpointNote(const std::vector<double>& threshold_n) {
  std::vector<std::string> places;
  for (const double one : threshold_n) places.push_back(base::roundedNumber(one));
  return "Ordered probit: the answers of neighboring terms do not overlap in force, or the terms fall while it rises. "
         "The "
         "likelihood has no maximum then; the terms change in the middle between the forces, at " +
         base::joined(places, ", ") + " N.";
}

}  // namespace

base::Result<ProbitTerms> probitTerms(const fuzzy::Variable& output, std::span<const ForceJudgement> judgements,
                                      std::string_view series, std::span<const VoteStep> steps,
                                      std::optional<double> end_n) {
  TACTUS_TRY(const auto end, forceEnd(steps, end_n));
  ProbitTerms out;
  static_cast<ForceTerms&>(out) = emptyForceTerms(output, end);
  if (output.terms.size() < 2) {
    placeBetween(output, {}, out);
    return out;
  }
  auto answers = votesOf(steps, end);
  addOutside(judgements, series, end, output.terms.size(), answers);
  for (const auto& one : answers) out.answers += one.count;
  const auto fit = study::termThresholds(answers, output.terms.size());
  out.sigma_n = fit.sigma_n;
  const double half_n = end.width_n / 2;
  const std::size_t outside = setThresholds(fit, answers, half_n, out);

  const double side_n = std::max(half_n, std::numbers::sqrt3 * fit.sigma_n.value_or(0));
  const double last_side_n = std::min(side_n, std::max(half_n, end.last_n - out.threshold_n.back()));
  const auto ramps = rampsAround(out.threshold_n, side_n, last_side_n);
  if (ramps.back().end_n > end.last_n) endAbove(out, end, 1, ramps.back().end_n);
  placeBetween(output, ramps, out);
  if (!out.sigma_n) out.notes.push_back(midpointNote(out.threshold_n));
  if (outside > 0) {
    out.notes.push_back("Of " + std::to_string(out.threshold_n.size()) + " thresholds of the force " +
                        std::to_string(outside) + (outside == 1 ? " lies" : " lie") +
                        " outside the forces that count; half a step beyond these is taken.");
  }
  return out;
}

base::Result<ForceTerms> forceTermsFrom(ForceTermsFrom from, const fuzzy::Variable& output,
                                        std::span<const study::ForceJudgement> judgements, std::string_view series,
                                        std::span<const VoteStep> steps, std::optional<double> end_n) {
  switch (from) {
    case ForceTermsFrom::kVote: return forceTerms(output, steps, end_n);
    case ForceTermsFrom::kFrequency: return frequencyTerms(output, steps, end_n);
    case ForceTermsFrom::kThresholds: return thresholdTerms(output, judgements, series, steps, end_n);
    case ForceTermsFrom::kProbit: return probitTerms(output, judgements, series, steps, end_n);
  }
  TACTUS_CHECK(false);
}

}  // namespace tactus::elicitation
