// What the speed lab shows: the clusters of each participant, their terms, the averaged terms.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "elicitation/model/speed_bootstrap.h"
#include "elicitation/speed/participant_speeds.h"

namespace tactus::workbench {

/// One participant.
struct SpeedSubject {
  elicitation::ParticipantSpeeds speeds;
  std::string failure;            ///< one sentence: why there are no clusters; then `speeds` has only the participant
  std::vector<double> histogram;  ///< of the kept samples between 0 and `end_mm_s`, as shares of the fullest bin
  double end_mm_s = 10;           ///< whole tens, above all kept samples
  bool checked = false;           ///< validity and diagnostics of `speeds` are computed
};

struct SpeedResult {
  std::size_t clusters = 3;
  std::vector<std::shared_ptr<const SpeedSubject>> subjects;  ///< participants with speeds, in the study's order
  /// The terms of the speed: averaged, as the model gets them. The default ones if `averaged` is empty.
  fuzzy::Variable speed;
  /// Empty if another number of clusters than of terms was asked for, or a participant has no clusters.
  std::vector<elicitation::Ramp> averaged;
  std::string failure;                                        ///< why nothing is averaged; empty if it is
  std::vector<std::string> same_terms;                        ///< sentences: all levels of a participant read as one
  std::optional<elicitation::StudySpeedIntervals> intervals;  ///< come last, and improve
};

/// The number from which the color of subject `index` follows (figures::expertNumbers).
std::vector<std::size_t> subjectNumbers(const SpeedResult& result);

}  // namespace tactus::workbench
