#include "app/simulation/trace_table.h"

#include <string_view>
namespace tactus::simulation {
namespace {

constexpr std::string_view kColumns[] = {
    "time_s",        "simulated", "wish_mm", "true_position_mm", "true_speed_mm_s", "position_mm",    "speed_mm_s",
    "button",        "enabled",   "phase",   "stroke",           "depth_mm",        "slip_mm_s",      "stretch_mm",
    "model_force_n", "held",      "source",  "source_force_n",   "force_n",         "device_force_n", "limited",
    "trip",          "orders"};

std::string_view phaseName(render::Phase phase) {
  constexpr std::string_view kNames[] = {"released", "stuck", "sliding_in", "sliding_out"};
  return kNames[static_cast<int>(phase)];
}

std::string_view tripName(haptics::TripCause cause) {
  constexpr std::string_view kNames[] = {"",
                                         "force_not_finite",
                                         "position_not_finite",
                                         "too_fast_inwards",
                                         "too_fast_outwards",
                                         "device_silent",
                                         "write_stuck",
                                         "servo_late",
                                         "device_lost",
                                         "device_fault",
                                         "renderer",
                                         "stopped"};
  return kNames[static_cast<int>(cause)];
}

/// The limits that acted, e.g. `fade_in+slew`.
std::string limitNames(std::uint32_t limited) {
  std::string text;
  for (std::size_t bit = 0; bit < haptics::kLimitNames.size(); ++bit) {
    if ((limited >> bit & 1U) == 0) continue;
    if (!text.empty()) text += '+';
    text += haptics::kLimitNames[bit];
  }
  return text;
}

std::vector<std::string> columnsWith(const std::vector<std::string>& conditions) {
  std::vector<std::string> all(std::begin(kColumns), std::end(kColumns));
  all.insert(all.end(), conditions.begin(), conditions.end());
  return all;
}

std::vector<std::string> idsOf(const haptics::Conditions& conditions) {
  std::vector<std::string> ids;
  for (const auto& [id, value] : conditions) ids.push_back(id);
  return ids;
}

}  // namespace

TraceTable::TraceTable(const haptics::Conditions& conditions)
    : conditions_(idsOf(conditions)), csv_(columnsWith(conditions_)) {}

void TraceTable::add(const TraceTick& tick) {
  const auto& s = tick.sample;
  csv_.cell(static_cast<double>(s.time_ns) / 1e9).cell(1).cell(tick.wish.position_mm).cell(tick.true_position_mm);
  csv_.cell(tick.true_speed_mm_s).cell(s.position_mm).cell(s.speed_mm_s).cell(tick.wish.button ? 1 : 0);
  csv_.cell(s.enabled ? 1 : 0).cell(phaseName(s.phase)).cell(static_cast<long long>(s.stroke)).cell(s.depth_mm);
  csv_.cell(s.slip_speed_mm_s).cell(s.stretch_mm).cell(s.model_force_n).cell(s.held ? 1 : 0).cell(name(s.source));
  csv_.cell(s.source_force_n).cell(s.force_n).cell(tick.device_force_n);
  csv_.cell(limitNames(s.limited)).cell(tripName(s.trip)).cell(static_cast<long long>(s.orders));
  for (const auto& id : conditions_) csv_.cell(tick.conditions->at(id));
  csv_.endRow();
}

}  // namespace tactus::simulation
