#include "app/session/judged_forces.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/store/entries.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::Result;

/// How long a force without a time limit is felt before an answer; answers take a few seconds.
constexpr double kUnlimitedHoldS = 10;

/// The time at the full force, as the servo gives it (sources/stimulus_source.h).
double holdS(double force_n, const std::optional<double>& asked_s, const haptics::LimitSettings& limits) {
  const double hold_s = asked_s.value_or(kUnlimitedHoldS);
  return force_n > limits.continuous_force_n ? std::min(hold_s, limits.stimulus_hold_s) : hold_s;
}

Result<void> requireHoldsAt(const std::string& place, double force_n, const experiments::ForceSettings& settings,
                            const haptics::LimitSettings& limits) {
  const double scale = settings.device_scale;
  const std::string at_scale = scale == 1 ? "" : " at 1 : " + formatNumber(scale);
  if (force_n > limits.force_cap_n * scale) {
    return fail(ErrorCode::kValue, place, formatNumber(force_n) + " N",
                "at most " + formatNumber(limits.force_cap_n * scale) + " N, the force cap of the device" + at_scale);
  }
  const auto asked_s = force_n > settings.continuous_n ? std::optional(settings.hold_limit_s) : std::nullopt;
  const double hold_s = holdS(force_n / scale, asked_s, limits);
  const double largest_n =
      scale * haptics::largestHoldN(settings.ramp_s, hold_s, limits.continuous_force_n, limits.thermal_window_s);
  if (force_n <= largest_n) return {};
  return fail(
      ErrorCode::kValue, place, formatNumber(force_n) + " N for " + formatNumber(hold_s) + " s",
      "at most " + base::formatFixed(largest_n, 2) + " N, which the motors of the device can hold so long" + at_scale);
}

}  // namespace

bool givesForce(std::string_view device) {
  constexpr std::string_view kWithout[] = {"virtual", "replay", "simulated", "dummy", "disconnected", "none"};
  const std::string lowered = base::lowered(std::string(base::trimmed(device)));
  return std::none_of(std::begin(kWithout), std::end(kWithout),
                      [&](std::string_view name) { return lowered.starts_with(name); });
}

Result<void> requireHolds(const experiments::ForceSettings& settings, const haptics::LimitSettings& limits) {
  std::vector<std::pair<std::string, double>> largest;
  for (const double force_n : settings.familiarisation_n) largest.emplace_back("familiarisation_n", force_n);
  if (settings.ascending) largest.emplace_back("ladder.highest_n", settings.ladder.highest_n);
  if (settings.random) largest.emplace_back("random_steps.highest_n", settings.random_steps.highest_n);
  for (const auto& [place, force_n] : largest) {
    if (auto ok = requireHoldsAt(place, force_n, settings, limits); !ok) return ok;
  }
  return {};
}

double pauseBeforeS(const experiments::ForcePlan& plan, const haptics::ThermalBudget& budget,
                    const haptics::LimitSettings& limits) {
  const double force_n = plan.step.force_n / plan.device_scale;
  const haptics::PlannedHold planned{force_n, plan.ramp_s, holdS(force_n, plan.hold_limit_s, limits)};
  const auto rest_s = haptics::restBeforeS(budget, planned, limits.continuous_force_n, limits.thermal_window_s);
  return std::max(plan.pause_before_s, rest_s.value_or(0));
}

namespace {

using study::RecordId;

/// `record` and the records that it corrects, the latest first.
std::vector<const study::JudgementRecord*> chainOf(const study::JudgementRecord& record,
                                                   const std::map<RecordId, const study::JudgementRecord*>& by_id) {
  std::vector<const study::JudgementRecord*> chain{&record};
  while (chain.back()->entry.supersedes) {
    const auto found = by_id.find(*chain.back()->entry.supersedes);
    if (found == by_id.end()) break;
    chain.push_back(found->second);
  }
  return chain;
}

}  // namespace

base::Result<std::vector<JudgedForce>> judgedForces(const store::StudyFile& file, const StudyView& view) {
  const auto all = store::judgements(file, {{}, {}, true});
  if (!all) return tl::unexpected(base::inFile(all.error(), file.path()));
  std::map<RecordId, const study::JudgementRecord*> by_id;
  std::set<RecordId> corrected;
  for (const auto& record : *all) {
    by_id[record.entry.id] = &record;
    if (record.entry.supersedes) corrected.insert(*record.entry.supersedes);
  }
  std::map<RecordId, std::string> counted_sessions;
  const std::set<RecordId> counted(view.judgement_ids.begin(), view.judgement_ids.end());
  for (std::size_t i = 0; i < view.judgement_ids.size(); ++i) {
    const auto found = by_id.find(view.judgement_ids[i]);
    if (found == by_id.end()) continue;
    counted_sessions[found->second->entry.session] = view.study.judgements[i].participant;
  }
  std::map<std::string, std::size_t> participants;
  for (const auto& one : view.study.participants) participants.emplace(one.code, participants.size());

  // By participant, then by the place of the first record: a correction stands where the judgement was.
  std::map<std::pair<std::size_t, const study::JudgementRecord*>, JudgedForce> ordered;
  for (const auto& record : *all) {
    const auto session = counted_sessions.find(record.entry.session);
    if (session == counted_sessions.end() || corrected.contains(record.entry.id)) continue;
    const auto chain = chainOf(record, by_id);
    JudgedForce judged{session->second, record, counted.contains(record.entry.id), {}};
    for (std::size_t i = chain.size(); i-- > 1;) judged.before.push_back({chain[i]->kind, chain[i]->term});
    ordered.emplace(std::pair(participants[session->second], chain.back()), std::move(judged));
  }
  std::vector<JudgedForce> out;
  for (auto& [key, judged] : ordered) out.push_back(std::move(judged));
  return out;
}

}  // namespace tactus::session
