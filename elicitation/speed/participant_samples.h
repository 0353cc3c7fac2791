// The speed samples of each participant of a study, without copies: a study of 200 participants has millions.
#pragma once

#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/study/records.h"

namespace tactus::elicitation {

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

}  // namespace tactus::elicitation
