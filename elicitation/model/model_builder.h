// Builds a study's averaged force model, with all intermediate results for a report.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"
#include "core/study/records.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/depth/depth_measurement.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"
#include "elicitation/rules/expert_rules.h"
#include "elicitation/speed/participant_speeds.h"

namespace tactus::elicitation {

// The weights of the experts in the averaged force.

enum class WeightPolicy {
  kEqual,     ///< 1 each (paper, Eq. 2)
  kYears,     ///< years of experience
  kCategory,  ///< WeightSettings::categories of the participant's category
  kColumn,    ///< the participant's own weight (column `weight` of participants.csv)
  kTable,     ///< WeightSettings::table
};

/// `equal`, `years`, `category`, `column`, `file`: the values of `tactus build --weights`.
std::string_view name(WeightPolicy policy) noexcept;

struct WeightSettings {
  WeightPolicy policy = WeightPolicy::kEqual;
  /// Weight of each category (lower case). The default has equal steps between ranks, a choice of this project.
  std::map<std::string, double> categories{{"beginner", 1}, {"intermediate", 2}, {"expert", 3}};
  std::map<std::string, double> table;  ///< weight by participant
  std::string table_file;               ///< source of the table, for errors and notes; may be empty
};

/// One weight per expert, in their order. Returns an error for: a participant without the value that the policy needs,
/// a weight that is not finite or below 0, no weight above 0. The error names table and line of the value, or of its
/// missing place.
base::Result<std::vector<double>> expertWeights(std::span<const study::Participant> experts,
                                                const WeightSettings& settings);

/// One sentence for each participant in WeightSettings::table who is not in `participants`, if the policy uses the
/// table.
std::vector<std::string> unusedWeightNotes(std::span<const study::Participant> participants,
                                           const WeightSettings& settings);

/// Notes about `weights`, one sentence each: experts with no or hardly any weight (less than 1 % of the sum), and the
/// simulated share of the mean if only a part is simulated. `weights`: one per expert, accepted by `expertWeights`.
/// `simulated`: whether an expert's rules are simulated.
std::vector<std::string> weightNotes(std::span<const study::Participant> experts, std::span<const double> weights,
                                     const std::vector<bool>& simulated);

/// Reads a table `participant,weight`. Returns an error for a missing column, a duplicate participant, or a weight
/// below 0.
base::Result<std::map<std::string, double>> readWeightTable(const base::CsvTable& table);

/// The origin of the speed terms in an expert's rules.
enum class SpeedTermsOf {
  kAveraged,  ///< averaged over the participants
  kOwn,       ///< the expert's own, as an override; the averaged ones if the expert has no speeds
};

/// `averaged`, `own`: the values of `tactus build --terms`.
std::string_view name(SpeedTermsOf terms) noexcept;

struct BuildSettings {
  std::string name;         ///< name of the model; empty: the study's name
  std::string created_utc;  ///< `2026-11-21T08:00:00Z`
  std::string generator;    ///< program and version
  SpeedTermSettings speed;
  Averaging averaging = Averaging::kMean;  ///< of the ramps over the participants; kWeightedMean uses `weights`
  SpeedTermsOf terms = SpeedTermsOf::kAveraged;
  WeightSettings weights;
  std::string series = "ascending";  ///< series of the judgements that vote
  ForceTermsFrom force_terms = ForceTermsFrom::kVote;
  std::optional<double> force_end_n;  ///< end of the force universe, > 0; empty: from the judgements
  DepthsFrom depths = DepthsFrom::kTemplate;
  std::optional<DepthMeasurement> measured_depths;  ///< of the study; kMeasured needs it
  std::vector<fuzzy::NamedJson> extra;              ///< further members of the provenance's settings
};

/// A model and its intermediate results.
struct BuiltModel {
  std::shared_ptr<const procedure::Procedure> procedure;  ///< of the study; null: as there
  fuzzy::ForceModel model;                                ///< validated
  std::vector<ParticipantSpeeds> speeds;                  ///< one per participant with speeds
  std::vector<double> speed_weights;      ///< one per entry of `speeds` with Averaging::kWeightedMean, else empty
  std::vector<Ramp> averaged_ramps;       ///< empty if the default speed terms are used
  std::vector<VoteStep> votes;            ///< empty if the default force terms are used
  std::optional<ForceTerms> force_terms;  ///< empty if the default force terms are used
  std::vector<ExpertRules> experts;       ///< in the order of the model's experts
  ExpertInfluences influences;            ///< of each expert on the averaged force
  std::vector<std::string> notes;         ///< one sentence each: defaults, warnings, simulated data
  /// For each note the id of the variable whose terms it concerns; empty if it concerns none.
  std::vector<std::string> note_subjects;

  const procedure::Procedure& about() const { return procedure::orDefault(procedure); }
};

/// Builds the averaged model of `study` (paper, Section 3). The experts are the participants with rules, in the
/// participants' order. `forms`: the forms of the answers, and of the depth terms of given rules.
/// The model's depth terms are the set that most experts use (on a tie the first); the sets of other experts are
/// overrides. If a table has no rows, the default terms stay, with a note. Holes in the coverage also stay; the lint
/// reports them.
/// `clustered`: BuiltModel::speeds of an earlier model of the same study, if its settings cluster alike (clusterAlike);
/// null: the speeds are clustered.
/// `go_on`: asked now and then with the share of the time that has passed, about, [0, 1], never less than before; false
/// ends with an error of kind kCancelled.
base::Result<BuiltModel> buildModel(const study::Study& study, std::span<const study::Form> forms,
                                    const BuildSettings& settings,
                                    const std::vector<ParticipantSpeeds>* clustered = nullptr,
                                    const std::function<bool(double share)>& go_on = {});

/// Whether some participant has a rule or an answer, so that a model can be built.
bool hasRules(const study::Study& study);

/// The part of buildModel that needs no rules: the terms of speed and force with their intermediate results and notes,
/// for a study without answers so far. The model has no experts, so it is not valid yet. Returns the errors of
/// buildModel for speeds and judgements.
base::Result<BuiltModel> buildTerms(const study::Study& study, const BuildSettings& settings);

/// The model of `built` with other expert weights (`settings.weights`) and everything else unchanged, with the same
/// `study` and `settings`; to be compared, so without checks. Reuses the clusters. Averages the speed terms again only
/// if the ramps are a weighted mean. Returns the error of `expertWeights`.
base::Result<fuzzy::ForceModel> reweightedModel(const BuiltModel& built, const study::Study& study,
                                                const BuildSettings& settings);

/// The model of the expert `expert_id` alone: the expert's own terms become the model's, checks are computed again,
/// accepted holes are dropped. For an unknown id returns an error with the list of experts.
base::Result<fuzzy::ForceModel> expertModel(const fuzzy::ForceModel& averaged, std::string_view expert_id);

}  // namespace tactus::elicitation
