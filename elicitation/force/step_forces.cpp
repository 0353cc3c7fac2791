#include "elicitation/force/step_forces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
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

}  // namespace tactus::elicitation
