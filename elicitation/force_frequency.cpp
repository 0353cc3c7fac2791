#include "elicitation/force_frequency.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force_frequency_fit.h"
#include "elicitation/ratings.h"

namespace tactus::elicitation {
namespace {

FrequencyStep stepOf(const VoteCounts& counts) {
  FrequencyStep step{counts.force_n, static_cast<int>(ratingsOf(counts.votes)), {}};
  if (step.votes == 0) return step;
  for (const int votes : counts.votes) step.shares.push_back(static_cast<double>(votes) / step.votes);
  return step;
}

/// Puts the terms between the ramps; a term without width does not exist.
void placeTerms(const fuzzy::Variable& output, const std::vector<TermRamp>& ramps, FrequencyTerms& out) {
  const std::size_t terms = output.terms.size();
  for (std::size_t k = 0; k < terms; ++k) {
    fuzzy::Term term = output.terms[k];
    const TermRamp rise = k == 0 ? TermRamp{out.output.min, out.output.min} : ramps[k - 1];
    const TermRamp fall = k + 1 == terms ? TermRamp{out.output.max, out.output.max} : ramps[k];
    if (!(rise.begin_n < fall.end_n)) {
      out.absent.push_back(term.id);
      continue;
    }
    const bool chosen = std::any_of(out.steps.begin(), out.steps.end(),
                                    [k](const FrequencyStep& step) { return step.votes > 0 && step.shares[k] > 0; });
    if (!chosen) out.interpolated.push_back(term.id);
    term.shape = fuzzy::Shape::kTrapezoid;
    term.points = {rise.begin_n, rise.end_n, fall.begin_n, fall.end_n};
    out.output.terms.push_back(std::move(term));
  }
}

double rmsError(const fuzzy::Variable& output, const FrequencyTerms& fitted) {
  double squares = 0;
  double answers = 0;
  for (const auto& step : fitted.steps) {
    if (step.votes == 0) continue;
    answers += step.votes;
    for (std::size_t k = 0; k < output.terms.size(); ++k) {
      const auto* term = fuzzy::findTerm(fitted.output.terms, output.terms[k].id);
      const double membership = term == nullptr ? 0 : fuzzy::MembershipFunction::of(*term)(step.force_n);
      squares += step.votes * std::pow(membership - step.shares[k], 2);
    }
  }
  return std::sqrt(squares / (answers * static_cast<double>(output.terms.size())));
}

}  // namespace

base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteCounts> counts) {
  FrequencyTerms out;
  std::vector<FrequencyPoint> points;
  for (const auto& one : counts) {
    TACTUS_CHECK(one.votes.size() == output.terms.size());
    out.steps.push_back(stepOf(one));
    const auto& step = out.steps.back();
    if (step.votes > 0) points.push_back({step.force_n, static_cast<double>(step.votes), step.shares});
  }
  if (points.empty() || !(points.back().force_n > 0)) {
    return base::fail(base::ErrorCode::kData, "vote", points.empty() ? "no votes" : "votes at 0 N alone",
                      "votes at one force above 0 N at least");
  }
  out.output = output;
  out.output.min = 0;
  out.output.max = points.back().force_n;
  out.output.terms.clear();
  placeTerms(output, fitRamps(points, out.output.min, out.output.max), out);
  out.rms_error = rmsError(output, out);
  return out;
}

}  // namespace tactus::elicitation
