// Judgements of one participant as letters, for the tests of the words of the force.
#pragma once

#include <string>
#include <vector>

#include "core/study/records.h"

#include "tests/support/default_procedure.h"

namespace tactus::elicitation {

/// One letter for each answer from 0.1 N on, 0.1 N apart: v s m l V for the terms, b beyond, n not felt, . no answer.
inline void judge(std::vector<study::ForceJudgement>& out, const std::string& who, const std::string& answers) {
  using Kind = study::ForceJudgement::Kind;
  const std::string letters = "vsmlV";
  for (std::size_t i = 0; i < answers.size(); ++i) {
    study::ForceJudgement one;
    one.participant = who;
    one.series = "ascending";
    one.step = static_cast<int>(i) + 1;
    one.force_n = static_cast<double>(i + 1) / 10;
    const auto term = letters.find(answers[i]);
    one.kind = answers[i] == 'b' ? Kind::kBeyondPractice : answers[i] == 'n' ? Kind::kNotFelt : Kind::kNoAnswer;
    if (term != std::string::npos) {
      one.kind = Kind::kTerm;
      one.term = support::ngtOutput().terms[term].id;
    }
    out.push_back(one);
  }
}

}  // namespace tactus::elicitation
