// Four participants: the judgements that Table 2 splits into, paired with the rules of three invented experts and S4.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/study/records.h"

#include "tests/support/default_procedure.h"
#include "tests/support/invented_experts.h"

namespace tactus::elicitation {

inline study::Study fourPeople() {
  study::Study study;
  study.name = "four";
  const std::vector<std::pair<std::string, std::string>> judged = {
      {"E1", "SMLVVVVVVVV"}, {"E2", "vSMMLLLVVVV"}, {"E3", "vvSSMMLLLVV"}, {"S4", "vvvSMMMMLLV"}};
  const std::string letters = "vSMLV";  // very small to very large
  for (const auto& [code, words] : judged) {
    study::Participant one;
    one.code = code;
    study.participants.push_back(one);
    for (std::size_t i = 0; i < words.size(); ++i) {
      study::ForceJudgement judgement;
      judgement.participant = code;
      judgement.series = "ascending";
      judgement.step = static_cast<int>(i) + 1;
      judgement.force_n = static_cast<double>(i + 1) / 10;
      judgement.kind = study::ForceJudgement::Kind::kTerm;
      judgement.term = support::ngtOutput().terms[letters.find(words[i])].id;
      study.judgements.push_back(judgement);
    }
  }
  for (const auto& expert : support::inventedExperts().experts) {
    for (const auto& rule : expert.rules) {
      study::GivenRule given;
      given.participant = expert.id;
      for (const auto& condition : rule.conditions) given.conditions.push_back({condition.input, condition.term});
      given.then = rule.then;
      study.rules.push_back(given);
    }
  }
  return study;
}

}  // namespace tactus::elicitation
