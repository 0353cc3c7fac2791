// Numbers for two of the four kinds of evidence about a model (docs/evidence.md): its distance to a reference curve
// that was under seal, and whether its force tells the strokes of experts from those of students.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"
#include "core/study/records.h"

namespace tactus::elicitation {

// Concurrent evidence: the distance to a curve from another source.

/// One point of a reference curve along the depth.
struct ReferencePoint {
  double depth_mm = 0;
  double force_n = 0;
};

/// The most points of a reference curve: bands are calculated at each of them.
inline constexpr std::size_t kMostReferencePoints = 1000;

/// Reads a CSV text with one column `depth` or `depth_mm` and one column `force` or `force_n`; other columns are
/// ignored, and so are rows without a force. Returns an error for other units (`depth_cm`), a column for several curves
/// (`series`), a depth outside the universe of the study's input, depths that do not ascend, a negative force, fewer
/// than two points or too many. `file`: named in the errors.
base::Result<std::vector<ReferencePoint>> readReferenceCurve(const std::string& text, const std::string& file,
                                                             const procedure::Procedure& procedure);

/// The input point at `depth_mm`, the other inputs of the procedure at `conditions`, or where one is missing at their
/// usual value.
std::vector<double> referenceInputs(const procedure::Procedure& procedure,
                                    const std::map<std::string, double>& conditions, double depth_mm);

/// A reference of the study that is or was under seal, as the report shows it.
struct SealedCurve {
  struct Opening {
    std::string utc;
    bool early = false;
  };
  struct Change {
    std::string utc;
    std::string author;
    std::string label;
  };
  std::string sealed_utc;
  std::string sha256;
  std::string note;
  std::map<std::string, double> conditions = {};
  bool late = false;
  std::vector<Opening> openings = {};
  std::vector<Change> changes = {};                    ///< versions of the model that an opening did not find
  std::size_t records_after = 0;                       ///< of the elicitation, that an opening did not find
  std::vector<ReferencePoint> points = {};             ///< empty while it is closed
  std::optional<fuzzy::ForceModel> signed_model = {};  ///< the last sign-off that all openings found
};

/// The force of a model minus the reference.
struct ReferenceError {
  std::size_t points = 0;   ///< at which the model has a force
  std::size_t without = 0;  ///< at which it has none
  double mean_n = 0;
  double rms_n = 0;
  double rms_jnd = 0;      ///< in just-noticeable differences around the reference
  double largest_n = 0;    ///< with its sign
  double largest_jnd = 0;  ///< the largest in just-noticeable differences, which may be elsewhere; not negative
  double largest_at_mm = 0;
};
/// Each point counts once. Nothing is left but counts where no point has a force.
base::Result<ReferenceError> referenceError(const procedure::Procedure& procedure, const fuzzy::ForceModel& model,
                                            const SealedCurve& curve);

// Construct evidence: whether the force of the model tells experts' strokes from students'.

/// What the model says of the strokes of one participant: means over the strokes.
struct StrokeForces {
  std::string participant;
  bool expert = false;
  std::size_t strokes = 0;
  double peak_n = 0;     ///< largest force
  double work_n_mm = 0;  ///< of the forward movement
  double reversals = 0;  ///< changes from forward to backward movement by at least kReversalMm, per stroke
};

/// A shorter movement back is noise of the sensor.
inline constexpr double kReversalMm = 0.5;

/// One measure, experts against students.
struct GroupDifference {
  double expert_mean = 0;
  double student_mean = 0;
  /// Chance that an expert's value is above a student's, ties one half: 0.5 says nothing, 0 or 1 tells all.
  double above = 0.5;
  /// Of a distance from 0.5 at least as large if the groups were drawn by lot (exact, all divisions into groups of
  /// these sizes); nothing with more than 18 participants.
  std::optional<double> chance;
};

struct ConstructEvidence {
  std::vector<StrokeForces> participants;
  std::size_t experts = 0;
  std::size_t students = 0;
  bool simulated = false;  ///< any of them
  GroupDifference peak, work, reversals;
};

/// The category decides: `expert` against `student`, `novice` or `beginner`; other participants are left out. Strokes
/// are those of the speed experiment, at the usual conditions. The measures are set if both groups have two
/// participants or more.
base::Result<ConstructEvidence> constructEvidence(const study::Study& study, const fuzzy::ForceModel& model);

}  // namespace tactus::elicitation
