// From a study to its averaged force model, with everything in between that a report shows.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"
#include "elicitation/model/expert_weights.h"
#include "elicitation/rules/expert_rules.h"
#include "elicitation/speed/participant_speeds.h"

namespace tactus::elicitation {

/// Whose speed terms an expert's rules use.
enum class SpeedTermsOf {
  kAveraged,  ///< those averaged over the participants
  kOwn,       ///< the expert's own, as an override; the averaged ones where the expert has no speeds
};

/// `averaged`, `own`: the words of `tactus build --terms`.
std::string_view name(SpeedTermsOf terms) noexcept;

struct BuildSettings {
  std::string name;         ///< of the model; empty takes the study's
  std::string created_utc;  ///< `2026-11-21T08:00:00Z`
  std::string generator;    ///< program and version
  SpeedSettings speed;
  Averaging averaging = Averaging::kMean;  ///< of the ramps over the participants; kWeightedMean uses `weights`
  SpeedTermsOf terms = SpeedTermsOf::kAveraged;
  WeightSettings weights;
  std::string series = "ascending";  ///< of the judgements that vote
  ForceTermsFrom force_terms = ForceTermsFrom::kVote;
  std::optional<double> force_end_n;    ///< end of the universe of the force, > 0; else as the judgements say
  std::vector<fuzzy::NamedJson> extra;  ///< further members of the provenance's settings
};

/// A model and how it came about.
struct BuiltModel {
  fuzzy::ForceModel model;                ///< validated
  std::vector<ParticipantSpeeds> speeds;  ///< one per participant with speeds
  std::vector<double> speed_weights;      ///< one per entry of `speeds` with Averaging::kWeightedMean, else empty
  std::vector<Ramp> averaged_ramps;       ///< empty where the default speed terms were used
  std::vector<VoteStep> votes;            ///< empty where the default force terms were used
  std::optional<ForceTerms> force_terms;  ///< absent where the default force terms were used
  std::vector<ExpertRules> experts;       ///< in the order of the model's experts
  ExpertInfluences influences;            ///< of each expert on the averaged force
  std::vector<std::string> notes;         ///< one sentence each: defaults, warnings, what is simulated
  /// For each note the id of the variable whose terms it is about; empty where it is about no variable.
  std::vector<std::string> note_subjects;
};

/// Builds the averaged model of `study` (paper, Section 3). The experts are the participants with rules, in the
/// participants' order; `forms` are those whose items gave the answers or whose depth terms the given rules use. The
/// model's depth terms are the set that most experts use (the first of them on a tie), the others' are overrides. Where
/// a table has no rows the default terms stay, with a note. Holes in the coverage stay too: the lint shows them.
base::Result<BuiltModel> buildModel(const study::Study& study, std::span<const study::Form> forms,
                                    const BuildSettings& settings);

/// The model of `built` with the experts weighted by `settings.weights` instead; everything else as it was built, with
/// the same `study` and `settings`. The clusters are used again: only where the ramps are a weighted mean are the
/// speed terms averaged anew. The error is that of `expertWeights`.
base::Result<fuzzy::ForceModel> reweightedModel(const BuiltModel& built, const study::Study& study,
                                                const BuildSettings& settings);

/// The model of the expert `expert_id` alone: own terms become the model's, checks are evaluated anew, accepted holes
/// are dropped. An unknown id is an error that lists the experts.
base::Result<fuzzy::ForceModel> expertModel(const fuzzy::ForceModel& averaged, std::string_view expert_id);

}  // namespace tactus::elicitation
