#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/session/simulated_study.h"
#include "core/base/random.h"
#include "core/procedure/procedure.h"

namespace tactus::session {
namespace {

using procedure::Procedure;

// What simulated strokes can be: the speeds of Table 1, from which slower ones are stretched in time.
constexpr double kSlowestMmS = 30;
constexpr double kFastestMmS = 300;
constexpr double kOwnWords = 0.4;          // standard deviation of an answer, in words
constexpr double kLessOnTheWayOut = 0.8;   // words, an assumption
constexpr double kSpreadOfStrokes = 0.35;  // standard deviation as a share of the mean, the middle of Table 1

/// Where the word `k` of `terms` passes into the next one.
double boundaryAfter(const std::vector<fuzzy::Term>& terms, std::size_t k) {
  return (terms[k].points[2] + terms[k + 1].points[1]) / 2;
}

/// A value that everybody would call by the word: the middle of its core, of an open end a third beyond its beginning.
double typicalOf(const fuzzy::Variable& input, std::size_t k) {
  const auto& points = input.terms[k].points;
  if (points[2] >= input.max) return std::min(input.max, points[1] * 4 / 3);
  if (points[1] <= input.min) return input.min + (points[2] - input.min) * 2 / 3;
  return (points[1] + points[2]) / 2;
}

SimulatedLevel levelAt(const std::string& level, double mean_mm_s, std::uint64_t seed) {
  const double made_mm_s = std::clamp(mean_mm_s, kSlowestMmS, kFastestMmS);
  auto out = simulatedLevel({{}, level, made_mm_s, kSpreadOfStrokes * made_mm_s}, seed);
  const double stretch = std::max(1.0, made_mm_s / mean_mm_s);
  const auto slow = [stretch](Recording& recording) {
    for (double& time : recording.time_s) time *= stretch;
  };
  for (auto* const recordings : {&out.strokes, &out.practice})
    std::for_each(recordings->begin(), recordings->end(), slow);
  slow(out.too_short);
  return out;
}

/// How much each condition moves the answer, in words; for all experts alike.
std::map<std::string, std::vector<double>> effectsOf(const Procedure& procedure, double words, base::Random& random) {
  constexpr double kDeclared = 0.22;  // of all words, from the middle to an end
  constexpr double kNotDeclared = 0.08;
  std::map<std::string, std::vector<double>> out;
  for (std::size_t i = 0; i < procedure.inputs.size(); ++i) {
    const fuzzy::Variable& input = procedure.inputs[i];
    auto& effects = out[input.id];
    const auto direction = procedure.input_notes[i].direction;
    const double sign = direction == procedure::Direction::kFalls   ? -kDeclared
                        : direction == procedure::Direction::kRises ? kDeclared
                                                                    : random.uniform(-kNotDeclared, kNotDeclared);
    const auto& terms = input.terms;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const double place =
          terms.size() < 2 ? 0 : 2 * static_cast<double>(k) / static_cast<double>(terms.size() - 1) - 1;
      effects.push_back(i == procedure.way() ? random.uniform(0.25, 0.75) * words : sign * words * place);
    }
  }
  return out;
}

}  // namespace

std::vector<double> typicalSpeeds(const Procedure& procedure) {
  std::vector<double> out;
  const auto* const rate = procedure.rateInput();
  for (std::size_t k = 0; rate != nullptr && k < rate->terms.size(); ++k) out.push_back(typicalOf(*rate, k));
  return out;
}

NurseTraits simulatedExpert(const Procedure& procedure, const study::Form& form, std::uint64_t seed, double spread) {
  base::Random person(seed);
  NurseTraits out;
  out.profile.category = "expert";
  out.profile.handedness = "right";
  const auto& words = procedure.output.terms;
  const double forces = std::exp(spread * person.normal());
  out.words.clear();
  for (const auto& word : words) out.words.push_back(word.id);
  for (std::size_t k = 0; k + 1 < words.size(); ++k)
    out.responder.threshold_n.push_back(forces * boundaryAfter(words, k));
  out.responder.beyond_from_n = forces * procedure.output.max;
  out.responder.stop_from_n = 0.8 * out.responder.beyond_from_n;
  out.responder.noise = 1;
  if (const auto* const rate = procedure.rateInput()) {
    const double speeds = std::exp(spread * person.normal());
    const auto typical = typicalSpeeds(procedure);
    for (std::size_t k = 0; k < rate->terms.size(); ++k)
      out.levels[rate->terms[k].id] = levelAt(rate->terms[k].id, speeds * typical[k], seed + k + 1);
  }
  // What the procedure is like is the same for every expert; how each feels it differs.
  base::Random common(1);
  const auto highest = static_cast<double>(form.answers.size() - 1);
  const auto effects = effectsOf(procedure, highest, common);
  std::map<std::string, double> own;
  for (const auto& input : procedure.inputs) own[input.id] = std::exp(spread * person.normal());
  for (const auto& item : form.items) {
    double level = highest / 2;
    for (const auto& condition : item.conditions) {
      if (condition == study::kWayOut) {
        level -= kLessOnTheWayOut;
        continue;
      }
      const auto input = std::find_if(procedure.inputs.begin(), procedure.inputs.end(),
                                      [&](const auto& one) { return one.id == condition.input; });
      const auto term = std::find_if(input->terms.begin(), input->terms.end(),
                                     [&](const auto& one) { return one.id == condition.term; });
      // A region of another set than the first stands where the procedure is of middle force.
      if (term == input->terms.end()) continue;
      const double effect = effects.at(input->id)[static_cast<std::size_t>(term - input->terms.begin())];
      level += own[input->id] * (input->id == procedure.wayInput().id ? effect - highest / 2 : effect);
    }
    level += kOwnWords * person.normal();
    const double place = std::clamp(std::round(level), 0.0, highest);
    out.answers.push_back({{},
                           form.id,
                           item.number,
                           form.answers[static_cast<std::size_t>(place)].term,
                           study::Answer::Status::kAnswered});
  }
  return out;
}

}  // namespace tactus::session
