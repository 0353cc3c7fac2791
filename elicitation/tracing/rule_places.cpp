#include "elicitation/tracing/rule_places.h"

#include <algorithm>
#include <string>

namespace tactus::elicitation {
namespace {

std::optional<std::size_t> expertOf(const BuiltModel& built, const std::string& participant,
                                    ExpertRules::Source source) {
  const auto found = std::find_if(built.experts.begin(), built.experts.end(), [&](const ExpertRules& one) {
    return one.participant.code == participant && one.source == source;
  });
  if (found == built.experts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - built.experts.begin());
}

}  // namespace

std::optional<RulePlace> ruleOfAnswer(const study::Study& study, const BuiltModel& built, std::size_t index) {
  const study::Answer& answer = study.answers[index];
  const auto expert = expertOf(built, answer.participant, ExpertRules::Source::kAnswers);
  if (!expert) return std::nullopt;
  const auto& origins = built.experts[*expert].origins;
  const auto found = std::find_if(origins.begin(), origins.end(), [&](const RuleOrigin& one) {
    return one.form == answer.form && one.item == answer.item;
  });
  if (found == origins.end()) return std::nullopt;
  return RulePlace{*expert, static_cast<std::size_t>(found - origins.begin())};
}

std::optional<RulePlace> ruleOfGiven(const study::Study& study, const BuiltModel& built, std::size_t index) {
  const std::string& participant = study.rules[index].participant;
  const auto expert = expertOf(built, participant, ExpertRules::Source::kGiven);
  if (!expert) return std::nullopt;
  // The rules of a participant keep the order of the table.
  const auto before = std::count_if(study.rules.begin(), study.rules.begin() + static_cast<std::ptrdiff_t>(index),
                                    [&](const study::GivenRule& one) { return one.participant == participant; });
  return RulePlace{*expert, static_cast<std::size_t>(before)};
}

}  // namespace tactus::elicitation
