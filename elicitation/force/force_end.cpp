#include "elicitation/force/force_end.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/error.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {
namespace {

/// The force that comes most often, the lowest of them on a tie.
double commonForce(std::vector<double> forces_n) {
  std::sort(forces_n.begin(), forces_n.end());
  double best_n = forces_n.front();
  std::size_t most = 0;
  for (std::size_t first = 0; first < forces_n.size();) {
    std::size_t last = first;
    while (last < forces_n.size() && forces_n[last] - forces_n[first] <= kSameForceN) ++last;
    if (last - first > most) {
      most = last - first;
      best_n = forces_n[first];
    }
    first = last;
  }
  return best_n;
}

}  // namespace

std::vector<std::string> stepForceNotes(std::span<const study::ForceJudgement> judgements, std::string_view series) {
  std::map<int, std::vector<double>> forces_n;
  for (const auto& judgement : judgements) {
    if (judgement.series == series) forces_n[judgement.step].push_back(judgement.force_n);
  }
  std::map<int, double> common_n;
  for (const auto& [step, all_n] : forces_n) common_n[step] = commonForce(all_n);

  struct Odd {
    const study::ForceJudgement* first;
    int steps;
  };
  std::vector<Odd> odd;  // one for each participant, in the order of the judgements
  for (const auto& judgement : judgements) {
    if (judgement.series != series || std::abs(judgement.force_n - common_n[judgement.step]) <= kSameForceN) continue;
    const auto known = std::find_if(odd.begin(), odd.end(), [&judgement](const Odd& one) {
      return one.first->participant == judgement.participant;
    });
    if (known != odd.end()) {
      ++known->steps;
    } else {
      odd.push_back({&judgement, 1});
    }
  }

  std::vector<std::string> notes;
  for (const auto& [first, steps] : odd) {
    const std::string line = first->line.number > 0 ? " (" + std::string(study::kJudgementsTable) + ", line " +
                                                          std::to_string(first->line.number) + ")"
                                                    : "";
    notes.push_back("Participant " + first->participant + " judged other forces than most participants in series " +
                    base::quoted(series) + ": step " + std::to_string(first->step) + line + " is at " +
                    base::roundedNumber(first->force_n) + " N, for most at " +
                    base::roundedNumber(common_n[first->step]) + " N" +
                    (steps > 1 ? "; " + std::to_string(steps) + " steps differ in all." : "."));
  }
  return notes;
}

namespace {

constexpr double kMicro = 1e6;  // forces that no step has are rounded to a micronewton

int votesAt(const VoteStep& step) { return std::accumulate(step.votes.begin(), step.votes.end(), 0); }

/// One more than the index of the last step with a term for which `counts` holds; 0 where there is none.
template <class Counts>
std::size_t countTo(std::span<const VoteStep> steps, Counts counts) {
  for (std::size_t i = steps.size(); i > 0; --i) {
    if (steps[i - 1].term && counts(steps[i - 1])) return i;
  }
  return 0;
}

/// The forces at which participants voted although their steps do not count.
std::vector<std::string> leftOut(std::span<const VoteStep> steps) {
  std::vector<std::string> forces;
  for (const auto& step : steps) {
    if (step.term) forces.push_back(base::roundedNumber(step.force_n));
  }
  return forces;
}

/// The median distance of neighboring steps; a single step counts from 0 N.
double usualDistance(std::span<const VoteStep> steps) {
  if (steps.size() == 1) return steps.front().force_n;
  std::vector<double> distances_n;
  for (std::size_t i = 1; i < steps.size(); ++i) distances_n.push_back(steps[i].force_n - steps[i - 1].force_n);
  return base::median(std::move(distances_n));
}

}  // namespace

double ForceEnd::stepsAbove(std::size_t count) const {
  if (count <= later_n.size()) return later_n[count - 1];
  const double highest_n = later_n.empty() ? last_n : later_n.back();
  const double above_n = highest_n + static_cast<double>(count - later_n.size()) * width_n;
  return std::round(above_n * kMicro) / kMicro;
}

base::Result<ForceEnd> forceEnd(std::span<const VoteStep> steps, std::optional<double> given_n) {
  const std::size_t all = countTo(steps, [](const VoteStep&) { return true; });
  if (all == 0 || !(steps[all - 1].force_n > 0)) {
    return base::fail(base::ErrorCode::kData, "vote", all == 0 ? "no decided force" : "decided forces of 0 N alone",
                      "at least one force above 0 N that was judged");
  }
  ForceEnd out;
  out.given_n = given_n;
  out.reason = "the last force that half of the participants judged";
  out.steps = countTo(steps, [](const VoteStep& step) { return !step.below_quorum && step.force_n > 0; });
  if (out.steps == 0) {
    int most = 0;
    for (const auto& step : steps) most = std::max(most, votesAt(step));
    out.steps = countTo(steps, [most](const VoteStep& step) { return 2 * votesAt(step) >= most && step.force_n > 0; });
    if (out.steps == 0) out.steps = all;
    out.reason = "no force was judged by half of the participants, so half of the most votes at a force decides";
    out.notes.push_back(
        "Less than half of the participants judged any force: the forces count up to the last with half "
        "of the most votes at a force.");
  }
  if (given_n) {
    out.steps = std::max(
        out.steps, countTo(steps, [given_n](const VoteStep& step) { return step.force_n <= *given_n + kSameForceN; }));
  }
  out.last_n = steps[out.steps - 1].force_n;
  for (const auto& step : steps.subspan(out.steps)) out.later_n.push_back(step.force_n);
  out.width_n = usualDistance(steps);
  if (const auto forces = leftOut(steps.subspan(out.steps)); !forces.empty()) {
    out.notes.push_back("Vote at " + base::joined(forces, ", ") + " N: above " + base::roundedNumber(out.last_n) +
                        " N, the last force that enough participants judged; these votes shape no term.");
  }
  return out;
}

}  // namespace tactus::elicitation
