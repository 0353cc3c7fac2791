// The speed terms of a study, recomputed while settings move: what a change does not touch is kept. The terms take
// microseconds after a change of alpha, and a few milliseconds after a change of m or of the trimming; validity,
// diagnostics and intervals follow.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/workbench/labs/data/lab_data.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/speed_bootstrap.h"
#include "elicitation/speed/participant_speeds.h"

namespace tactus::workbench {

// What the speed lab shows: the clusters of each participant, their terms, the averaged terms.

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

// One piece of work for each of many subjects, on two processors.

/// Calls `work` for 0 to count - 1, in this thread and one more if there is a second processor: the window waits for
/// the result, so one is free. `keep_going` is called in this thread, between two pieces, with the share that is done;
/// false stops. Returns whether it came to the end.
bool sideBySide(std::size_t count, const std::function<void(std::size_t)>& work,
                const std::function<bool(double share)>& keep_going);

/// Thread: any, one at a time.
class SpeedClusters {
 public:
  /// Called between participants with the share that is done, in the caller's thread. False stops: the last result
  /// stays.
  using KeepGoing = std::function<bool(double share)>;

  SpeedClusters();
  ~SpeedClusters();
  SpeedClusters(const SpeedClusters&) = delete;
  SpeedClusters& operator=(const SpeedClusters&) = delete;

  /// Clusters and terms with `settings`, and with `clusters` clusters instead of one for each term. With equal numbers
  /// the same as elicitation::clusterSpeeds and averageRamps. Returns null if it was stopped.
  std::shared_ptr<const SpeedResult> cluster(const std::shared_ptr<const LabStudy>& study,
                                             const elicitation::BuildSettings& settings, std::size_t clusters,
                                             const KeepGoing& keep_going);
  /// The same result with validity, diagnostics and warnings. After `cluster`.
  std::shared_ptr<const SpeedResult> check(const KeepGoing& keep_going);
  /// The same result with 95 % intervals (SpeedBootstrap), which `more` gets again and again. After `cluster`. Nothing
  /// where the intervals cannot be computed.
  void bootstrap(const KeepGoing& keep_going, const std::function<void(std::shared_ptr<const SpeedResult>)>& more);
  /// The kept speeds of a participant, mm/s, until the next call of `cluster`. After `cluster`.
  std::span<const double> speedsOf(const std::string& participant) const;

 private:
  struct Subject;
  bool take(const std::shared_ptr<const LabStudy>& study, const KeepGoing& keep_going);
  bool clusterAll(const elicitation::BuildSettings& settings, std::size_t clusters, const KeepGoing& keep_going);
  void clusterOne(Subject& subject, const elicitation::BuildSettings& settings, std::size_t clusters) const;
  void average(const elicitation::BuildSettings& settings);

  std::shared_ptr<const LabStudy> study_;
  std::optional<elicitation::ParticipantSamples> samples_;  ///< of `study_`
  fuzzy::Variable speed_;                                   ///< with the default terms
  std::vector<Subject> subjects_;
  elicitation::BuildSettings settings_;
  SpeedResult result_;
};

}  // namespace tactus::workbench
