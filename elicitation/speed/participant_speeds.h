// The insertion speeds of each participant: clusters, ramps, and the terms they give together.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_validity.h"
#include "elicitation/speed/level_diagnostics.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {

struct SpeedSettings {
  SpeedCentres centres = SpeedCentres::kClusters;
  double alpha = kDefaultAlpha;  ///< (1/2, 1], where a ramp begins and ends (alphaCutRamps)
  FcmSettings fcm;               ///< as many clusters as the speed variable has terms; m for either kind of centres
  double trim = 0;               ///< [0, 1): share of a stroke's peak speed below which its samples are dropped
};

/// What the speeds of one participant gave.
struct ParticipantSpeeds {
  std::string participant;
  bool simulated = false;
  std::size_t samples = 0;            ///< before trimming
  std::size_t kept = 0;               ///< after trimming; everything below is computed from these
  std::vector<double> centres;        ///< of the clusters, or the means of the levels; ascending
  double m = 2;                       ///< fuzziness of the memberships around the centres
  std::optional<FcmResult> clusters;  ///< absent where the centres are the means of the levels
  FcmValidity validity;
  std::vector<Ramp> ramps;
  LevelDiagnostics diagnostics;
};

/// One entry per participant with speeds, in the participants' order. The centres become the terms of `speed` in
/// ascending order. Refused: settings out of range, a level that is no term of `speed`, speeds that cannot be
/// clustered, for level means a level without samples or means that do not rise with the level, a centre below the
/// universe of `speed`; the error names the participant.
base::Result<std::vector<ParticipantSpeeds>> clusterSpeeds(const study::Study& study, const fuzzy::Variable& speed,
                                                           const SpeedSettings& settings);

/// `speed` with the universe that all participants need and the terms of the averaged ramps.
fuzzy::Variable averagedSpeed(const fuzzy::Variable& speed, std::span<const ParticipantSpeeds> participants,
                              std::span<const Ramp> averaged);

}  // namespace tactus::elicitation
