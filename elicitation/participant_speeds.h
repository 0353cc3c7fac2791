// The insertion speeds of each participant: clusters, ramps, and the terms they give together.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/fcm.h"
#include "elicitation/fcm_validity.h"
#include "elicitation/level_confusion.h"
#include "elicitation/speed_terms.h"

namespace tactus::elicitation {

struct SpeedSettings {
  double alpha = kDefaultAlpha;  ///< (1/2, 1], where a ramp begins and ends (alphaCutRamps)
  FcmSettings fcm;               ///< as many clusters as the speed variable has terms
  double trim = 0;               ///< [0, 1): share of a stroke's peak speed below which its samples are dropped
};

/// What the speeds of one participant gave.
struct ParticipantSpeeds {
  std::string participant;
  bool simulated = false;
  std::size_t samples = 0;  ///< before trimming
  std::size_t kept = 0;     ///< after trimming, clustered
  FcmResult clusters;
  FcmValidity validity;
  std::vector<Ramp> ramps;
  LevelConfusion confusion;  ///< of the samples kept
};

/// One entry per participant with speeds, in the participants' order. The clusters become the terms of `speed` in
/// ascending order. Refused: settings out of range, a level that is no term of `speed`, speeds that cannot be
/// clustered, a centre below the universe of `speed`; the error names the participant.
base::Result<std::vector<ParticipantSpeeds>> clusterSpeeds(const study::Study& study, const fuzzy::Variable& speed,
                                                           const SpeedSettings& settings);

/// `speed` with the universe that all participants need and the terms of the averaged ramps.
fuzzy::Variable averagedSpeed(const fuzzy::Variable& speed, std::span<const ParticipantSpeeds> participants,
                              std::span<const Ramp> averaged);

}  // namespace tactus::elicitation
