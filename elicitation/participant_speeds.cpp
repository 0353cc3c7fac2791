#include "elicitation/participant_speeds.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

Result<void> checkSettings(const fuzzy::Variable& speed, const SpeedSettings& settings) {
  if (!(settings.trim >= 0 && settings.trim < 1)) {
    return fail(ErrorCode::kValue, "trim", base::formatNumber(settings.trim), "a share of 0 or more and below 1");
  }
  if (settings.fcm.clusters != speed.terms.size()) {
    return fail(ErrorCode::kValue, "clusters", std::to_string(settings.fcm.clusters),
                std::to_string(speed.terms.size()) + ", one for each term of the speed");
  }
  // Without centres only the range of alpha is looked at.
  if (const auto ramps = alphaCutRamps({}, settings.fcm.m, settings.alpha); !ramps)
    return tl::unexpected(ramps.error());
  return {};
}

/// The same error, said of one participant, whose samples have the line `line`.
tl::unexpected<base::Error> ofParticipant(base::Error error, const std::string& participant, study::TableLine line) {
  error.place = "speeds of participant " + participant + ", " + error.place;
  return study::inTable(std::move(error), study::kSpeedsTable, line);
}

Result<void> checkLevels(std::span<const study::SpeedSample> samples, std::span<const std::string> levels) {
  for (const auto& sample : samples) {
    if (std::find(levels.begin(), levels.end(), sample.level) != levels.end()) continue;
    return study::atCell({ErrorCode::kReference,
                          {},
                          "speeds of participant " + sample.participant,
                          "level " + base::quoted(sample.level),
                          "one of " + base::joined(levels, ", ")},
                         {study::kSpeedsTable, sample.line, "level"}, base::quoted(sample.level));
  }
  return {};
}

Result<ParticipantSpeeds> clusterOne(const study::Participant& participant, std::span<const study::SpeedSample> samples,
                                     const fuzzy::Variable& speed, const SpeedSettings& settings) {
  ParticipantSpeeds out;
  out.participant = participant.code;
  out.simulated = participant.simulated;
  out.samples = samples.size();
  std::vector<std::string> levels;
  for (const auto& term : speed.terms) levels.push_back(term.id);
  if (auto ok = checkLevels(samples, levels); !ok) return tl::unexpected(ok.error());
  const auto kept = trimStrokes(samples, settings.trim);
  out.kept = kept.size();
  std::vector<double> speeds_mm_s;
  speeds_mm_s.reserve(kept.size());
  for (const auto& sample : kept) speeds_mm_s.push_back(sample.speed_mm_s);

  auto clusters = fuzzyCMeans(speeds_mm_s, settings.fcm);
  if (!clusters) return ofParticipant(clusters.error(), participant.code, samples.front().line);
  out.clusters = std::move(*clusters);
  const auto& centres = out.clusters.centres;
  if (centres.front() < speed.min) {
    return ofParticipant({ErrorCode::kData,
                          {},
                          "lowest cluster",
                          base::formatNumber(centres.front()) + " mm/s",
                          "at least " + base::formatNumber(speed.min) + " mm/s: speeds of forward strokes"},
                         participant.code, samples.front().line);
  }
  auto ramps = alphaCutRamps(centres, out.clusters.m, settings.alpha);
  if (!ramps) return tl::unexpected(ramps.error());
  out.ramps = std::move(*ramps);
  out.validity = fcmValidity(speeds_mm_s, centres, out.clusters.m);
  out.confusion = levelConfusion(kept, levels, centres, participant.code);
  return out;
}

}  // namespace

Result<std::vector<ParticipantSpeeds>> clusterSpeeds(const study::Study& study, const fuzzy::Variable& speed,
                                                     const SpeedSettings& settings) {
  if (auto ok = checkSettings(speed, settings); !ok) return tl::unexpected(ok.error());
  std::unordered_map<std::string, std::vector<study::SpeedSample>> samples;
  for (const auto& sample : study.speeds) samples[sample.participant].push_back(sample);

  std::vector<ParticipantSpeeds> out;
  for (const auto& participant : study.participants) {
    const auto own = samples.find(participant.code);
    if (own == samples.end()) continue;
    auto one = clusterOne(participant, own->second, speed, settings);
    if (!one) return tl::unexpected(one.error());
    out.push_back(std::move(*one));
  }
  return out;
}

fuzzy::Variable averagedSpeed(const fuzzy::Variable& speed, std::span<const ParticipantSpeeds> participants,
                              std::span<const Ramp> averaged) {
  fuzzy::Variable out = speed;
  for (const auto& one : participants) {
    out.max = std::max(out.max, speedUniverseMax(speed.max, one.clusters.centres.back(), one.ramps));
  }
  out.terms = speedTerms(out, averaged);
  return out;
}

}  // namespace tactus::elicitation
