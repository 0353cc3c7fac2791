#include "elicitation/model/speed_bootstrap.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/statistics.h"
#include "elicitation/speed/participant_speeds.h"

namespace tactus::elicitation {
namespace {

/// One end of one ramp in every replicate.
std::vector<double> valuesOf(std::span<const std::vector<Ramp>> replicates, std::size_t gap, double Ramp::*end) {
  std::vector<double> values;
  values.reserve(replicates.size());
  for (const auto& ramps : replicates) values.push_back(ramps[gap].*end);
  return values;
}

}  // namespace

base::Result<SpeedBootstrap> SpeedBootstrap::of(const study::Study& study, const BuiltModel& built,
                                                const BuildSettings& settings, std::uint64_t seed,
                                                const std::function<bool()>& keep_going) {
  if (built.speeds.empty()) {
    return base::fail(base::ErrorCode::kData, "speeds", "none", "speeds of at least one participant");
  }
  const fuzzy::Variable& speed = built.model.inputs[fuzzy::rateOf(built.model.inputs).value()];
  std::vector<std::string> levels;
  for (const auto& term : speed.terms) levels.push_back(term.id);
  const ParticipantSamples samples(study.speeds);

  std::vector<StrokeBootstrap> participants;
  for (const auto& one : built.speeds) {
    if (keep_going && !keep_going()) {
      return base::fail(base::ErrorCode::kCancelled, "intervals of the speeds", "a request to stop", "time to end");
    }
    std::vector<study::SpeedSample> room;
    const auto kept = keptSamples(samples.of(one.participant), settings.speed.trim, room);
    TACTUS_TRY(auto bootstrap,
               StrokeBootstrap::of(kept, levels, one.centres, settings.speed, seed + participants.size()));
    participants.push_back(std::move(bootstrap));
  }
  return SpeedBootstrap(std::move(participants), built.averaged_ramps, built.speed_weights, settings.averaging);
}

SpeedBootstrap::SpeedBootstrap(std::vector<StrokeBootstrap> participants, std::vector<Ramp> averaged,
                               std::span<const double> weights, Averaging averaging)
    : participants_(std::move(participants)),
      averaged_(std::move(averaged)),
      weights_(fuzzy::normalizedWeights(weights)),
      averaging_(averaging) {}

void SpeedBootstrap::add(std::size_t replicates) {
  for (auto& participant : participants_) participant.add(replicates);
}

StudySpeedIntervals SpeedBootstrap::intervals(double coverage) const {
  StudySpeedIntervals out;
  out.replicates = replicates();
  if (out.replicates == 0) return out;
  double lowest = participants_.front().lowest();
  for (const auto& participant : participants_) {
    out.participants.push_back(participant.intervals(coverage));
    lowest = std::min(lowest, participant.lowest());
  }

  std::vector<std::vector<Ramp>> draws;  // of the average
  std::vector<std::vector<Ramp>> together(participants_.size());
  for (std::size_t i = 0; i < out.replicates; ++i) {
    for (std::size_t who = 0; who < together.size(); ++who) together[who] = participants_[who].ramps()[i];
    draws.push_back(averageRamps(together, weights_, averaging_));
  }
  const auto interval = [&](std::size_t gap, double Ramp::*end, DrawSpread RampSpread::*spread) {
    std::vector<double> variances;
    std::vector<DrawSpread> persons;
    for (std::size_t who = 0; who < participants_.size(); ++who) {
      const double weight = averaging_ == Averaging::kWeightedMean ? weights_[who] : 1;
      const double sd = base::standardDeviation(valuesOf(participants_[who].ramps(), gap, end));
      variances.push_back(weight * weight * sd * sd);
      persons.push_back(participants_[who].rampSpreads()[gap].*spread);
    }
    return drawInterval(averaged_[gap].*end, valuesOf(draws, gap, end), pooledSpread(variances, persons), lowest,
                        coverage);
  };
  for (std::size_t gap = 0; gap < averaged_.size(); ++gap) {
    out.averaged.push_back({interval(gap, &Ramp::p, &RampSpread::p), interval(gap, &Ramp::q, &RampSpread::q)});
  }
  return out;
}

}  // namespace tactus::elicitation
