#include "app/session/simulated_study.h"

#include "app/session/simulated_answers.h"
#include "app/session/simulated_judgements.h"
#include "app/session/simulated_strokes.h"
#include "experiments/published_tables.h"
#include "questionnaires/form_file.h"

namespace tactus::session {

base::Result<study::Study> simulatedNgtStudy(std::uint64_t seed, std::string_view reading) {
  auto rules = questionnaires::s4Rules(reading);
  if (!rules) return tl::unexpected(rules.error());

  study::Study study;
  study.name = "NGT insertion, four nurses (simulated, except the rules of S4)";
  for (const char* code : {"S1", "S2", "S3", "S4"}) {
    study.participants.push_back({code, std::nullopt, "expert", "right", std::nullopt, true});
  }
  study.speeds = simulatedStrokes(experiments::publishedSpeeds(), seed);
  study.judgements = simulatedJudgements();
  study.answers = simulatedAnswers(questionnaires::ngtForceForm(), seed);
  study.rules = std::move(*rules);
  return study;
}

}  // namespace tactus::session
