// A form like Table A1 and studies of it, for tests about rules.
#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/study/records.h"

namespace tactus::elicitation {

/// Five regions (no stomach) times the three terms of lubrication, neck flexion and speed: 45 items, numbered from 1,
/// the regions of one condition in a row. Item 1 is poor lubrication in the nasal cavity.
inline study::Form form45() {
  study::Form form;
  form.id = "form45";
  form.depth_terms = "form_a1";
  const std::vector<study::ItemCondition> conditions = {
      {"lubrication", "poor"},   {"lubrication", "medium"},  {"lubrication", "well"},
      {"neck_flexion", "small"}, {"neck_flexion", "medium"}, {"neck_flexion", "large"},
      {"speed", "slow"},         {"speed", "medium"},        {"speed", "fast"}};
  int number = 0;
  for (const auto& condition : conditions) {
    for (const char* region : {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"}) {
      form.items.push_back({++number, "", {condition, {"depth", region}}});
    }
  }
  return form;
}

inline const std::vector<std::string>& forceTermIds() {
  static const std::vector<std::string> kIds = {"very_small", "small", "medium", "large", "very_large"};
  return kIds;
}

/// Answers of one participant to form45, all with the same term, lines from `first_line`.
inline void answerAll(study::Study& study, const std::string& who, const std::string& term, int first_line = 2) {
  study::Participant participant;
  participant.code = who;
  study.participants.push_back(participant);
  for (int item = 1; item <= 45; ++item) {
    study.answers.push_back({who,
                             "form45",
                             item,
                             term,
                             study::Answer::Status::kAnswered,
                             {static_cast<std::uint32_t>(first_line + item - 1)}});
  }
}

/// The answer of `who` to `item`.
inline study::Answer& answerOf(study::Study& study, const std::string& who, int item) {
  for (auto& answer : study.answers) {
    if (answer.participant == who && answer.item == item) return answer;
  }
  return study.answers.front();
}

/// Two to four experts who answer at random and leave a share of the items out, in each of the ways there are.
inline study::Study randomStudy(std::uint64_t seed) {
  base::Random random(seed);
  study::Study study;
  const int experts = 2 + random.below(3);
  const double missing = random.uniform(0, 0.7);
  std::uint32_t line = 2;
  for (int e = 0; e < experts; ++e) {
    study::Participant participant;
    participant.code = "P" + std::to_string(e + 1);
    participant.years_experience = 1 + random.below(30);
    study.participants.push_back(participant);
    for (int item = 1; item <= 45; ++item) {
      using Status = study::Answer::Status;
      if (item > 1 && random.uniform() < missing) {
        const int way = random.below(4);
        if (way == 0) continue;
        const Status status = way == 1 ? Status::kSkipped : way == 2 ? Status::kCantTell : Status::kCleared;
        study.answers.push_back({participant.code, "form45", item, "", status, {line++}});
      } else {
        const auto term = forceTermIds()[static_cast<std::size_t>(random.below(5))];
        study.answers.push_back({participant.code, "form45", item, term, Status::kAnswered, {line++}});
      }
    }
  }
  return study;
}

}  // namespace tactus::elicitation
