#include "elicitation/force/force_thresholds.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_term_parts.h"

namespace tactus::elicitation {
namespace {

using study::ForceJudgement;

/// A judged force and its place on the scale: 0 for "not felt", k + 1 for term k, one more than all terms for "beyond".
struct Answer {
  double force_n;
  std::size_t place;
};

/// One participant's answers, ascending in force.
struct Answers {
  std::string participant;
  std::vector<Answer> list;
  bool has_term = false;
};

std::optional<std::size_t> placeOf(const ForceJudgement& judgement, const std::vector<fuzzy::Term>& terms) {
  switch (judgement.kind) {
    case ForceJudgement::Kind::kNotFelt: return 0;
    case ForceJudgement::Kind::kBeyondPractice: return terms.size() + 1;
    case ForceJudgement::Kind::kNoAnswer: return std::nullopt;
    case ForceJudgement::Kind::kTerm: break;
  }
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const fuzzy::Term& term) { return term.id == judgement.term; });
  TACTUS_CHECK(found != terms.end());
  return static_cast<std::size_t>(found - terms.begin()) + 1;
}

std::vector<Answers> answersOf(std::span<const ForceJudgement> judgements, std::string_view series,
                               const std::vector<fuzzy::Term>& terms, double last_n) {
  std::vector<Answers> people;
  for (const auto& judgement : judgements) {
    if (judgement.series != series || judgement.force_n > last_n + kSameForceN) continue;
    const auto place = placeOf(judgement, terms);
    if (!place) continue;
    auto who = std::find_if(people.begin(), people.end(),
                            [&judgement](const Answers& one) { return one.participant == judgement.participant; });
    if (who == people.end()) who = people.insert(people.end(), {judgement.participant, {}, false});
    who->list.push_back({judgement.force_n, *place});
    who->has_term = who->has_term || judgement.kind == ForceJudgement::Kind::kTerm;
  }
  std::erase_if(people, [](const Answers& one) { return !one.has_term; });
  for (auto& one : people) {
    std::stable_sort(one.list.begin(), one.list.end(),
                     [](const Answer& a, const Answer& b) { return a.force_n < b.force_n; });
  }
  return people;
}

/// The thresholds of one participant; the lowest and the highest force stand for `half_n` beyond.
ForceThresholds thresholdsOf(const Answers& answers, std::size_t terms, double half_n) {
  const auto& list = answers.list;
  const double first_n = std::max(0.0, list.front().force_n - half_n);
  ForceThresholds out{answers.participant, {}, 0};
  for (std::size_t k = 0; k + 1 < terms; ++k) {
    double threshold_n = first_n;
    std::size_t below = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].place > k + 1) continue;
      ++below;
      const double from_n = i == 0 ? first_n : (list[i - 1].force_n + list[i].force_n) / 2;
      const double to_n = i + 1 == list.size() ? list[i].force_n + half_n : (list[i].force_n + list[i + 1].force_n) / 2;
      threshold_n += to_n - from_n;
    }
    if (below == 0 || below == list.size()) ++out.outside;
    out.threshold_n.push_back(threshold_n);
  }
  return out;
}

std::vector<double> meanThresholds(const std::vector<ForceThresholds>& participants, std::size_t count) {
  std::vector<double> mean_n(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (const auto& one : participants) mean_n[k] += one.threshold_n[k];
    mean_n[k] = toMicronewton(mean_n[k] / static_cast<double>(participants.size()));
  }
  return mean_n;
}

std::string outsideNote(const std::vector<ForceThresholds>& participants) {
  int outside = 0;
  int all = 0;
  for (const auto& one : participants) {
    outside += one.outside;
    all += static_cast<int>(one.threshold_n.size());
  }
  if (outside == 0) return {};
  return "Of " + std::to_string(all) + " thresholds of the force " + std::to_string(outside) +
         (outside == 1 ? " lies" : " lie") +
         " outside the forces that count and that the participant judged; half a step beyond these is taken.";
}

}  // namespace

base::Result<ThresholdTerms> thresholdTerms(const fuzzy::Variable& output, std::span<const ForceJudgement> judgements,
                                            std::string_view series, std::span<const VoteStep> steps,
                                            std::optional<double> end_n) {
  TACTUS_TRY(const auto end, forceEnd(steps, end_n));
  ThresholdTerms out;
  static_cast<ForceTerms&>(out) = emptyForceTerms(output, end);
  const std::size_t terms = output.terms.size();
  const double half_n = end.width_n / 2;
  for (const auto& answers : answersOf(judgements, series, output.terms, end.last_n)) {
    out.participants.push_back(thresholdsOf(answers, terms, half_n));
  }
  TACTUS_CHECK(!out.participants.empty());
  out.mean_n = meanThresholds(out.participants, terms - 1);
  const auto ramps = rampsAround(out.mean_n, half_n, half_n);
  if (!ramps.empty() && ramps.back().end_n > end.last_n) endAbove(out, end, 1, ramps.back().end_n);
  placeBetween(output, ramps, out);
  if (auto note = outsideNote(out.participants); !note.empty()) out.notes.push_back(std::move(note));
  return out;
}

}  // namespace tactus::elicitation
