#include "elicitation/speed_bootstrap.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace tactus::elicitation {

base::Result<SpeedBootstrap> SpeedBootstrap::of(const study::Study& study, const BuiltModel& built,
                                                const BuildSettings& settings, std::uint64_t seed) {
  if (built.speeds.empty()) {
    return base::fail(base::ErrorCode::kData, "speeds", "none", "speeds of at least one participant");
  }
  const auto speed = std::find_if(built.model.inputs.begin(), built.model.inputs.end(),
                                  [](const fuzzy::Variable& input) { return input.id == "speed"; });
  std::vector<std::string> levels;
  for (const auto& term : speed->terms) levels.push_back(term.id);
  std::unordered_map<std::string, std::vector<study::SpeedSample>> samples;
  for (const auto& sample : study.speeds) samples[sample.participant].push_back(sample);

  std::vector<StrokeBootstrap> participants;
  for (const auto& one : built.speeds) {
    const auto kept = trimStrokes(samples[one.participant], settings.speed.trim);
    auto bootstrap = StrokeBootstrap::of(kept, levels, one.centres, settings.speed, seed + participants.size());
    if (!bootstrap) return tl::unexpected(bootstrap.error());
    participants.push_back(std::move(*bootstrap));
  }
  return SpeedBootstrap(std::move(participants), built.speed_weights, settings.averaging);
}

SpeedBootstrap::SpeedBootstrap(std::vector<StrokeBootstrap> participants, std::vector<double> weights,
                               Averaging averaging)
    : participants_(std::move(participants)), weights_(std::move(weights)), averaging_(averaging) {}

void SpeedBootstrap::add(std::size_t replicates) {
  for (auto& participant : participants_) participant.add(replicates);
}

StudySpeedIntervals SpeedBootstrap::intervals(double coverage) const {
  StudySpeedIntervals out;
  out.replicates = replicates();
  if (out.replicates == 0) return out;
  for (const auto& participant : participants_) out.participants.push_back(participant.intervals(coverage));

  const std::size_t gaps = participants_.front().ramps().front().size();
  std::vector<std::vector<double>> p(gaps), q(gaps);
  std::vector<std::vector<Ramp>> together(participants_.size());
  for (std::size_t i = 0; i < out.replicates; ++i) {
    for (std::size_t who = 0; who < together.size(); ++who) together[who] = participants_[who].ramps()[i];
    const auto averaged = averageRamps(together, weights_, averaging_);
    for (std::size_t k = 0; k < gaps; ++k) {
      p[k].push_back(averaged[k].p);
      q[k].push_back(averaged[k].q);
    }
  }
  for (std::size_t k = 0; k < gaps; ++k) {
    out.averaged.push_back({percentileInterval(p[k], coverage), percentileInterval(q[k], coverage)});
  }
  return out;
}

}  // namespace tactus::elicitation
