#include "app/planning/planned_study.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/procedure/procedure.h"

namespace tactus::planning {
namespace {

using base::formatFixed;
using base::formatNumber;
using base::Result;

constexpr int kMoreNurses = 2;
constexpr int kMoreQuestions = 10;
constexpr int kUsualStrokes = 4;

void sortOut(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// A third, two thirds and all of the questions.
std::vector<int> thirdsOf(const Questions& questions) {
  const auto all = static_cast<int>(questions.items.size());
  return {std::max(1, all / 3), std::max(1, 2 * all / 3), all};
}

}  // namespace

PlannedStudy planBefore(const session::ProcedurePtr& about, const PlanSettings& wanted) {
  PlannedStudy out;
  out.questions = questionsOf(about);
  out.family = defaultFamily(out.questions);
  out.settings = wanted;
  auto& settings = out.settings;
  settings.least_nurses = std::min(settings.least_nurses, settings.most_nurses);
  if (settings.questions.empty()) settings.questions = thirdsOf(out.questions);
  if (settings.strokes.empty()) settings.strokes = {kUsualStrokes};
  sortOut(settings.questions);
  sortOut(settings.strokes);
  if (about != procedure::defaultProcedure())
    out.notes.emplace_back("The nurses are invented from the pack: nothing is known of real ones in this procedure.");
  return out;
}

Result<PlannedStudy> planDuring(const study::Study& study, const elicitation::BuiltModel& built,
                                const elicitation::BuildSettings& build, const PlanSettings& wanted) {
  TACTUS_TRY(auto found, familyOf(study, built, build));
  PlannedStudy out;
  out.questions = std::move(found.questions);
  out.family = std::move(found.family);
  out.settings = wanted;
  out.settings.noise = found.noise;
  out.notes = std::move(found.notes);
  std::size_t rules = 0;
  for (const auto& expert : built.model.experts) rules += expert.rules.size();
  Design now;
  now.nurses = static_cast<int>(found.nurses);
  const auto items = static_cast<int>(out.questions.items.size());
  now.questions = std::clamp(static_cast<int>((rules + found.nurses / 2) / found.nurses), 1, items);
  if (found.strokes > 0) now.strokes = static_cast<int>(found.strokes);
  out.now = now;
  auto& settings = out.settings;
  if (settings.questions.empty())
    settings.questions = {std::max(1, now.questions - kMoreQuestions), std::min(items, now.questions + kMoreQuestions)};
  settings.questions.push_back(now.questions);
  settings.strokes.push_back(now.strokes);
  sortOut(settings.questions);
  sortOut(settings.strokes);
  settings.most_nurses = std::max(settings.most_nurses, now.nurses + kMoreNurses);
  settings.least_nurses = std::min({settings.least_nurses, settings.most_nurses, now.nurses});
  return out;
}

Result<void> simulate(PlannedStudy& planned, const std::function<bool(double share)>& go_on) {
  TACTUS_TRY(planned.plan, planStudy(planned.questions, sourceOf(planned.family), planned.settings, go_on));
  return {};
}

std::vector<Gain> gainsOf(const PlannedStudy& planned) {
  std::vector<Gain> out;
  if (!planned.now) return out;
  const auto* const now = planned.plan.find(*planned.now);
  Design nurses = *planned.now;
  nurses.nurses += kMoreNurses;
  Design more = *planned.now;
  more.questions = std::min(more.questions + kMoreQuestions, static_cast<int>(planned.questions.items.size()));
  Design fewer = *planned.now;
  fewer.questions = std::max(1, fewer.questions - kMoreQuestions);
  for (const auto& to : {nurses, more, fewer}) {
    const auto* const found = planned.plan.find(to);
    if (found == nullptr || (to.nurses == now->design.nurses && to.questions == now->design.questions)) continue;
    out.push_back({*planned.now, to, now->error_n - found->error_n});
  }
  return out;
}

std::string sentence(const Gain& gain) {
  const auto newtons = formatFixed(std::abs(gain.buys_n), 3) + " N";
  const bool buys = gain.buys_n >= 0;
  const int nurses = gain.to.nurses - gain.from.nurses;
  const int questions = gain.to.questions - gain.from.questions;
  if (nurses > 0) return std::to_string(nurses) + " more nurses buy " + newtons + ".";
  if (questions > 0)
    return std::to_string(questions) + " more questions each " + (buys ? "buy " : "cost ") + newtons + ".";
  return std::to_string(-questions) + " questions fewer each " + (buys ? "would gain " : "would cost ") + newtons + ".";
}

std::string designText(const Questions& questions, const Design& design) {
  const auto text = std::to_string(design.nurses) + " nurses, " + std::to_string(design.questions) + " questions";
  return questions.speeds() == 0 ? text : text + ", " + std::to_string(design.strokes) + " strokes at each speed";
}

std::string cheapestSentence(const PlannedStudy& planned) {
  const auto& designs = planned.plan.designs;
  const auto wanted = "± " + formatNumber(planned.settings.precision_n) + " N";
  if (planned.plan.cheapest) {
    const auto& one = designs[*planned.plan.cheapest];
    return "The cheapest design for " + wanted + ": " + designText(planned.questions, one.design) + ", " +
           formatFixed(one.hours, 1) + " hours.";
  }
  const auto best = std::min_element(designs.begin(), designs.end(),
                                     [](const auto& a, const auto& b) { return a.high_n < b.high_n; });
  std::string out = "No design reaches " + wanted +
                    ". The best of them: " + designText(planned.questions, best->design) + ", ± " +
                    formatFixed(best->error_n, 3) + " N.";
  if (best->bias_n > planned.settings.precision_n)
    out += " More nurses of this kind would not help: " + formatFixed(best->bias_n, 3) + " N of it stay.";
  return out;
}

}  // namespace tactus::planning
