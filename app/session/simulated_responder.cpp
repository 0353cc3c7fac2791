#include "app/session/simulated_responder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/simulated_judgements.h"
#include "core/base/check.h"
#include "experiments/published_tables.h"

namespace tactus::session {
namespace {

using JudgementKind = study::ForceJudgement::Kind;

constexpr double kAbsoluteN = 0.04;
constexpr double kWeber = 0.12;

/// The middle between the last force of the terms up to `term` and the first force of the higher ones, in one
/// participant's ascending series.
double thresholdAfter(std::size_t term, const std::string& code, const std::vector<std::string>& terms) {
  double last_n = 0;
  for (const auto& judgement : simulatedJudgements()) {
    if (judgement.participant != code || judgement.kind != JudgementKind::kTerm) continue;
    const auto place = static_cast<std::size_t>(std::find(terms.begin(), terms.end(), judgement.term) - terms.begin());
    if (place > term) return (last_n + judgement.force_n) / 2;
    last_n = judgement.force_n;
  }
  return last_n;
}

}  // namespace

double justNoticeableN(double force_n) { return std::hypot(kAbsoluteN, kWeber * force_n); }

std::vector<ResponderTraits> respondersOfTable2() {
  const auto terms = experiments::publishedVoteTerms();
  std::vector<ResponderTraits> responders;
  for (const auto& judgement : simulatedJudgements()) {
    const bool known = std::any_of(responders.begin(), responders.end(), [&](const ResponderTraits& responder) {
      return responder.code == judgement.participant;
    });
    if (known) continue;
    ResponderTraits traits;
    traits.code = judgement.participant;
    for (std::size_t term = 0; term + 1 < terms.size(); ++term) {
      traits.threshold_n.push_back(thresholdAfter(term, traits.code, terms));
    }
    responders.push_back(std::move(traits));
  }
  return responders;
}

SimulatedResponder::SimulatedResponder(ResponderTraits traits, std::vector<std::string> terms)
    : traits_(std::move(traits)), terms_(std::move(terms)) {
  TACTUS_CHECK(terms_.size() == traits_.threshold_n.size() + 1);
  TACTUS_CHECK(std::is_sorted(traits_.threshold_n.begin(), traits_.threshold_n.end()));
}

Response SimulatedResponder::judge(double felt_n, base::Random& random) {
  // The same random numbers are drawn for each judgement, whatever the traits: one trait changes nothing else.
  const double noise = random.normal();
  const bool lapses = random.uniform() < traits_.lapse;
  const auto random_term = static_cast<std::size_t>(random.below(static_cast<int>(terms_.size())));

  double percept_n = felt_n + traits_.noise * noise * justNoticeableN(felt_n);
  if (before_n_) percept_n += traits_.assimilation * (*before_n_ - percept_n);
  before_n_ = percept_n;

  Response response{JudgementKind::kTerm, {}, percept_n};
  if (lapses) {
    response.term = terms_[random_term];
  } else if (percept_n < traits_.felt_from_n) {
    response.kind = JudgementKind::kNotFelt;
  } else if (percept_n >= traits_.beyond_from_n) {
    response.kind = JudgementKind::kBeyondPractice;
  } else {
    const auto above = std::upper_bound(traits_.threshold_n.begin(), traits_.threshold_n.end(), percept_n);
    response.term = terms_[static_cast<std::size_t>(above - traits_.threshold_n.begin())];
  }
  return response;
}

}  // namespace tactus::session
