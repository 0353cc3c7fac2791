#include "elicitation/speed/participant_speeds.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {

ParticipantSamples::ParticipantSamples(std::span<const study::SpeedSample> samples) {
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin + 1;
    while (end < samples.size() && samples[end].participant == samples[begin].participant) ++end;
    const auto run = samples.subspan(begin, end - begin);
    const auto [place, is_new] = found_.try_emplace(run.front().participant);
    Found& found = place->second;
    if (is_new) {
      found.all = run;
    } else {
      if (found.copied.empty()) found.copied.assign(found.all.begin(), found.all.end());
      found.copied.insert(found.copied.end(), run.begin(), run.end());
      found.all = found.copied;
    }
    begin = end;
  }
}

std::span<const study::SpeedSample> ParticipantSamples::of(std::string_view participant) const {
  const auto found = found_.find(participant);
  return found == found_.end() ? std::span<const study::SpeedSample>() : found->second.all;
}

std::span<const study::SpeedSample> keptSamples(std::span<const study::SpeedSample> samples, double share,
                                                std::vector<study::SpeedSample>& room) {
  if (share <= 0) return samples;
  room = trimStrokes(samples, share);
  return room;
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr double kLargestFuzziness = 100;  // as fuzzyCMeans

Result<void> checkSettings(const SpeedTermSettings& settings) {
  if (!(settings.trim >= 0 && settings.trim < 1)) {
    return fail(ErrorCode::kValue, "trim", base::formatNumber(settings.trim), "a share of 0 or more and below 1");
  }
  const double m = settings.fcm.m;
  if (settings.centres == SpeedCentres::kLevelMeans && !(m > 1 && m <= kLargestFuzziness)) {
    return fail(ErrorCode::kValue, "fuzziness m", base::formatNumber(m),
                "a number above 1 and at most " + base::formatNumber(kLargestFuzziness));
  }
  // Without centers only the range of alpha is looked at.
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

/// The means of the levels as centers, which the terms need in ascending order.
Result<std::vector<double>> levelMeans(std::span<const LevelSpeeds> levels) {
  std::vector<double> means;
  for (const auto& level : levels) {
    if (level.samples == 0) {
      return fail(ErrorCode::kData, "level " + level.level, "no samples", "samples of each level for level means");
    }
    means.push_back(level.mean_mm_s);
  }
  if (std::adjacent_find(means.begin(), means.end(), std::greater_equal<>()) != means.end()) {
    std::vector<std::string> found;
    for (const auto& level : levels) found.push_back(level.level + " " + base::roundedNumber(level.mean_mm_s));
    return fail(ErrorCode::kData, "level means", base::joined(found, ", ") + " mm/s",
                "means that rise with the level, or clusters as centers");
  }
  return means;
}

Result<ParticipantSpeeds> clusterOne(const study::Participant& participant, std::span<const study::SpeedSample> samples,
                                     const fuzzy::Variable& speed, const SpeedTermSettings& settings) {
  ParticipantSpeeds out;
  out.participant = participant.code;
  out.simulated = participant.simulated;
  out.samples = samples.size();
  std::vector<std::string> levels;
  for (const auto& term : speed.terms) levels.push_back(term.id);
  if (auto ok = checkLevels(samples, levels); !ok) return tl::unexpected(ok.error());
  std::vector<study::SpeedSample> room;
  const auto kept = keptSamples(samples, settings.trim, room);
  out.kept = kept.size();
  std::vector<double> speeds_mm_s;
  speeds_mm_s.reserve(kept.size());
  for (const auto& sample : kept) speeds_mm_s.push_back(sample.speed_mm_s);

  if (settings.centres == SpeedCentres::kLevelMeans) {
    auto means = levelMeans(levelSpeeds(kept, levels));
    if (!means) return ofParticipant(means.error(), participant.code, samples.front().line);
    out.centres = std::move(*means);
    out.m = settings.fcm.m;
  } else {
    FcmSettings fcm = settings.fcm;
    fcm.clusters = speed.terms.size();
    auto clusters = fuzzyCMeans(speeds_mm_s, fcm);
    if (!clusters) return ofParticipant(clusters.error(), participant.code, samples.front().line);
    out.clusters = std::move(*clusters);
    out.centres = out.clusters->centres;
    out.m = out.clusters->m;
  }
  if (out.centres.front() < speed.min) {
    return ofParticipant({ErrorCode::kData,
                          {},
                          out.clusters ? "lowest cluster" : "lowest level",
                          base::formatNumber(out.centres.front()) + " mm/s",
                          "at least " + base::formatNumber(speed.min) + " mm/s: speeds of forward strokes"},
                         participant.code, samples.front().line);
  }
  TACTUS_TRY(auto ramps, alphaCutRamps(out.centres, out.m, settings.alpha));
  out.ramps = std::move(ramps);
  out.validity = fcmValidity(speeds_mm_s, out.centres, out.m);
  out.diagnostics = levelDiagnostics(kept, levels, out.centres, participant.code);
  return out;
}

}  // namespace

bool clusterAlike(const SpeedTermSettings& a, const SpeedTermSettings& b) {
  const auto key = [](const SpeedTermSettings& one) {
    const FcmSettings& fcm = one.fcm;
    return std::tuple(one.centres, one.trim, fcm.clusters, fcm.m, fcm.starts, fcm.seed, fcm.tolerance,
                      fcm.most_iterations);
  };
  return key(a) == key(b);
}

Result<std::vector<ParticipantSpeeds>> clusterSpeeds(const study::Study& study, const fuzzy::Variable& speed,
                                                     const SpeedTermSettings& settings,
                                                     const std::function<bool(double share)>& go_on) {
  if (auto ok = checkSettings(settings); !ok) return tl::unexpected(ok.error());
  const ParticipantSamples samples(study.speeds);
  std::vector<ParticipantSpeeds> out;
  for (std::size_t i = 0; i < study.participants.size(); ++i) {
    const auto& participant = study.participants[i];
    const auto own = samples.of(participant.code);
    if (own.empty()) continue;
    if (go_on && !go_on(static_cast<double>(i) / static_cast<double>(study.participants.size()))) {
      return fail(ErrorCode::kCancelled, "clustering of the speeds", "a request to stop", "time to end");
    }
    TACTUS_TRY(auto one, clusterOne(participant, own, speed, settings));
    out.push_back(std::move(one));
  }
  return out;
}

fuzzy::Variable averagedSpeed(const fuzzy::Variable& speed, std::span<const ParticipantSpeeds> participants,
                              std::span<const Ramp> averaged) {
  fuzzy::Variable out = speed;
  for (const auto& one : participants) {
    out.max = std::max(out.max, speedUniverseMax(speed.max, one.centres.back(), one.ramps));
  }
  out.terms = speedTerms(out, averaged);
  return out;
}

}  // namespace tactus::elicitation
