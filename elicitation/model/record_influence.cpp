#include "elicitation/model/record_influence.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "elicitation/force/force_terms_from.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::elicitation {
namespace {

using base::Result;

Result<RecordInfluence> compared(const fuzzy::ForceModel& with, const fuzzy::ForceModel& without) {
  const auto first = fuzzy::compile(with);
  if (!first) return tl::unexpected(first.error());
  const auto second = fuzzy::compile(without);
  if (!second) return tl::unexpected(second.error());
  RecordInfluence out;
  out.difference = analysis::forceDifference(with, *first, without, *second);
  if (out.difference.largest_n > 0) {
    out.noticeable = out.difference.largest_n / justNoticeableDifference(out.difference.first_n);
  }
  return out;
}

}  // namespace

Result<RecordInfluence> withoutJudgement(const BuiltModel& built, const study::Study& study,
                                         const BuildSettings& settings, std::size_t index) {
  if (study.judgements[index].series != settings.series) return RecordInfluence();
  std::vector<study::ForceJudgement> rest = study.judgements;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(index));
  const fuzzy::Variable words = ngtOutput();
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : words.terms) ids.push_back(term.id);
  const auto counts = countVotes(rest, settings.series, ids);
  if (!counts) return tl::unexpected(counts.error());
  const auto votes = vote(*counts, static_cast<int>(study.participants.size()));
  const auto terms = forceTermsFrom(settings.force_terms, words, rest, settings.series, votes, settings.force_end_n);
  if (!terms) return tl::unexpected(terms.error());
  fuzzy::ForceModel without = built.model;
  without.output = terms->output;
  return compared(built.model, without);
}

Result<RecordInfluence> withoutRule(const BuiltModel& built, std::size_t expert, std::size_t rule) {
  fuzzy::ForceModel without = built.model;
  auto& rules = without.experts[expert].rules;
  rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(rule));
  return compared(built.model, without);
}

Result<RecordInfluence> withoutStroke(const BuiltModel& built, const study::Study& study, const BuildSettings& settings,
                                      std::string_view participant, std::string_view level, int stroke) {
  study::Study own;
  for (const auto& one : study.participants) {
    if (one.code == participant) own.participants.push_back(one);
  }
  bool found = false;
  for (const auto& sample : study.speeds) {
    if (sample.participant != participant) continue;
    const bool left_out = sample.level == level && sample.stroke == stroke;
    found = found || left_out;
    if (!left_out) own.speeds.push_back(sample);
  }
  const auto who = std::find_if(built.speeds.begin(), built.speeds.end(),
                                [&](const auto& one) { return one.participant == participant; });
  if (!found || who == built.speeds.end()) {
    return base::fail(base::ErrorCode::kReference, "stroke",
                      std::string(participant) + ", " + std::string(level) + " " + std::to_string(stroke),
                      "a stroke of the study");
  }
  const auto defaults = ngtInputs();
  const auto speed =
      std::find_if(defaults.begin(), defaults.end(), [](const auto& input) { return input.id == "speed"; });
  auto again = clusterSpeeds(own, *speed, settings.speed);
  if (!again) return tl::unexpected(again.error());
  auto speeds = built.speeds;
  auto weights = built.speed_weights;
  const auto index = who - built.speeds.begin();
  if (again->empty()) {
    speeds.erase(speeds.begin() + index);
    if (!weights.empty()) weights.erase(weights.begin() + index);
  } else {
    speeds[static_cast<std::size_t>(index)] = again->front();
  }
  if (speeds.empty()) {
    return base::fail(base::ErrorCode::kData, "strokes", "none without this one",
                      "a stroke of at least one participant");
  }
  std::vector<std::vector<Ramp>> ramps;
  for (const auto& one : speeds) ramps.push_back(one.ramps);
  fuzzy::ForceModel without = built.model;
  auto& changed = *std::find_if(without.inputs.begin(), without.inputs.end(),
                                [](const auto& input) { return input.id == "speed"; });
  changed = averagedSpeed(*speed, speeds, averageRamps(ramps, weights, settings.averaging));
  for (auto& expert : without.experts) {
    if (expert.id != participant) continue;
    std::erase_if(expert.overrides, [&](const auto& list) { return again->empty() && list.variable == changed.id; });
    for (auto& list : expert.overrides) {
      if (list.variable == changed.id) list.terms = speedTerms(changed, again->front().ramps);
    }
  }
  return compared(built.model, without);
}

}  // namespace tactus::elicitation
