// The insertion speeds of each participant: clusters, ramps, and the averaged terms.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_validity.h"
#include "elicitation/speed/level_diagnostics.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {

// The speed samples of each participant of a study, without copies: a study of 200 participants has millions.

/// Where a study holds the samples of a participant side by side, as study files do, nothing is copied.
/// Thread: any, after the constructor.
class ParticipantSamples {
 public:
  /// `samples` outlive this and stay unchanged.
  explicit ParticipantSamples(std::span<const study::SpeedSample> samples);
  ParticipantSamples(const ParticipantSamples&) = delete;
  ParticipantSamples& operator=(const ParticipantSamples&) = delete;

  /// Those of `participant`, in the study's order; none for an unknown one.
  std::span<const study::SpeedSample> of(std::string_view participant) const;

 private:
  struct Found {
    std::span<const study::SpeedSample> all;
    std::vector<study::SpeedSample> copied;  ///< behind `all` if they lie apart in the study
  };
  std::unordered_map<std::string_view, Found> found_;
};

/// What trimStrokes keeps of `samples`: `samples` themselves for a share of 0, otherwise copies in `room`.
std::span<const study::SpeedSample> keptSamples(std::span<const study::SpeedSample> samples, double share,
                                                std::vector<study::SpeedSample>& room);

struct SpeedTermSettings {
  SpeedCentres centres = SpeedCentres::kClusters;
  double alpha = kDefaultAlpha;  ///< (1/2, 1], membership at the start and end of a ramp (alphaCutRamps)
  FcmSettings fcm;               ///< `clusters` is set to the number of speed terms; m applies to both kinds of centers
  double trim = 0;               ///< [0, 1): samples below this share of their stroke's peak speed are dropped
};

/// Whether both give the same clusters: all is equal but alpha, which acts on the ramps alone.
bool clusterAlike(const SpeedTermSettings& a, const SpeedTermSettings& b);

/// The results for one participant's speeds.
struct ParticipantSpeeds {
  std::string participant;
  bool simulated = false;
  std::size_t samples = 0;            ///< before trimming
  std::size_t kept = 0;               ///< after trimming; all following members use these samples
  std::vector<double> centres;        ///< of the clusters, or the means of the levels; ascending
  double m = 2;                       ///< fuzziness of the memberships around the centers
  std::optional<FcmResult> clusters;  ///< empty if the centers are the means of the levels
  FcmValidity validity;
  std::vector<Ramp> ramps;
  LevelDiagnostics diagnostics;
};

/// One entry per participant with speeds, in the participants' order. The centers become the terms of `speed` in
/// ascending order.
/// Returns an error that names the participant for: settings out of range, a level that is not a term of `speed`,
/// speeds that cannot be clustered, a center below the universe of `speed`. For level means also: a level without
/// samples, or means that do not rise with the level.
/// `go_on`: asked before each participant with the share that is done, [0, 1]; false ends with an error of kind
/// kCancelled.
base::Result<std::vector<ParticipantSpeeds>> clusterSpeeds(const study::Study& study, const fuzzy::Variable& speed,
                                                           const SpeedTermSettings& settings,
                                                           const std::function<bool(double share)>& go_on = {});

/// `speed` with a universe that contains all participants, and with the terms of the averaged ramps.
fuzzy::Variable averagedSpeed(const fuzzy::Variable& speed, std::span<const ParticipantSpeeds> participants,
                              std::span<const Ramp> averaged);

}  // namespace tactus::elicitation
