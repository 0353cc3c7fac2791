#include "app/session/simulated_traits.h"

#include <algorithm>
#include <functional>
#include <future>
#include <iterator>
#include <string>
#include <utility>

#include "app/session/simulated_answers.h"
#include "app/session/simulated_responder.h"
#include "app/session/simulated_strokes.h"
#include "core/base/check.h"
#include "experiments/published_tables.h"
#include "questionnaires/form_file.h"

namespace tactus::session {
namespace {

constexpr std::uint64_t kCells = 1000;  // of Table 1, more than there are

/// The nurses that `wanted` names. Each level of Table 1 takes a second or less; they are computed at the same time.
std::vector<NurseTraits> nursesOf(std::uint64_t seed, const std::function<bool(std::string_view)>& wanted) {
  const auto table = experiments::publishedSpeeds();
  std::vector<std::future<SimulatedLevel>> levels(table.size());
  for (std::size_t cell = 0; cell < table.size(); ++cell) {
    if (!wanted(table[cell].participant)) continue;
    levels[cell] = std::async(std::launch::async, [target = table[cell], own_seed = seed * kCells + cell] {
      return simulatedLevel(target, own_seed);
    });
  }
  const auto answers = simulatedAnswers(questionnaires::ngtForceForm(), seed);
  std::vector<NurseTraits> nurses;
  for (auto& responder : respondersOfTable2()) {
    if (!wanted(responder.code)) continue;
    NurseTraits nurse;
    nurse.profile.category = "expert";
    nurse.profile.handedness = "right";
    nurse.responder = std::move(responder);
    nurse.responder.noise = 0;
    nurse.responder.lapse = 0;
    const auto& code = nurse.responder.code;
    for (std::size_t cell = 0; cell < table.size(); ++cell) {
      if (table[cell].participant == code) nurse.levels[table[cell].level] = levels[cell].get();
    }
    std::copy_if(answers.begin(), answers.end(), std::back_inserter(nurse.answers),
                 [&](const study::Answer& answer) { return answer.participant == code; });
    nurses.push_back(std::move(nurse));
  }
  return nurses;
}

}  // namespace

std::vector<NurseTraits> simulatedNurses(std::uint64_t seed) {
  return nursesOf(seed, [](std::string_view) { return true; });
}

NurseTraits simulatedNurseCalled(std::string_view code, std::uint64_t seed) {
  auto nurses = nursesOf(seed, [code](std::string_view each) { return each == code; });
  TACTUS_CHECK(nurses.size() == 1);
  return std::move(nurses.front());
}

}  // namespace tactus::session
