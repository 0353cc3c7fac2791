#include "app/session/simulated_judgements.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/base/check.h"
#include "experiments/published_tables.h"

namespace tactus::session {
namespace {

constexpr std::array kParticipants = {"S1", "S2", "S3", "S4"};
constexpr int kSteps = 17;  // paper, Section 3.1.5: 0.1 N to 1.7 N in steps of 0.1 N

/// The terms that were chosen in one row, one for each vote, from the largest to the least.
std::vector<std::string> chosenTerms(const experiments::PublishedVotes& row, const std::vector<std::string>& terms) {
  std::vector<std::string> chosen;
  for (std::size_t term = terms.size(); term-- > 0;) {
    chosen.insert(chosen.end(), static_cast<std::size_t>(row.votes[term]), terms[term]);
  }
  TACTUS_CHECK(chosen.size() == kParticipants.size());
  return chosen;
}

}  // namespace

std::vector<study::ForceJudgement> simulatedJudgements() {
  using Kind = study::ForceJudgement::Kind;
  const auto terms = experiments::publishedVoteTerms();
  const auto table = experiments::publishedVotes();
  std::vector<study::ForceJudgement> judgements;
  for (std::size_t person = 0; person < kParticipants.size(); ++person) {
    for (int step = 1; step <= kSteps; ++step) {
      study::ForceJudgement judgement{kParticipants[person], "ascending", step, step / 10.0, Kind::kBeyondPractice, {}};
      if (static_cast<std::size_t>(step) <= table.size()) {
        judgement.kind = Kind::kTerm;
        judgement.term = chosenTerms(table[static_cast<std::size_t>(step) - 1], terms)[person];
      }
      judgements.push_back(std::move(judgement));
    }
  }
  return judgements;
}

}  // namespace tactus::session
